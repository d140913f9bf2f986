#pragma once

// Result of readers of formats with several objects: one mesh for each object, in its place.

#include <array>
#include <string>
#include <vector>

#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/named_patches.hpp"

namespace hariko {

inline constexpr Code w_flat_part{"W_FLAT_PART"};  ///< an object that its transform makes flat or a point
/// Contents of a file that have a shape and are not imported: points, lines, poses.
inline constexpr Code w_left_out{"W_LEFT_OUT"};
inline constexpr Code w_objects_joined{"W_OBJECTS_JOINED"};  ///< more than `ImportedScene::max_parts` objects

/// Mesh with faces, its indices in range and its positions finite, after all transforms, z up.
struct ImportedPart {
  PolygonMesh mesh;
  std::string name;                                ///< printable UTF-8; empty where the file gives none
  std::vector<std::array<Index, 2>> creases = {};  ///< sharp edges, as pairs of vertices
  std::vector<Index> corners = {};                 ///< sharp vertices
};

/// Objects of a file. Invariant: there is at least one part or one object of patches.
struct ImportedScene {
  std::vector<ImportedPart> parts;
  std::vector<NamedPatches> patches = {};  ///< none is empty; all pass `check_patch`
  std::vector<Message> warnings;
  /// Length of the meshes' unit where the file gives it, metres: 0.001, 0.01, 0.0254 or 1.
  std::optional<double> metres_per_unit;

  /// Number of objects above which a reader joins all to one, and tells (W_OBJECTS_JOINED).
  static constexpr std::size_t max_parts = 10'000;
};

/// W_OBJECTS_JOINED about so many objects.
Message objects_joined_message(std::size_t count);
/// W_LEFT_OUT about so many faces with coordinates that are not finite.
Message not_finite_message(std::size_t count);

/// All parts (at least one) joined to one mesh with the first part's name; patches are dropped.
ImportedMesh merged(ImportedScene scene);

}  // namespace hariko

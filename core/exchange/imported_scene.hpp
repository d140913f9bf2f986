#pragma once

// What readers of formats with several objects return: one mesh for each of them, in its place.

#include <array>
#include <string>
#include <vector>

#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/named_patches.hpp"

namespace hariko {

inline constexpr Code w_flat_part{"W_FLAT_PART"};  ///< an object whose transform makes it flat or a point
/// Parts of a file that have a shape and are not imported: points, lines, poses.
inline constexpr Code w_left_out{"W_LEFT_OUT"};

/// A mesh with faces, its indices in range and its positions finite, after all transforms, z up.
struct ImportedPart {
  PolygonMesh mesh;
  std::string name;                                ///< printable UTF-8; empty when the file gives none
  std::vector<std::array<Index, 2>> creases = {};  ///< sharp edges, by their vertices
  std::vector<Index> corners = {};                 ///< sharp vertices
};

/// Invariant: there is a part, or an object of patches.
struct ImportedScene {
  std::vector<ImportedPart> parts;
  std::vector<NamedPatches> patches = {};  ///< none of them empty; all pass `check_patch`
  std::vector<Message> warnings;
  /// Length of the meshes' unit where the file says it: 0.001, 0.01, 0.0254 or 1.
  std::optional<double> metres_per_unit;

  static constexpr std::size_t max_parts = 10'000;
};

/// All parts, of which there must be one, as one mesh, with the first name; without patches.
ImportedMesh merged(ImportedScene scene);

}  // namespace hariko

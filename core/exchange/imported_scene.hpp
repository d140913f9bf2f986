#pragma once

// What readers of formats with several objects return: one mesh for each of them, in its place.

#include <string>
#include <vector>

#include "core/exchange/imported_mesh.hpp"

namespace hariko {

inline constexpr Code w_flat_part{"W_FLAT_PART"};  ///< an object whose transform makes it flat or a point
/// Parts of a file that have a shape and are not imported: points, lines, poses.
inline constexpr Code w_left_out{"W_LEFT_OUT"};

/// A mesh with faces, its indices in range and its positions finite, after all transforms, z up.
struct ImportedPart {
  PolygonMesh mesh;
  std::string name;  ///< printable UTF-8; empty when the file gives none
};

/// Invariant: there is a part.
struct ImportedScene {
  std::vector<ImportedPart> parts;
  std::vector<Message> warnings;
  /// Length of the meshes' unit where the file says it: 0.001, 0.01, 0.0254 or 1.
  std::optional<double> metres_per_unit;

  static constexpr std::size_t max_parts = 10'000;
};

/// All parts as one mesh, with the first name.
ImportedMesh merged(ImportedScene scene);

}  // namespace hariko

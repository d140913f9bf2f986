#pragma once

// Cleaning of imported meshes before they become objects: coincident corners are joined, degenerate triangles
// dropped.

#include <optional>
#include <vector>

#include "core/exchange/imported_scene.hpp"
#include "core/polyhedron/join_corners.hpp"

namespace hariko {

inline constexpr Code w_corners_joined{"W_CORNERS_JOINED"};
inline constexpr Code w_near_corners{"W_NEAR_CORNERS"};
inline constexpr Code w_flat_triangles{"W_FLAT_TRIANGLES"};
inline constexpr Code w_keyholes{"W_KEYHOLES"};          ///< faces with holes that were cut
inline constexpr Code w_bodies_apart{"W_BODIES_APART"};  ///< bodies that touch in common corners of the file
inline constexpr Code w_t_joints{"W_T_JOINTS"};

/// Corners to join. Corners at bit-identical positions always are; with `near` also those within `distance`
/// in the file's numbers, or within each mesh's `joining_distance` where it is not given.
struct JoinChoice {
  bool near = false;
  std::optional<double> distance = {};
  bool split_edges = false;  ///< splits edges on which corners of other faces lie (T-joints)
  friend bool operator==(const JoinChoice&, const JoinChoice&) = default;
};

/// Repairs of all meshes of a file together, made and possible.
struct CleanReport {
  std::size_t meshes = 0;       ///< meshes that were cleaned
  std::size_t joined = 0;       ///< corners that were joined
  std::size_t near_joined = 0;  ///< joined corners whose positions differed
  double farthest = 0;          ///< largest distance that a corner was moved
  std::size_t near = 0;         ///< corners that lie near others and were not joined
  double near_farthest = 0;     ///< largest distance between such corners
  double tolerance = 0;         ///< largest tolerance that was used, or would be
  bool loose = false;           ///< it is that of a mesh whose faces are all loose, and not each mesh's own
  std::size_t collapsed = 0;    ///< faces that had several corners at one place
  std::size_t flat = 0;         ///< triangles whose corners lie on one line
  std::size_t keyholes = 0;     ///< faces with a hole that were cut into faces without
  std::size_t apart = 0;        ///< corners that were doubled where bodies touch
  std::size_t on_edges = 0;     ///< corners on edges of other faces, which were not split
  std::size_t split_edges = 0;  ///< such corners whose edges were split

  /// Warnings W_CORNERS_JOINED, W_NEAR_CORNERS, W_DEGENERATE_TRIANGLES, W_FLAT_TRIANGLES, W_KEYHOLES,
  /// W_BODIES_APART and W_T_JOINTS, as far as they apply.
  std::vector<Message> messages() const;
};

/// Cleans a part, renumbers its creases and corners, and adds to the report. O(corners) expected.
void clean(ImportedPart& part, const JoinChoice& choice, CleanReport& report);

}  // namespace hariko

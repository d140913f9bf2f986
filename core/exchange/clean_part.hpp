#pragma once

// Tidying of every mesh of a file before it becomes an object: corners are joined, and triangles without
// area are dropped.

#include <optional>
#include <vector>

#include "core/exchange/imported_scene.hpp"
#include "core/polyhedron/join_corners.hpp"

namespace hariko {

inline constexpr Code w_corners_joined{"W_CORNERS_JOINED"};
inline constexpr Code w_near_corners{"W_NEAR_CORNERS"};
inline constexpr Code w_flat_triangles{"W_FLAT_TRIANGLES"};

/// Corners at the same place, bit for bit, are joined always. `near`: those nearly so, too, up to `distance`
/// in the file's numbers, or 1e-6 of each mesh's size where it is not given.
struct JoinChoice {
  bool near = false;
  std::optional<double> distance = {};
  friend bool operator==(const JoinChoice&, const JoinChoice&) = default;
};

/// Repairs of all meshes of a file together, done and possible.
struct CleanReport {
  std::size_t joined = 0;       ///< corners
  std::size_t near_joined = 0;  ///< of them, those that were not at the same place
  double farthest = 0;          ///< that one of them was moved
  std::size_t near = 0;         ///< corners that are nearly at the same place as others, and were not joined
  double near_farthest = 0;     ///< that they are apart
  double tolerance = 0;         ///< largest that was used, or would be
  std::size_t collapsed = 0;    ///< faces that had corners at one place
  std::size_t flat = 0;         ///< triangles along an edge

  /// W_CORNERS_JOINED, W_NEAR_CORNERS, W_DEGENERATE_TRIANGLES and W_FLAT_TRIANGLES, as far as there is
  /// something to tell.
  std::vector<Message> messages() const;
};

/// Cleans a part, whose creases and corners go along, and adds to the report. O(corners) expected.
void clean(ImportedPart& part, const JoinChoice& choice, CleanReport& report);

}  // namespace hariko

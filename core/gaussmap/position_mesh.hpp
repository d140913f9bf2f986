#pragma once

// A mesh between loops that does not need the Gauss map: for the mode position (gaussmap.md 4). Internal to
// core/gaussmap.

#include <array>

#include "core/gaussmap/outline_check.hpp"

namespace hariko {

inline constexpr Code e_no_layout{"E_NO_LAYOUT"};

/// Triangles counter-clockwise from outside over the outline's points, by their numbers, and inner vertices
/// after them, each with a first guess of its position.
struct PositionMesh {
  std::vector<Vector3> points;
  Index boundary_count = 0;
  std::vector<Index> next;  ///< of each boundary vertex
  std::vector<std::array<Index, 3>> triangles;
  bool limited = false;  ///< the largest number of points ended it, not the radius
  bool in_rows = false;  ///< a strip, whose vertices stand in rows, evenly
};

/// One loop: a disc over the loop's projection along its mean normal, or over a circle where that crosses
/// itself. Two loops: a strip between them. More: the domain between their projections. `radius` as in
/// `GaussOptions`, in mean edge lengths. Errors: E_NO_LAYOUT (the projections cross or do not lie in each
/// other), E_BOUNDARY_EDGE.
Result<PositionMesh> position_mesh(const Outline& outline, double radius, Index most_points);

}  // namespace hariko

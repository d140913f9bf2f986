#pragma once

// PositionMesh: a mesh between loops that needs no Gauss map, for mode position (gaussmap.md 4). Internal to
// core/gaussmap.

#include <array>

#include "core/gaussmap/outlines/outline_check.hpp"

namespace hariko {

inline constexpr Code e_no_layout{"E_NO_LAYOUT"};

/// Triangles counter-clockwise seen from outside over the outline's points, by their numbers, followed by
/// inner vertices with an initial guess of their positions.
struct PositionMesh {
  std::vector<Vector3> points;
  Index boundary_count = 0;
  std::vector<Index> next;  ///< next vertex of the loop, for each boundary vertex
  std::vector<std::array<Index, 3>> triangles;
  bool limited = false;  ///< ended at the largest number of points, not at the radius
  bool in_rows = false;  ///< a strip, whose vertices stand evenly in rows
};

/// Makes the mesh. One loop: a disc over the loop's projection along its mean normal, or over a circle where
/// the projection crosses itself. Two loops: a strip between them. More: the domain between their
/// projections. `radius` as in `GaussOptions`, in mean edge lengths. Errors: E_NO_LAYOUT (the projections
/// cross or are not nested), E_BOUNDARY_EDGE.
Result<PositionMesh> position_mesh(const Outline& outline, double radius, Index most_points);

}  // namespace hariko

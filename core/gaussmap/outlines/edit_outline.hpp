#pragma once

// Edits of outlines as pure functions. Points are given by their numbers through all loops, which must be in
// range (asserted).

#include <set>
#include <span>

#include "core/gaussmap/outlines/resample_loop.hpp"

namespace hariko {

/// Number of a loop's first point.
Index first_number(const Outline& outline, std::size_t loop);

/// Moves points. Where the direction of the loop changes, at the points and beside them, the normals rotate
/// with it. O(points).
Outline with_points(const Outline& outline, std::span<const Index> numbers, std::span<const Vector3> points);

/// Sets normals of points; they must not be zero.
Outline with_normals(const Outline& outline, std::span<const Index> numbers,
                     std::span<const Vector3> normals);

/// Rotates normals about the loop, away from the surface for positive `radians`.
Outline tilted(const Outline& outline, const std::set<Index>& numbers, double radians);

/// Interpolates the normals of the given points along their loops (`spread_normals`); loops without any stay.
Outline with_spread_normals(const Outline& outline, const std::set<Index>& given);

/// Reverses all normals and loops, so that the surface lies on the same side with the opposite orientation.
Outline turned_inside_out(const Outline& outline);

/// Resamples every loop to `count` points. Errors: those of `resample_loop`; elements are points of the
/// outline.
Result<Outline> resampled(const Outline& outline, std::size_t count, LoopMeasure measure);

/// Inserts a point after a point. Errors: those of `unusable`.
Result<Outline> with_point_after(const Outline& outline, Index number);

/// Removes points; loops with fewer than four points left are removed too. Error: E_TOO_FEW when none would
/// be left.
Result<Outline> without_points(const Outline& outline, const std::set<Index>& numbers);

/// Adds a loop; curvature of all loops is dropped unless all have it.
Outline with_loop(const Outline& outline, OutlineLoop loop);

/// Arc length along the loops from each point to the nearest point of a set; infinity in loops without any.
/// O(points).
std::vector<double> distances_along(const Outline& outline, const std::set<Index>& from);

/// All points of the loops that contain some of the given ones.
std::set<Index> whole_loops(const Outline& outline, const std::set<Index>& numbers);

}  // namespace hariko

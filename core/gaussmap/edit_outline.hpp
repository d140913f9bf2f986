#pragma once

// Edits of outlines as pure functions. Points are named by their numbers through all loops, which are in
// range (asserted).

#include <set>
#include <span>

#include "core/gaussmap/resample_loop.hpp"

namespace hariko {

/// The number of a loop's first point.
Index first_number(const Outline& outline, std::size_t loop);

/// Points put elsewhere. Where the direction of the loop turns by that, at the points and beside them, the
/// normals turn along. O(points).
Outline with_points(const Outline& outline, std::span<const Index> numbers, std::span<const Vector3> points);

/// Points with other normals, not zero.
Outline with_normals(const Outline& outline, std::span<const Index> numbers,
                     std::span<const Vector3> normals);

/// Normals turned about the loop, away from the surface where `radians` is positive.
Outline tilted(const Outline& outline, const std::set<Index>& numbers, double radians);

/// The normals of the given points spread along their loops (`spread_normals`); loops without any stay.
Outline with_spread_normals(const Outline& outline, const std::set<Index>& given);

/// All normals turned round, and loops reversed, so that the surface lies on the same side with its other
/// side out.
Outline turned_inside_out(const Outline& outline);

/// Every loop resampled to `count` points. Errors: those of `resample_loop`; elements are points of the
/// outline.
Result<Outline> resampled(const Outline& outline, std::size_t count, LoopMeasure measure);

/// One more point after a point. Errors: those of `unusable`.
Result<Outline> with_point_after(const Outline& outline, Index number);

/// Loops with less than four points left go altogether. Error: E_TOO_FEW when none would be left.
Result<Outline> without_points(const Outline& outline, const std::set<Index>& numbers);

/// The outline with another loop; curvature of all loops is dropped unless all have it.
Outline with_loop(const Outline& outline, OutlineLoop loop);

/// Length along the loops from each point to the nearest of some; infinite in loops without any. O(points).
std::vector<double> distances_along(const Outline& outline, const std::set<Index>& from);

/// The points of whole loops that hold some of the given ones.
std::set<Index> whole_loops(const Outline& outline, const std::set<Index>& numbers);

}  // namespace hariko

#pragma once

// Chart polygon: the domain of a face in mode G2 (g2.md section 4).

#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/g2/faces/face_chart.hpp"

namespace hariko {

/// Regular polygon of unit side around 0, counter-clockwise, its first corner on the x axis.
std::vector<Vector2> regular_chart_polygon(int sides);

/// Polygon nearest to a face's own chart that corners can be mapped from: `face`, counter-clockwise around 0,
/// under the affine map that makes its moments of inertia equal in all directions and its mean side 1 (by
/// length), so that parallelograms become the square. Continuous in `face` and `corners`. Drawn toward the
/// regular polygon as far as it is not convex, or turns far less in a corner than the corner's vertex does.
/// Corners that are straight in their vertices lie on the line between the corners beside them. O(sides)
/// where all corners turn, else O(sides^3).
std::vector<Vector2> chart_polygon(std::span<const Vector2> face, std::span<const CornerShape> corners);

/// Angle of the linear map of a corner of a chart, in (0, pi): the vertex's own, or, by measure and where the
/// corner hardly turns in its vertex, that of the polygon. From there the map turns about the corner, every
/// direction in proportion to its angle: where one of two angles is nearly a half turn, a linear map between
/// them would press the face to a fraction of its width.
double linear_angle(const CornerShape& corner, const Vector2& at, const Vector2& next,
                    const Vector2& previous);

}  // namespace hariko

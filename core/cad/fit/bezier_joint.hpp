#pragma once

// Joints of neighbouring Bezier patches that are pieces of one B-spline.

#include <optional>

#include "core/surface/bezier_patch.hpp"

namespace hariko {

/// Width, across the joint, of the second of two polynomial patches of degree p by p that are pieces of one
/// spline with a simple knot between them (p - 1 continuous derivatives, to `tolerance`, a length, at the
/// control points); the first patch is 1 wide. They meet along `first_side` and `second_side`, which run
/// against each other. Nothing where they are not such pieces. Ratios of small whole numbers are returned
/// exactly. Asserts that both patches are polynomial and of one degree. O(p^3).
std::optional<double> spline_joint(const BezierPatch& first, int first_side, const BezierPatch& second,
                                   int second_side, double tolerance);

/// Whether the boundary curve along a side of a polynomial patch of degree p by p continues
/// (counter-clockwise) as the same polynomial along a side of another one, whose parameter interval is
/// `ratio` times as long; to `tolerance`, a length, at the control points. O(p^2).
bool one_polynomial(const BezierPatch& first, int first_side, const BezierPatch& second, int second_side,
                    double ratio, double tolerance);

}  // namespace hariko

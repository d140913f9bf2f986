#pragma once

// Bezier patches that are neighbouring pieces of one spline.

#include <optional>

#include "core/surface/bezier_patch.hpp"

namespace hariko {

/// Two polynomial patches of degree p by p meet along side `first_side` of the first and `second_side` of the
/// second, which run against each other. Where they are pieces of one spline with a simple knot between them
/// (p - 1 continuous derivatives, to `tolerance` of the control points): the width of the second patch across
/// the side where the first is 1 wide. Simple fractions are given exactly.
std::optional<double> spline_joint(const BezierPatch& first, int first_side, const BezierPatch& second,
                                   int second_side, double tolerance);

/// The curve along a side of a polynomial patch of degree p by p goes on (counter-clockwise) along a side of
/// another one, `ratio` times as long in its parameter, as the same polynomial, to `tolerance` of the control
/// points.
bool one_polynomial(const BezierPatch& first, int first_side, const BezierPatch& second, int second_side,
                    double ratio, double tolerance);

}  // namespace hariko

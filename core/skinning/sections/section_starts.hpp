#pragma once

// Start parameters of closed sections that bring neighbouring sections as near to each other as possible.

#include <vector>

#include "core/subdivision/subdivision_curve.hpp"

namespace hariko {

/// Best match of two closed curves over the start of the second.
struct StartMatch {
  double start = 0;         ///< parameter of the second curve that corresponds to 0 of the first, -1/2 .. 1/2
  double displacement = 0;  ///< mean squared distance at equal parameters, of the centred curves
  double stiffness = 0;     ///< second derivative of the displacement with respect to the start, at least 0
  double size = 0;          ///< geometric mean of the curves' mean squares, the unit of the two above
};

/// Start with the least displacement, over all parameters of `second`, not only those of points. The position
/// of the curves does not matter: they are compared relative to their means. Among equally good starts
/// (regular polygons, circles of zero size) the nearest to 0 is taken. O(samples^2), samples about four per
/// span.
StartMatch nearest_start(const SubdivisionCurve& first, const SubdivisionCurve& second);

/// Reversed curve; its first point stays the first.
SubdivisionCurve reversed(const SubdivisionCurve& curve);

/// Accumulates the starts of the strips to starts of all sections (corresponding parameters, that of the
/// first is 0). On a closed path the last section meets the first: the remainder to whole turns is
/// distributed among the strips that are `free`, most to those of least stiffness.
std::vector<double> chained_starts(const std::vector<StartMatch>& strips, const std::vector<char>& free,
                                   bool closed_path);

}  // namespace hariko

#pragma once

// ExactForm: a patch as control points or in other exact terms, for those who use surfaces without knowing
// who made them.

#include <array>
#include <span>
#include <variant>
#include <vector>

#include "core/surface/bezier_patch.hpp"

namespace hariko {

enum class Order;
struct PatchPoint;

/// Bicubic Bezier patch of a grid with even knots. Control point (i, j) is controls[4 j + i].
struct BicubicPatch {
  std::array<Vector3, 16> controls;
};

/// Patch of a Catmull-Clark surface: bicubic, one span of a spline with even knots, or an endless row of such
/// round an extraordinary vertex.
struct SubdivisionPatch {
  bool bicubic = false;
};

/// Quartic Bezier triangle whose inner control points are pairs, between which they are blended by rational
/// weights (Kuriyama 1991). It is an ordinary quartic where both points of every pair coincide.
struct PairedQuartic {
  std::span<const Vector3> controls;  ///< valid as long as the patch set
  double pair_distance = 0;           ///< largest distance between the points of a pair
};

/// Evaluation of faces whose patches have coordinates in common, as those of mode G2. Thread-safe.
class ChartEvaluation {
 public:
  virtual ~ChartEvaluation() = default;
  /// Corners of the polygon of a face.
  virtual const std::vector<Vector2>& polygon(Index face) const = 0;
  /// Point of a face by the coordinates of its polygon, with derivatives by them; anywhere in the polygon.
  virtual PatchPoint evaluate_chart(Index face, const Vector2& point, Order order) const = 0;
  /// Bezier points of the cross derivative along the patch's outer side, which must be cubic: without freedom
  /// of its own, and without departure.
  virtual std::array<Vector3, 4> side_cross_derivative(Index patch) const = 0;
};

/// Patch that is the triangle (middle, corner `side`, next corner) of a face's polygon, with the controls of
/// the whole face. `controls` and `charts` are valid as long as the patch set.
struct ChartPatch {
  const ChartEvaluation* charts = nullptr;
  Index face = no_index;
  int side = 0;
  std::span<const Vector3> controls;
  std::size_t vectors = 0;  ///< number of the first controls that are derivatives and not points
};

/// Exact form of a patch.
using ExactForm =
    std::variant<std::monostate, BezierPatch, BicubicPatch, SubdivisionPatch, PairedQuartic, ChartPatch>;

}  // namespace hariko

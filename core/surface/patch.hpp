#pragma once

// Patches: parameter domains, evaluated points, and sets of patches of one type.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/surface/exact_form.hpp"

namespace hariko {

/// Parameter domain of a patch. A triangle has parameters s, t >= 0, s + t <= 1 and corners (0,0), (1,0),
/// (0,1); with the barycentric (u, v, w) of the papers: s = v, t = w, u = 1 - s - t. A square has 0 <= s, t
/// <= 1 and corners (0,0), (1,0), (1,1), (0,1). Corners and sides are numbered counter-clockwise; side i runs
/// from corner i to corner i + 1.
enum class Domain : std::uint8_t { triangle, square };

inline int corner_count(Domain domain) {
  return domain == Domain::triangle ? 3 : 4;
}
/// Parameter of a corner, 0 .. corner_count - 1.
Vector2 corner_parameter(Domain domain, int corner);
/// Parameter of the centre.
Vector2 centre_parameter(Domain domain);
/// Parameter of the point at fraction x in [0, 1] along a side.
Vector2 side_parameter(Domain domain, int side, double x);

/// Symmetric fraction i / density, to within 1.2e-16: grid_fraction(i, n) + grid_fraction(n - i, n) is 1 and
/// one minus the one is the other, bit for bit, so that both sides of a seam evaluate the same point of their
/// common curve. 0 <= i <= density.
double grid_fraction(int i, int density);

/// Position and derivatives with respect to (s, t), at one point of a patch.
struct PatchPoint {
  Vector3 position = Vector3::Zero(), ds = Vector3::Zero(), dt = Vector3::Zero();
  /// Second derivatives; zero when only first order was requested.
  Vector3 dss = Vector3::Zero(), dst = Vector3::Zero(), dtt = Vector3::Zero();
};

enum class Order { first, second };

/// Meaning of second derivatives at a patch's corner (statistics skip corners where they are not exact, maps
/// take limits).
enum class CornerSecondOrder : std::uint8_t { exact, direction_dependent, undefined };

/// Uniform triangular (or square) grid with n >= 1 intervals per side, in a fixed order. Triangle: for j =
/// 0..n, i = 0..n-j: s = i/n, t = j/n (by `grid_fraction`; s + t is exactly 1 on side 1). Square: for j =
/// 0..n, i = 0..n.
struct GridPattern {
  Domain domain;
  int density;
  int point_count() const {
    return domain == Domain::triangle ? (density + 1) * (density + 2) / 2 : (density + 1) * (density + 1);
  }
  /// Index of grid point (i, j).
  int index(int i, int j) const {
    return domain == Domain::triangle ? j * (density + 1) - j * (j - 1) / 2 + i : j * (density + 1) + i;
  }
  /// Parameters of all points, in order.
  std::vector<Vector2> parameters() const;
  /// Triangles of the grid as point indices, counter-clockwise.
  std::vector<std::array<int, 3>> triangles() const;
  /// Indices of the density + 1 points along a side, from its first corner to its last.
  std::vector<int> side(int side) const;
};

/// Parameters of the corners of a triangle within one patch's domain.
using ParameterTriangle = std::array<Vector2, 3>;

/// Ball of a bound.
struct HullBall {
  Vector3 centre = Vector3::Zero();
  double radius = 0;
};

/// Parameter at barycentric coordinates 1 - a - b, a, b.
inline Vector2 at_barycentric(const ParameterTriangle& triangle, double a, double b) {
  return triangle[0] + a * (triangle[1] - triangle[0]) + b * (triangle[2] - triangle[0]);
}

/// Evaluation of one list of parameters on many patches of a set; made by `PatchSet::batch`.
class BatchEvaluation {
 public:
  virtual ~BatchEvaluation() = default;
  /// Evaluates all parameters: points[k * n + i] is the point of patches[k] at parameter i of n, equal to
  /// `PatchSet::evaluate` within rounding; positions on sides are equal bit for bit. Thread-safe.
  virtual void evaluate(std::span<const Index> patches, Order order, std::span<PatchPoint> points) const = 0;
};

/// Set of patches of one type, immutable. Implementations are values behind a shared pointer; all calls are
/// thread-safe.
class PatchSet {
 public:
  virtual ~PatchSet() = default;
  virtual Domain domain() const = 0;
  virtual Index patch_count() const = 0;

  /// Point at any parameter of the domain. Points on a side depend, bit for bit, only on that side's curve
  /// and on min(x, 1-x)-symmetric arithmetic, so two patches that share a curve agree exactly.
  virtual PatchPoint evaluate(Index patch, const Vector2& parameter, Order order) const = 0;

  /// Evaluates all points of a grid for each of `patches`: positions[k * n + i] and unit outward normals for
  /// point i of patches[k], n = pattern.point_count(). Positions on sides as in `evaluate`, normals as in
  /// `normal_at`. This is the fast path of sets that have one.
  virtual void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                             std::span<Vector3> positions, std::span<Vector3> normals) const;
  /// Evaluates the same points with first and second derivatives.
  virtual void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                             std::span<PatchPoint> points) const;
  /// Kind of second derivatives at a corner: exact, except undefined where a side shrinks to the corner.
  virtual CornerSecondOrder second_order_at_corner(Index patch, int corner) const;

  /// Batch evaluation of a list of parameters on many patches: a set whose patches share basis functions
  /// tabulates them here, once. The result must not outlive the set.
  virtual std::unique_ptr<const BatchEvaluation> batch(std::vector<Vector2> parameters) const;

  /// Unit normal at a point of a patch; where it has none, the inner one. Zero if both fail.
  Vector3 normal_at(Index patch, const Vector2& parameter, const PatchPoint& point) const;
  /// Unit normal 1e-4 of the way from a parameter to the centre of the domain.
  Vector3 inner_normal(Index patch, const Vector2& parameter) const;

  /// Positions for meshing, one per parameter: those of `evaluate` to rounding, without a virtual call each
  /// where the set has a faster way.
  virtual void positions(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const;
  /// Positions and first derivatives, one per parameter, likewise.
  virtual void first_order(Index patch, std::span<const Vector2> parameters, std::span<PatchPoint> out) const;

  /// Degree n >= 1 for which `hull` gives (n + 1)(n + 2) / 2 balls, 0 where the patch has no bound.
  virtual int hull_degree(Index) const { return 0; }
  /// Certain bound of a patch with a hull degree over a triangle: balls whose convex hull contains it. They
  /// are in the order of GridPattern{triangle, n}, and those of a side of that grid bound the curve over that
  /// side of the triangle. `samples` are the patch's positions at that grid. The bound converges with the
  /// square of the triangle's size.
  virtual void hull(Index patch, const ParameterTriangle& triangle, std::span<const Vector3> samples,
                    std::span<HullBall> out) const;

  /// Exact form of a patch; nothing where it has none that others can use. All patches of a set have forms of
  /// one alternative.
  virtual ExactForm exact_form(Index) const { return {}; }
};

/// Unit vector along ds x dt; zero where one is zero or both are parallel to within 1e-12 of the product of
/// their lengths.
Vector3 unit_normal(const PatchPoint& point);

}  // namespace hariko

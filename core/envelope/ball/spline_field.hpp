#pragma once

// SplineField: a scalar field with continuous second derivatives, as a tricubic B-spline.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Number of nodes of a lattice, given the numbers along its axes.
inline std::size_t node_count(const std::array<int, 3>& size) {
  return std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
}
/// Number of a node in lists of all of them, where x runs fastest.
inline std::size_t node_index(const std::array<int, 3>& size, int i, int j, int k) {
  return (std::size_t(k) * std::size_t(size[1]) + std::size_t(j)) * std::size_t(size[0]) + std::size_t(i);
}

struct FieldPoint {
  double value = 0;
  Vector3 gradient = Vector3::Zero();
};

/// Value, gradient and second derivatives at a point.
struct BentFieldPoint : FieldPoint {
  Matrix3 hessian = Matrix3::Zero();
};

/// Tricubic B-spline over a regular lattice of nodes.
class SplineField {
 public:
  SplineField() = default;
  /// Makes the field. Node (i, j, k) lies at `corner` + spacing (i, j, k); x runs fastest. `weights` are the
  /// coefficients.
  SplineField(const Vector3& corner, double spacing, std::array<int, 3> size, std::vector<double> weights)
      : corner_(corner), spacing_(spacing), size_(size), weights_(std::move(weights)) {}

  /// Value at a point; outside the lattice the boundary values continue.
  double value(const Vector3& point) const;
  FieldPoint at(const Vector3& point) const;
  BentFieldPoint bent_at(const Vector3& point) const;

  /// Lowers the coefficients near a point, by `by` there, decreasing to zero at distance `radius`.
  void lower(const Vector3& at, double by, double radius);

  /// Calls each(number, position) for the nodes within the cube about a point that has the ball of `radius`.
  template <class Each>
  void for_nodes_about(const Vector3& at, double radius, const Each& each) const {
    std::array<int, 3> first, last;
    for (std::size_t a = 0; a < 3; ++a) {
      const double middle = (at[Eigen::Index(a)] - corner_[Eigen::Index(a)]) / spacing_;
      first[a] = std::max(int(std::ceil(middle - radius / spacing_)), 0);
      last[a] = std::min(int(std::floor(middle + radius / spacing_)), size_[a] - 1);
    }
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i)
          each(node_index(size_, i, j, k), Vector3(corner_ + spacing_ * Vector3(i, j, k)));
  }

  /// Coefficient of a node.
  double weight(int i, int j, int k) const { return weights_[node_index(size_, i, j, k)]; }
  const Vector3& corner() const { return corner_; }
  double spacing() const { return spacing_; }
  const std::array<int, 3>& size() const { return size_; }

 private:
  /// Sum over the coefficients near a point, still open along x; `share`: place in the cell, 0 .. 1 along
  /// each axis.
  template <class Sum>
  Sum sum(const Vector3& point, std::array<double, 3>& share) const;

  Vector3 corner_ = Vector3::Zero();
  double spacing_ = 1;
  std::array<int, 3> size_{};
  std::vector<double> weights_;
};

/// Applies (1 2 1) / 4 along each axis to values at the nodes of a lattice, x fastest, with the same sums in
/// either direction; values continue at the ends. O(nodes).
void smooth_lattice(const std::array<int, 3>& size, std::vector<double>& values);

/// Replaces the values of a node and of its mirror image along an axis of the lattice by the larger of both.
/// O(nodes).
void even_lattice(const std::array<int, 3>& size, std::size_t axis, std::vector<double>& values);

/// Curvature of the level surface through a point in tangent directions; negative where it is convex.
struct LevelCurvature {
  Vector3 normal = Vector3::UnitZ();  ///< unit, outwards
  Matrix3 form = Matrix3::Zero();     ///< curvature form -H / |gradient|
  double slope = 1;                   ///< length of the gradient
  double along(const Vector3& a) const { return a.dot(form * a); }
};
/// Curvature of the level surface at a point where the gradient does not vanish. O(1).
LevelCurvature level_curvature(const SplineField& field, const Vector3& point);

/// Point on the zero surface, by Newton steps along the gradient, none longer than `longest`.
Vector3 projected(const SplineField& field, Vector3 point, int steps, double longest);

/// Lowers the field near its saddles that lie within a tenth of `sigma` of zero, to 0.1 `sigma` below it:
/// there, at necks and holes about to open, the surface has hardly any slope, and its curvature would be
/// unbounded. A thinner neck is kept or absent, a narrower hole is closed. The field is only lowered, so that
/// no inside point becomes outside. `mirror`: the plane perpendicular to this axis, at `plane` from the
/// field's origin, is a symmetry plane. Returns the number of saddles. O(nodes).
std::size_t close_pinches(SplineField& field, double sigma, std::optional<Eigen::Index> mirror = {},
                          double plane = 0);

}  // namespace hariko

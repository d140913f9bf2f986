#pragma once

// SplineField: a scalar field with continuous second derivatives, as a tricubic B-spline.

#include <array>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

struct FieldPoint {
  double value = 0;
  Vector3 gradient = Vector3::Zero();
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
  Matrix3 hessian(const Vector3& point) const;

  /// Lowers the coefficients near a point, by `by` there, decreasing to zero at distance `radius`.
  void lower(const Vector3& at, double by, double radius);

  /// Coefficient of a node.
  double weight(int i, int j, int k) const { return weights_[index(i, j, k)]; }
  /// Number of a node among the coefficients.
  std::size_t index(int i, int j, int k) const {
    return (std::size_t(k) * std::size_t(size_[1]) + std::size_t(j)) * std::size_t(size_[0]) + std::size_t(i);
  }
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

}  // namespace hariko

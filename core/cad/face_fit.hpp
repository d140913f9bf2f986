#pragma once

// A spline surface of few control points near a given one, with its boundary given and tied to tangent planes
// along its sides.

#include <array>
#include <functional>
#include <memory>

#include "core/base/banded_cholesky.hpp"
#include "core/cad/curve_fit.hpp"

namespace hariko {

/// Not where both derivatives are parallel, or nearly: there rounding decides about the normal.
bool has_normal(const PatchPoint& point);

/// Coefficient of the control points beside a side in the derivative across it, by s or t; those on the side
/// have the negative one.
double inner_slope(const SplineSpace& across, bool at_end);

/// A tangent plane that a face is tied to in a place of a side.
struct SidePlace {
  double at = 0;                     ///< by s or t
  double weight = 0;                 ///< part of the side
  Vector3 normal = Vector3::Zero();  ///< unit, perpendicular to the boundary
  /// Parts of the surface's derivative by t or s across the side: the part in the plane and perpendicular to
  /// the boundary.
  double speed = 0;
  Vector3 across = Vector3::Zero();  ///< that derivative, which the face keeps nearly
  double turn = 0;  ///< by which the face is to be turned against the plane, about the boundary, radians
};

/// How many times the limits a face misses the surface, and spans that finer knots would help.
struct FaceMiss {
  double worst = 0;
  std::vector<char> s, t;
};

class FaceFit {
 public:
  using Model = std::function<PatchPoint(double, double)>;
  /// `boundary`: control points of the sides in the direction of growing s or t.
  FaceFit(Model model, SplineSpace s, SplineSpace t, std::array<std::vector<Vector3>, 4> boundary);

  const SplineSurface& surface() const { return surface_; }
  void set_side(int side, std::vector<SidePlace> places);
  /// Least squares of what is off by the limits; before that all points inside are zero.
  void solve(const FitLimits& limits);
  /// Takes the points of the surface that lie under those of the fit, so that the next `solve` is free to run
  /// along the surface.
  void slide();
  /// Frees what `solve` keeps for the next time.
  void forget();
  FaceMiss miss(const FitLimits& limits) const;

 private:
  struct Direction {
    std::vector<double> at, weight;  ///< weights add up to 1
    std::vector<std::size_t> span;
    std::vector<SplineBasis> basis;
  };
  static Direction direction(const SplineSpace& space);
  const PatchPoint& sample(std::size_t i, std::size_t j) const { return samples_[j * s_.at.size() + i]; }
  PatchPoint fitted(std::size_t i, std::size_t j) const;
  std::size_t unknown(std::size_t i, std::size_t j) const;
  void assemble(const FitLimits& limits);
  static std::pair<std::size_t, std::size_t> samples_of(const Direction& direction, std::size_t span);
  void add_rectangle(std::size_t column, std::size_t row, double weight);
  void add_block(std::size_t a, std::size_t b, double factor, const Matrix3& block);
  template <class Each>
  void for_side(int side, const SidePlace& place, const Each& each) const;
  void add_side(int side, const SidePlace& place, double weight);
  static Matrix3 side_metric(const SidePlace& place);
  std::vector<double> residual(const SplineSpace& space, const Direction& own, bool by_s) const;

  Model model_;
  SplineSurface surface_;
  Direction s_, t_;
  std::vector<Vector2> places_;  ///< by s and t, of the samples
  std::vector<Vector3> misses_;  ///< of the boundary, at the samples, in the surface's frames
  std::vector<PatchPoint> samples_;
  std::vector<Vector3> targets_;  ///< the samples' positions, brought to the boundary
  std::array<std::vector<SidePlace>, 4> sides_;
  std::size_t inner_s_, inner_t_;
  std::unique_ptr<BandedCholesky> matrix_;
  std::vector<double> right_;
};

/// The spline of given spaces that has the surface's values at the Greville places inside, and the boundary.
SplineSurface interpolated(const SplineSpace& s, const SplineSpace& t, const FaceFit::Model& model,
                           const std::array<std::vector<Vector3>, 4>& boundary);

}  // namespace hariko

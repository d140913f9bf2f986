#pragma once

// A spline surface of few control points near a given one, with its boundary given and tied to tangent planes
// along its sides.

#include <array>
#include <functional>
#include <memory>
#include <span>

#include "core/base/banded_cholesky.hpp"
#include "core/cad/curve_fit.hpp"
#include "core/cad/side_tie.hpp"

namespace hariko {

/// A number of a face that is to have a wanted value.
struct FaceTie {
  SideTie tie;
  double weight = 0;               ///< of the square of what it misses
  Vector3 rest = Vector3::Zero();  ///< the sum whose component the tie is, without that: kept nearly
  double wanted = 0;
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
  /// For the next `solve`.
  void set_ties(std::vector<FaceTie> ties);
  /// Other wanted values of the same ties.
  void want(std::span<const double> values);
  /// Least squares of what is off by the limits, with as much on one side of the surface as on the other:
  /// what is between them has no volume. Before that all points inside are zero.
  void solve(const FitLimits& limits);
  /// Takes the points of the surface that lie under those of the fit, so that the next `solve` is free to run
  /// along the surface.
  void slide();
  /// Against the surface itself.
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
  bool is_free(const PointShare& share) const {
    return share.i > 0 && share.i <= inner_s_ && share.j > 0 && share.j <= inner_t_;
  }
  void add_tie(const FaceTie& tie);
  void add_volume();
  std::vector<double> residual(const SplineSpace& space, const Direction& own, bool by_s) const;

  Model model_;
  SplineSurface surface_;
  Direction s_, t_;
  std::vector<Vector2> places_;  ///< by s and t, of the samples
  std::vector<Vector3> misses_;  ///< of the boundary, at the samples, in the surface's frames
  std::vector<PatchPoint> samples_;
  std::vector<Vector3> targets_;  ///< the samples' positions, brought to the boundary
  std::vector<Vector3> areas_;    ///< along the normals, of the samples' parts
  std::vector<FaceTie> ties_;
  std::size_t inner_s_, inner_t_;
  std::unique_ptr<BandedCholesky> matrix_;
  std::vector<double> right_;
  std::vector<double> volume_, volume_move_;  ///< derivative of the volume, and what changes it at least cost
  double volume_wanted_ = 0;
};

/// The spline of given spaces that has the surface's values at the Greville places inside, and the boundary.
SplineSurface interpolated(const SplineSpace& s, const SplineSpace& t, const FaceFit::Model& model,
                           const std::array<std::vector<Vector3>, 4>& boundary);

}  // namespace hariko

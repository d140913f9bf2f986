#pragma once

// A spline surface of few control points near a given one, with its boundary given and tied to tangent planes
// along its sides.

#include <array>
#include <span>

#include "core/cad/curve_fit.hpp"
#include "core/cad/inner_fit.hpp"

namespace hariko {

/// How many times the limits a face misses the surface, and spans that finer knots would help.
struct FaceMiss {
  double worst = 0;
  std::vector<char> s, t;
};

/// Control points of the sides 0, 1, 2, 3 in the direction of growing s or t.
using FaceBoundary = std::array<std::vector<Vector3>, 4>;

class FaceFit {
 public:
  /// `surface` must outlive this. `before`: a fit of the same surface with less knots, if there is one, whose
  /// points are not asked for again.
  FaceFit(const PieceEvaluator& surface, SplineSpace s, SplineSpace t, FaceBoundary boundary,
          const FitLimits& limits, const FaceFit* before = nullptr);

  const SplineSurface& surface() const { return surface_; }
  /// For the next solution.
  void set_ties(std::span<const FaceTie> ties) { inner_.tie(ties, outer_); }
  /// Other wanted values of the same ties.
  void want(std::span<const double> values) { inner_.want(values); }
  /// Least squares of what is off by the limits, with as much on one side of the surface as on the other:
  /// what is between them has no volume. Before that all points inside are zero.
  void solve() { inner_.solve(surface_); }
  /// The same for the control points that ties see, while the others stay.
  void solve_rows() { inner_.solve_rows(surface_); }
  /// Takes the points of the surface that lie under those of the fit, so that the next solution is free to
  /// run along the surface.
  void slide();
  /// Against the surface itself.
  FaceMiss miss(const FitLimits& limits) const;

 private:
  std::size_t place(std::size_t i, std::size_t j) const { return j * samples_.s.size() + i; }
  std::vector<PatchPoint> fitted() const {
    return evaluate_grid(surface_, samples_.s.basis, samples_.t.basis);
  }
  void aim();
  std::vector<double> times(const FitLimits& limits) const;
  std::vector<double> residual(const FitPlaces& own, bool by_s) const;

  const PieceEvaluator& model_;
  FitLimits limits_;
  SplineSurface surface_;
  SplineSurface outer_;              ///< the boundary alone: zero inside
  std::vector<Vector3> outer_part_;  ///< its points at the samples
  FitSamples samples_;               ///< at equal parameters
  std::vector<PatchPoint> under_;    ///< those under the fit
  std::vector<Vector2> places_;      ///< by s and t, of these
  std::vector<Vector3> misses_;      ///< of the boundary, at the samples, in the surface's frames
  std::vector<Vector3> targets_;     ///< positions under the fit, brought to the boundary
  std::vector<Vector3> areas_;       ///< along the normals, of the samples' parts
  InnerFit inner_;
};

/// The spline of given spaces that has the surface's values at the Greville places inside, and the boundary.
SplineSurface interpolated(const SplineSpace& s, const SplineSpace& t, const PieceEvaluator& surface,
                           const FaceBoundary& boundary);

}  // namespace hariko

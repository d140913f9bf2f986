#pragma once

// Least-squares fit of a surface by a tensor spline with few control points, its boundary given and tied to
// tangent planes along its sides.

#include <array>
#include <span>

#include "core/cad/fit/curve_fit.hpp"
#include "core/cad/fit/inner_fit.hpp"

namespace hariko {

/// Deviation of a face from the surface in multiples of the limits, and the spans to be halved.
struct FaceMiss {
  double worst = 0;
  std::vector<char> s, t;
};

/// Control points along sides 0, 1, 2, 3, in the direction of growing s or t.
using FaceBoundary = std::array<std::vector<Vector3>, 4>;

/// Tensor spline fitted to a piece of the surface, solved again as ties and knots change.
class FaceFit {
 public:
  /// Fit without ties yet. `surface` must outlive this. `before`: a fit of the same surface with fewer knots,
  /// or null; its samples are taken over instead of being evaluated again.
  FaceFit(const PieceEvaluator& surface, SplineSpace s, SplineSpace t, FaceBoundary boundary,
          const FitLimits& limits, const FaceFit* before = nullptr);

  const SplineSurface& surface() const { return surface_; }
  /// Sets the ties of the next solution.
  void set_ties(std::span<const FaceTie> ties) { inner_.tie(ties, outer_); }
  /// Changes the wanted values of the same ties.
  void want(std::span<const double> values) { inner_.want(values); }
  /// Minimises the squared deviations in units of the limits, with zero net volume between face and surface.
  /// Before the first solution all inner control points are zero.
  void solve() { inner_.solve(surface_); }
  /// Solves for the control points that ties depend on; the others stay.
  void solve_rows() { inner_.solve_rows(surface_); }
  /// Reprojects the samples to the surface points under the fit, so that the next solution is free to move
  /// along the surface.
  void slide();
  /// Deviation from the surface itself.
  FaceMiss miss(const FitLimits& limits) const;
  /// Whether the face turns its back to the surface at a sampled place or on a side.
  bool folds() const;

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
  SplineSurface outer_;              ///< the boundary alone: inner control points are zero
  std::vector<Vector3> outer_part_;  ///< points of `outer_` at the samples
  FitSamples samples_;               ///< at equal parameters
  std::vector<PatchPoint> under_;    ///< surface points under the fit
  std::vector<Vector2> places_;      ///< parameters (s, t) of `under_`
  /// Deviation of the boundary, carried to the samples, in the surface's frames.
  std::vector<Vector3> misses_;
  std::vector<Vector3> targets_;  ///< `under_` corrected by the deviation of the boundary
  std::vector<Vector3> areas_;    ///< area of each sample, times its normal
  InnerFit inner_;
};

/// Spline of given spaces that interpolates the surface at the inner Greville places and has the given
/// boundary.
SplineSurface interpolated(const SplineSpace& s, const SplineSpace& t, const PieceEvaluator& surface,
                           const FaceBoundary& boundary);

}  // namespace hariko

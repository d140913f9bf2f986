#pragma once

// Sample places of a fit.

#include "core/cad/cad_piece.hpp"
#include "core/cad/fit/spline.hpp"

namespace hariko {

/// Gauss places in each span of a space, ascending, with the basis functions there.
struct FitPlaces {
  SplineSpace space;
  std::size_t per_span = 0;
  std::vector<double> at, weight;  ///< weights add up to 1
  std::vector<SplineBasis> basis;

  explicit FitPlaces(SplineSpace space);
  std::size_t size() const { return at.size(); }
  std::size_t span(std::size_t place) const { return place / per_span; }
};

/// Surface points at all pairs of places; those along `s` are consecutive.
struct FitSamples {
  FitPlaces s, t;
  std::vector<PatchPoint> points;

  /// Evaluates the surface, except in rectangles between knots that `before`, if given, shares.
  FitSamples(const PieceEvaluator& surface, FitPlaces s, FitPlaces t, const FitSamples* before);
};

}  // namespace hariko

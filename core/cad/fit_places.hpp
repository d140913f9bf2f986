#pragma once

// Places at which a fit looks at a surface.

#include "core/cad/cad_piece.hpp"
#include "core/cad/spline.hpp"

namespace hariko {

/// Gauss places of each span of a space, ascending, with the functions there.
struct FitPlaces {
  SplineSpace space;
  std::size_t per_span = 0;
  std::vector<double> at, weight;  ///< weights add up to 1
  std::vector<SplineBasis> basis;

  explicit FitPlaces(SplineSpace space);
  std::size_t size() const { return at.size(); }
  std::size_t span(std::size_t place) const { return place / per_span; }
};

/// Points of a surface at pairs of places, those of `s` one after another.
struct FitSamples {
  FitPlaces s, t;
  std::vector<PatchPoint> points;

  /// Takes the points of rectangles between knots that `before`, if given, has too.
  FitSamples(const PieceEvaluator& surface, FitPlaces s, FitPlaces t, const FitSamples* before);
};

}  // namespace hariko

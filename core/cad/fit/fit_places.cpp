#include "core/cad/fit/fit_places.hpp"

#include <algorithm>

#include "core/cad/fit/curve_fit.hpp"

namespace hariko {

namespace {

/// Number of the first place of another space's equal span, for each span.
std::vector<std::optional<std::size_t>> equal_spans(const FitPlaces& own, const FitPlaces& other) {
  std::vector<std::optional<std::size_t>> out(own.space.span_count());
  if (own.per_span != other.per_span) return out;
  const std::vector<double>& theirs = other.space.breaks;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto at = std::lower_bound(theirs.begin(), theirs.end(), own.space.breaks[i]);
    if (at == theirs.end() || at + 1 == theirs.end()) continue;
    if (at[0] == own.space.breaks[i] && at[1] == own.space.breaks[i + 1])
      out[i] = std::size_t(at - theirs.begin()) * other.per_span;
  }
  return out;
}

}  // namespace

FitPlaces::FitPlaces(SplineSpace of) : space(std::move(of)) {
  // A single span needs as many places as it has functions; more reveal the error between them.
  const SpanPlaces& places = span_places(space.span_count() < 3 ? space.degree + 2 : space.degree + 1);
  per_span = places.at.size();
  for (std::size_t span = 0; span < space.span_count(); ++span) {
    const double width = span_width(space, span);
    for (std::size_t g = 0; g < per_span; ++g) {
      at.push_back(space.breaks[span] + places.at[g] * width);
      weight.push_back(places.weight[g] * width / (space.end() - space.begin()));
    }
  }
  basis = spline_bases(space, at);
}

FitSamples::FitSamples(const PieceEvaluator& surface, FitPlaces along, FitPlaces up, const FitSamples* before)
    : s(std::move(along)), t(std::move(up)) {
  std::vector<std::optional<std::size_t>> same_s(s.space.span_count()), same_t(t.space.span_count());
  if (before) {
    same_s = equal_spans(s, before->s);
    same_t = equal_spans(t, before->t);
  }
  points.reserve(s.size() * t.size());
  for (std::size_t j = 0; j < t.size(); ++j)
    for (std::size_t i = 0; i < s.size(); ++i) {
      const auto &known_s = same_s[s.span(i)], &known_t = same_t[t.span(j)];
      if (known_s && known_t)
        points.push_back(
            before->points[(*known_t + j % t.per_span) * before->s.size() + *known_s + i % s.per_span]);
      else
        points.push_back(surface.at(s.at[i], t.at[j]));
    }
}

}  // namespace hariko

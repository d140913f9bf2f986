#include "core/skinning/edit/freehand_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/curve_places.hpp"

namespace hariko {

namespace {

constexpr int most_points = 60;
constexpr int per_span = 8;     ///< samples per span at which the curve is compared
constexpr int refinement = 16;  ///< parts of a step in which a corner is located
constexpr double corner_angle = 50 * std::numbers::pi / 180;

/// Polyline parametrised by arc length; closed ones are periodic.
class DrawnLine {
 public:
  DrawnLine(const std::vector<Vector3>& points, bool closed) : closed_(closed) {
    for (const Vector3& p : points)
      if (points_.empty() || (p - points_.back()).norm() > 0) points_.push_back(p);
    if (closed && points_.size() > 1) points_.push_back(points_.front());
    at_ = lengths_along(points_);
  }

  double length() const { return at_.back(); }
  Vector3 point(double s) const {
    if (closed_) s -= std::floor(s / length()) * length();
    s = std::clamp(s, 0.0, length());
    const std::size_t i = std::size_t(std::clamp<std::ptrdiff_t>(
        std::upper_bound(at_.begin(), at_.end(), s) - at_.begin(), 1, std::ptrdiff_t(at_.size()) - 1));
    const double t = (s - at_[i - 1]) / (at_[i] - at_[i - 1]);
    return points_[i - 1] + t * (points_[i] - points_[i - 1]);
  }
  /// Angle between the chords of length `reach` before and behind a place.
  double turn(double s, double reach) const {
    const Vector3 before = point(s) - point(s - reach), after = point(s + reach) - point(s);
    const double lengths = before.norm() * after.norm();
    return lengths > 0 ? std::acos(std::clamp(before.dot(after) / lengths, -1.0, 1.0)) : 0;
  }

 private:
  bool closed_;
  std::vector<Vector3> points_;
  std::vector<double> at_;
};

/// Places of sharp turns, ascending, farther apart than `reach`.
std::vector<double> corners_of(const DrawnLine& line, bool closed, double reach) {
  const int count = int(std::ceil(4 * line.length() / reach));
  const double step = line.length() / count;
  struct Turn {
    double at, angle;
  };
  std::vector<Turn> turns;
  for (int i = 0; i < count; ++i) {
    const double s = i * step;
    if (!closed && (s < reach || s > line.length() - reach)) continue;
    if (const double angle = line.turn(s, reach); angle > corner_angle) turns.push_back({s, angle});
  }
  std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.angle > b.angle; });
  std::vector<double> out;
  for (const Turn& turn : turns) {
    const bool apart = std::all_of(out.begin(), out.end(), [&](double other) {
      const double gap = std::abs(other - turn.at);
      return std::min(gap, closed ? line.length() - gap : gap) > 2 * reach;
    });
    // A bend that is sharp only at a large scale is no corner.
    if (!apart || !(line.turn(turn.at, reach / 3) > corner_angle)) continue;
    // The curve has its corner exactly here: one beside the line's own would cut that off.
    Turn best = turn;
    for (int k = -refinement; k <= refinement; ++k) {
      const double s = turn.at + step * k / refinement;
      if (const double angle = line.turn(s, reach); angle > best.angle) best = {s, angle};
    }
    out.push_back(best.at);
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// Layout of points evenly spaced between corners: `counts` intervals from each of `breaks` to the next.
struct Layout {
  std::vector<double> breaks;  ///< ends, or for a closed line one turn
  std::vector<int> counts;
  bool corners_at_breaks = false;
};

double to_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const double square = (b - a).squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(b - a) / square, 0.0, 1.0) : 0;
  return (a + t * (b - a) - p).norm();
}

struct Made {
  SubdivisionCurve curve;
  std::vector<double> deviation;  ///< per part of the layout
};

Made make(const DrawnLine& line, const Layout& layout, bool closed) {
  std::vector<Vector3> targets;
  std::vector<char> sharp;
  const std::size_t parts = layout.counts.size();
  for (std::size_t p = 0; p < parts; ++p)
    for (int i = 0; i < layout.counts[p]; ++i) {
      const double s = layout.breaks[p] + (layout.breaks[p + 1] - layout.breaks[p]) * i / layout.counts[p];
      targets.push_back(line.point(s));
      sharp.push_back(i == 0 && layout.corners_at_breaks && (closed || p > 0));
    }
  if (!closed) targets.push_back(line.point(line.length())), sharp.push_back(0);
  if (std::none_of(sharp.begin(), sharp.end(), [](char s) { return s != 0; })) sharp.clear();
  Made out{curve_through(std::move(targets), closed, std::move(sharp)), {}};
  int span = 0;
  for (std::size_t p = 0; p < parts; ++p) {
    const double length = layout.breaks[p + 1] - layout.breaks[p];
    double largest = 0;
    std::vector<Vector3> drawn, passed;
    for (int i = 0; i <= layout.counts[p] * per_span; ++i) {
      const double share = double(i) / (layout.counts[p] * per_span);
      const double u = (span + share * layout.counts[p]) / out.curve.spans();
      const Vector3 at = evaluate(out.curve, std::min(u, 1.0)).position;
      // Searches half a span of the line either way, because the curve's parameter is not its length.
      const double s = layout.breaks[p] + share * length;
      const double reach = length / (2 * layout.counts[p]);
      double least = (line.point(s) - at).norm();
      for (int k = -per_span; k <= per_span; ++k) {
        const double there = s + reach * k / per_span;
        least = std::min(least, (line.point(there) - at).norm());
      }
      largest = std::max(largest, least);
      drawn.push_back(line.point(s));
      passed.push_back(at);
    }
    // A curve that cuts a corner off is near the line, but the corner is not near the curve.
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      double least = largest + (drawn[i] - passed[i]).norm();
      for (std::size_t k = i - std::min<std::size_t>(i, per_span); k + 1 < passed.size() && k < i + per_span;
           ++k)
        least = std::min(least, to_segment(drawn[i], passed[k], passed[k + 1]));
      largest = std::max(largest, least);
    }
    out.deviation.push_back(largest);
    span += layout.counts[p];
  }
  return out;
}

}  // namespace

Result<SubdivisionCurve> freehand_curve(const std::vector<Vector3>& points, bool closed, double tolerance) {
  const DrawnLine line(points, closed);
  if (!(line.length() > 4 * tolerance))
    return make_error(e_short_stroke, "The stroke is too short to be a curve.", "Draw a longer one.");
  Layout layout;
  layout.breaks = corners_of(line, closed, std::max(8 * tolerance, 0.04 * line.length()));
  layout.corners_at_breaks = !layout.breaks.empty();
  if (closed) {
    if (layout.breaks.empty()) layout.breaks.push_back(0);
    layout.breaks.push_back(layout.breaks.front() + line.length());
  } else {
    layout.breaks.insert(layout.breaks.begin(), 0.0);
    layout.breaks.push_back(line.length());
  }
  const std::size_t parts = layout.breaks.size() - 1;
  // A closed curve gets at least four intervals; an open one without corners two, between corners one each.
  layout.counts.assign(parts, closed ? std::max(1, (4 + int(parts) - 1) / int(parts)) : (parts > 1 ? 1 : 2));
  while (true) {
    Made made = make(line, layout, closed);
    const auto worst = std::max_element(made.deviation.begin(), made.deviation.end());
    if (*worst <= tolerance || made.curve.size() >= most_points) return std::move(made.curve);
    ++layout.counts[std::size_t(worst - made.deviation.begin())];
  }
}

}  // namespace hariko

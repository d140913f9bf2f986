#include "core/skinning/sections/section_starts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

constexpr int fewest_samples = 64, most_samples = 1024;

/// Samples at midpoints of even intervals, relative to their mean; midpoints rarely hit corners.
struct Samples {
  std::vector<Vector3> points, slopes;
  Vector3 mean = Vector3::Zero();
  double square = 0;  ///< mean squared distance from the mean

  Samples(const SubdivisionCurve& curve, int count) {
    for (int i = 0; i < count; ++i) {
      const CurvePoint p = evaluate(curve, (i + 0.5) / count);
      points.push_back(p.position);
      slopes.push_back(p.first);
      mean += points.back() / count;
    }
    for (Vector3& p : points) {
      p -= mean;
      square += p.squaredNorm() / count;
    }
  }
};

/// Correlation of two curves: the mean of first(u) . second(u + start), with its derivatives by the start;
/// larger values mean nearer curves.
class Correlation {
 public:
  Correlation(const SubdivisionCurve& second, const Samples& a, const Samples& b)
      : second_(second), a_(a), b_(b) {}

  double at_sample(int shift) const {
    const std::size_t n = a_.points.size();
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += a_.points[i].dot(b_.points[(i + std::size_t(shift)) % n]);
    return sum / double(n);
  }
  struct Value {
    double value = 0, first = 0, second = 0;
  };
  Value at(double start) const {
    Value out;
    const int n = int(a_.points.size());
    for (int i = 0; i < n; ++i) {
      const CurvePoint p = evaluate(second_, (i + 0.5) / n + start);
      const Vector3& own = a_.points[std::size_t(i)];
      out.value += own.dot(p.position - b_.mean) / n;
      out.first += own.dot(p.first) / n;
      // Integrated by parts, so that corners contribute.
      out.second -= a_.slopes[std::size_t(i)].dot(p.first) / n;
    }
    return out;
  }

 private:
  const SubdivisionCurve& second_;
  const Samples &a_, &b_;
};

double nearest_turn(double start) {
  start -= std::round(start);
  return start <= -0.5 ? start + 1 : start;
}

}  // namespace

StartMatch nearest_start(const SubdivisionCurve& first, const SubdivisionCurve& second) {
  HARIKO_ASSERT(first.closed && second.closed, "open curves begin at their ends");
  const int count = std::clamp(4 * std::max(first.size(), second.size()), fewest_samples, most_samples);
  const Samples a(first, count), b(second, count);
  const Correlation correlation(second, a, b);
  const double size = std::sqrt(a.square * b.square);
  StartMatch out{0, a.square + b.square, 0, size};
  if (!(size > 0)) return out;
  std::vector<double> coarse;
  for (int s = 0; s < count; ++s) coarse.push_back(correlation.at_sample(s));
  const double highest = *std::max_element(coarse.begin(), coarse.end());
  double best = -std::numeric_limits<double>::infinity();
  for (int s = 0; s < count; ++s) {
    const double here = coarse[std::size_t(s)];
    // A maximum between two samples is slightly higher than they are.
    if (here < highest - 0.02 * size || here < coarse[std::size_t((s + 1) % count)] ||
        here < coarse[std::size_t((s + count - 1) % count)])
      continue;
    double start = double(s) / count;
    auto value = correlation.at(start);
    for (int round = 0; round < 12 && value.second < 0; ++round) {
      const double step = -value.first / value.second;
      if (!(std::abs(step) * count < 1)) break;
      const auto next = correlation.at(start + step);
      if (!(next.value >= value.value - 1e-13 * size)) break;
      start += step;
      value = next;
    }
    start = nearest_turn(start);
    const bool equal = std::abs(value.value - best) <= 1e-9 * size;
    if (equal ? std::abs(start) > std::abs(out.start) - 1e-9 : value.value < best) continue;
    best = std::max(best, value.value);
    out.start = start;
    out.displacement = std::max(0.0, a.square + b.square - 2 * value.value);
    out.stiffness = std::max(0.0, -2 * value.second);
  }
  return out;
}

SubdivisionCurve reversed(const SubdivisionCurve& curve) {
  SubdivisionCurve out = curve;
  const auto from = std::ptrdiff_t(curve.closed && curve.size() > 0 ? 1 : 0);
  std::reverse(out.points.begin() + from, out.points.end());
  if (!out.sharp.empty()) std::reverse(out.sharp.begin() + from, out.sharp.end());
  return out;
}

std::vector<double> chained_starts(const std::vector<StartMatch>& strips, const std::vector<char>& free,
                                   bool closed_path) {
  std::vector<double> steps;
  double sum = 0, softness = 0;
  for (std::size_t s = 0; s < strips.size(); ++s) {
    steps.push_back(strips[s].start);
    sum += strips[s].start;
    if (free[s]) softness += 1 / std::max(strips[s].stiffness, 1e-9 * strips[s].size + 1e-300);
  }
  if (closed_path && softness > 0) {
    const double left = sum - std::round(sum);
    for (std::size_t s = 0; s < strips.size(); ++s)
      if (free[s])
        steps[s] -= left / std::max(strips[s].stiffness, 1e-9 * strips[s].size + 1e-300) / softness;
  }
  std::vector<double> out{0};
  for (std::size_t s = 0; s + (closed_path ? 1 : 0) < strips.size(); ++s)
    out.push_back(out.back() + steps[s]);
  return out;
}

}  // namespace hariko

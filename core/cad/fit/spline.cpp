#include "core/cad/fit/spline.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "core/base/assert.hpp"

namespace hariko {

std::vector<double> SplineSpace::knots() const {
  std::vector<double> out(std::size_t(degree), breaks.front());
  out.insert(out.end(), breaks.begin(), breaks.end());
  out.insert(out.end(), std::size_t(degree), breaks.back());
  return out;
}

std::vector<double> SplineSpace::greville() const {
  const std::vector<double> all = knots();
  std::vector<double> out(size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 1; k <= std::size_t(degree); ++k) sum += all[i + k];
    out[i] = sum / degree;
  }
  out.front() = begin();
  out.back() = end();
  return out;
}

std::size_t SplineSpace::span(double x) const {
  const auto above = std::upper_bound(breaks.begin(), breaks.end(), x);
  const auto at = std::size_t(std::max<std::ptrdiff_t>(above - breaks.begin(), 1)) - 1;
  return std::min(at, span_count() - 1);
}

SplineSpace SplineSpace::reversed() const {
  SplineSpace out{degree, {}};
  for (auto b = breaks.rbegin(); b != breaks.rend(); ++b) out.breaks.push_back(begin() + end() - *b);
  out.breaks.front() = begin();
  out.breaks.back() = end();
  return out;
}

SplineBasis spline_basis(const SplineSpace& space, const std::vector<double>& knots, double x) {
  SplineBasis out;
  out.first = space.span(x);
  const auto p = std::size_t(space.degree);
  const std::size_t at = out.first + p;  // knots[at] <= x < knots[at + 1]
  std::array<double, max_spline_degree + 1> left{}, right{}, lower{}, lowest{};
  out.value[0] = 1;
  for (std::size_t d = 1; d <= p; ++d) {
    left[d] = x - knots[at + 1 - d];
    right[d] = knots[at + d] - x;
    lowest = lower;
    lower = out.value;
    double saved = 0;
    for (std::size_t r = 0; r < d; ++r) {
      const double part = lower[r] / (right[r + 1] + left[d - r]);
      out.value[r] = saved + right[r + 1] * part;
      saved = left[d - r] * part;
    }
    out.value[d] = saved;
  }
  // `lower` holds the functions of degree p - 1 now, and `lowest` those of degree p - 2.
  const auto derivative = [&](const auto& functions, std::size_t d, std::size_t r) {
    const double below = r > 0 ? functions[r - 1] / (knots[at + r] - knots[at + r - d]) : 0;
    const double above = r < d ? functions[r] / (knots[at + r + 1] - knots[at + r + 1 - d]) : 0;
    return double(d) * (below - above);
  };
  std::array<double, max_spline_degree + 1> slope{};
  for (std::size_t r = 0; r < p && p > 1; ++r) slope[r] = derivative(lowest, p - 1, r);
  for (std::size_t r = 0; r <= p && p > 0; ++r) {
    out.derivative[r] = derivative(lower, p, r);
    if (p > 1) out.second[r] = derivative(slope, p, r);
  }
  return out;
}

std::vector<SplineBasis> spline_bases(const SplineSpace& space, std::span<const double> places) {
  const std::vector<double> knots = space.knots();
  std::vector<SplineBasis> out;
  out.reserve(places.size());
  for (const double x : places) out.push_back(spline_basis(space, knots, x));
  return out;
}

SplinePoint evaluate(const SplineCurve& curve, double x) {
  const SplineBasis basis = spline_basis(curve.space, curve.space.knots(), x);
  SplinePoint out;
  for (std::size_t r = 0; r <= std::size_t(curve.space.degree); ++r) {
    out.position += basis.value[r] * curve.points[basis.first + r];
    out.derivative += basis.derivative[r] * curve.points[basis.first + r];
  }
  return out;
}

SplineCurve reversed(const SplineCurve& curve) {
  return {curve.space.reversed(), {curve.points.rbegin(), curve.points.rend()}};
}

SplineEvaluator::SplineEvaluator(const SplineSurface& surface)
    : surface_(surface), knots_s_(surface.s.knots()), knots_t_(surface.t.knots()) {}

PatchPoint SplineEvaluator::at(double s, double t, Order order) const {
  const SplineBasis a = spline_basis(surface_.s, knots_s_, s), b = spline_basis(surface_.t, knots_t_, t);
  PatchPoint out;
  for (std::size_t j = 0; j <= std::size_t(surface_.t.degree); ++j) {
    Vector3 row = Vector3::Zero(), row_s = Vector3::Zero(), row_ss = Vector3::Zero();
    for (std::size_t i = 0; i <= std::size_t(surface_.s.degree); ++i) {
      const Vector3& p = surface_.points[surface_.index(a.first + i, b.first + j)];
      row += a.value[i] * p;
      row_s += a.derivative[i] * p;
      if (order == Order::second) row_ss += a.second[i] * p;
    }
    out.position += b.value[j] * row;
    out.ds += b.value[j] * row_s;
    out.dt += b.derivative[j] * row;
    if (order == Order::first) continue;
    out.dss += b.value[j] * row_ss;
    out.dst += b.derivative[j] * row_s;
    out.dtt += b.second[j] * row;
  }
  return out;
}

std::vector<PatchPoint> evaluate_grid(const SplineSurface& surface, std::span<const SplineBasis> s,
                                      std::span<const SplineBasis> t) {
  const std::size_t count = s.size(), rows = surface.t.size();
  std::vector<Vector3> value(rows * count, Vector3::Zero()), slope = value;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t u = 0; u <= std::size_t(surface.s.degree); ++u) {
        const Vector3& p = surface.points[surface.index(s[i].first + u, row)];
        value[row * count + i] += s[i].value[u] * p;
        slope[row * count + i] += s[i].derivative[u] * p;
      }
  std::vector<PatchPoint> out(count * t.size());
  for (std::size_t j = 0; j < t.size(); ++j)
    for (std::size_t v = 0; v <= std::size_t(surface.t.degree); ++v) {
      const std::size_t from = (t[j].first + v) * count;
      for (std::size_t i = 0; i < count; ++i) {
        PatchPoint& point = out[j * count + i];
        point.position += t[j].value[v] * value[from + i];
        point.ds += t[j].value[v] * slope[from + i];
        point.dt += t[j].derivative[v] * value[from + i];
      }
    }
  return out;
}

struct SplineInterpolation::Factors {
  Eigen::PartialPivLU<Eigen::MatrixXd> matrix;
};

SplineInterpolation::SplineInterpolation(const SplineSpace& space)
    : places_(space.greville()), factors_(std::make_unique<Factors>()) {
  const auto n = Eigen::Index(space.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  const std::vector<double> knots = space.knots();
  for (Eigen::Index i = 0; i < n; ++i) {
    const SplineBasis basis = spline_basis(space, knots, places_[std::size_t(i)]);
    for (Eigen::Index r = 0; r <= space.degree; ++r)
      matrix(i, Eigen::Index(basis.first) + r) = basis.value[std::size_t(r)];
  }
  factors_->matrix.compute(matrix);
}

SplineInterpolation::~SplineInterpolation() = default;
SplineInterpolation::SplineInterpolation(SplineInterpolation&&) noexcept = default;

void SplineInterpolation::solve(std::span<Vector3> values, std::size_t stride, std::size_t count,
                                std::size_t offset) const {
  const std::size_t n = places_.size();
  HARIKO_ASSERT((n - 1) * stride + (count - 1) * offset < values.size(), "values are too few");
  Eigen::MatrixXd right(Eigen::Index(n), Eigen::Index(3 * count));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < count; ++k)
      right.block<1, 3>(Eigen::Index(i), Eigen::Index(3 * k)) = values[i * stride + k * offset].transpose();
  const Eigen::MatrixXd solved = factors_->matrix.solve(right);
  for (std::size_t i = 1; i + 1 < n; ++i)
    for (std::size_t k = 0; k < count; ++k)
      values[i * stride + k * offset] = solved.block<1, 3>(Eigen::Index(i), Eigen::Index(3 * k)).transpose();
}

}  // namespace hariko

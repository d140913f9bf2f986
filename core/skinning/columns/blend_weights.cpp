#include <algorithm>
#include <cmath>

#include "core/base/solvers/dense_solver.hpp"
#include "core/skinning/columns/smooth.hpp"
#include "core/skinning/sections/monotone_cubic.hpp"

namespace hariko {

namespace {

/// Slopes of the C2 cubic spline through the values, with natural ends or periodic (the last value is the
/// first).
std::vector<double> spline_slopes(const std::vector<double>& x, const std::vector<double>& y, bool periodic) {
  const int n = int(x.size());
  const auto h = [&](int k) { return x[std::size_t(k) + 1] - x[std::size_t(k)]; };
  const auto d = [&](int k) { return (y[std::size_t(k) + 1] - y[std::size_t(k)]) / h(k); };
  const int unknowns = periodic ? n - 1 : n;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(unknowns, unknowns);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(unknowns);
  for (int i = 0; i < unknowns; ++i) {
    if (!periodic && (i == 0 || i == n - 1)) {
      const int k = i == 0 ? 0 : n - 2;
      a(i, i) = 2, a(i, i == 0 ? 1 : n - 2) = 1;
      b[i] = 3 * d(k);
      continue;
    }
    const int before = (i + n - 2) % (n - 1);  // interval before, cyclically
    const double h0 = h(before), h1 = h(i);
    a(i, periodic ? (i + unknowns - 1) % unknowns : i - 1) += h1;
    a(i, i) += 2 * (h0 + h1);
    a(i, periodic ? (i + 1) % unknowns : i + 1) += h0;
    b[i] = 3 * (h1 * d(before) + h0 * d(i));
  }
  const Eigen::VectorXd s = solve_general(a, b);
  std::vector<double> out(s.data(), s.data() + s.size());
  if (periodic) out.push_back(out[0]);
  return out;
}

/// Slopes of the non-uniform Catmull-Rom spline: those of the parabola through three values; at the ends 1.5
/// s - 0.5 D'.
std::vector<double> local_slopes(const std::vector<double>& x, const std::vector<double>& y, bool periodic) {
  const int n = int(x.size());
  const auto h = [&](int k) { return x[std::size_t(k) + 1] - x[std::size_t(k)]; };
  const auto d = [&](int k) { return (y[std::size_t(k) + 1] - y[std::size_t(k)]) / h(k); };
  std::vector<double> out(std::size_t(n), 0.0);
  const auto inner = [&](int before, int after) {
    return (h(after) * d(before) + h(before) * d(after)) / (h(before) + h(after));
  };
  for (int k = 1; k + 1 < n; ++k) out[std::size_t(k)] = inner(k - 1, k);
  if (periodic) {
    out.front() = out.back() = inner(n - 2, 0);
  } else {
    out.front() = 1.5 * d(0) - 0.5 * (n > 2 ? out[1] : d(0));
    out.back() = 1.5 * d(n - 2) - 0.5 * (n > 2 ? out[std::size_t(n) - 2] : d(0));
  }
  return out;
}

}  // namespace

BlendWeights::BlendWeights(std::vector<double> places, bool closed, Blend blend)
    : knots_(std::move(places)), sections_(knots_.size()), closed_(closed) {
  if (closed) knots_.push_back(knots_[0] + 1);
  if (blend == Blend::automatic) blend = sections_ == 2 ? Blend::linear : Blend::natural;
  linear_ = blend == Blend::linear || sections_ < 2 || (closed && sections_ < 3);
  for (std::size_t k = 0; k < sections_; ++k) {
    std::vector<double> value(knots_.size(), 0.0);
    value[k] = 1;
    if (closed && k == 0) value.back() = 1;
    value_.push_back(value);
    if (linear_)
      slope_.emplace_back();
    else
      slope_.push_back(blend == Blend::hermite ? local_slopes(knots_, value, closed)
                                               : spline_slopes(knots_, value, closed));
  }
}

std::vector<double> BlendWeights::at(double v) const {
  if (closed_) v -= std::floor(v - knots_[0]);
  v = std::clamp(v, knots_.front(), knots_.back());
  std::vector<double> out(sections_, 0.0);
  if (linear_) {
    const auto above = std::upper_bound(knots_.begin(), knots_.end(), v);
    const std::size_t k = std::size_t(
        std::clamp<std::ptrdiff_t>(above - knots_.begin() - 1, 0, std::ptrdiff_t(knots_.size()) - 2));
    const double t = (v - knots_[k]) / (knots_[k + 1] - knots_[k]);
    out[k] += 1 - t;
    out[(k + 1) % sections_] += t;
    return out;
  }
  for (std::size_t k = 0; k < sections_; ++k) out[k] = hermite(knots_, value_[k], slope_[k], v);
  return out;
}

}  // namespace hariko

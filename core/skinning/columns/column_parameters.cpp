#include "core/skinning/columns/column_parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/solvers/dense_solver.hpp"

namespace hariko {

namespace {

constexpr int samples = 12;
constexpr int max_evaluations = 60;
constexpr double widest = 6;  ///< bound of the logarithms of widths

/// Adds the residuals of one section: vectors from it to the curve through its points at u, weighted by span
/// widths.
void add_residuals(const SubdivisionCurve& section, std::vector<double> u, double start,
                   std::vector<double>& out) {
  for (double& x : u) x += start;
  const bool closed = section.closed;
  const int n = int(u.size()), spans = closed ? n : n - 1;
  std::vector<Vector3> targets;
  for (const double x : u) targets.push_back(evaluate(section, x).position);
  const SubdivisionCurve fitted = curve_through(std::move(targets), closed);
  for (int c = 0; c < spans; ++c) {
    const double begin = u[std::size_t(c)];
    const double width = (c + 1 < n ? u[std::size_t(c) + 1] : u[0] + 1) - begin;
    for (int j = 0; j < samples; ++j) {
      const double tau = (j + 0.5) / samples;
      const Vector3 a = evaluate(fitted, (c + tau) / spans).position;
      const double x = begin + tau * width;
      const CurvePoint s = evaluate(section, x);
      const Vector3 gap = a - s.position;
      const double slope = s.first.squaredNorm() - gap.dot(s.second);
      const double step = slope > 0 ? std::clamp(gap.dot(s.first) / slope, -width / 2, width / 2) : 0.0;
      const double foot = closed ? x + step : std::clamp(x + step, 0.0, 1.0);
      const Vector3 residual = (a - evaluate(section, foot).position) * std::sqrt(width / samples);
      for (int axis = 0; axis < 3; ++axis) out.push_back(residual[axis]);
    }
  }
}

class Optimiser {
 public:
  Optimiser(const std::vector<SubdivisionCurve>& sections, const std::vector<double>& starts, int columns)
      : sections_(sections),
        starts_(starts),
        closed_(sections[0].closed),
        spans_(closed_ ? columns : columns - 1) {}

  /// Number of unknowns: the logarithm of each width, and the start of closed curves.
  int unknowns() const { return spans_ + (closed_ ? 1 : 0); }
  std::vector<double> parameters(const Eigen::VectorXd& z) const {
    std::vector<double> width;
    double sum = 0;
    for (int c = 0; c < spans_; ++c) {
      width.push_back(std::exp(std::clamp(z[c], -widest, widest)));
      sum += width.back();
    }
    std::vector<double> u{closed_ ? z[spans_] : 0.0};
    for (int c = 0; c + 1 < spans_ || (!closed_ && c < spans_); ++c)
      u.push_back(u.back() + width[std::size_t(c)] / sum);
    if (!closed_) u.back() = 1;
    return u;
  }
  Eigen::VectorXd residuals(const Eigen::VectorXd& z) const {
    std::vector<double> out;
    const std::vector<double> u = parameters(z);
    for (std::size_t s = 0; s < sections_.size(); ++s) add_residuals(sections_[s], u, starts_[s], out);
    return Eigen::Map<Eigen::VectorXd>(out.data(), Eigen::Index(out.size()));
  }
  /// Unknowns for parameters that begin at 0.
  Eigen::VectorXd unknowns_of(const std::vector<double>& u) const {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(unknowns());
    double mean = 0;
    for (int c = 0; c < spans_; ++c) {
      const double next = c + 1 < int(u.size()) ? u[std::size_t(c) + 1] : u[0] + 1;
      z[c] = std::log(std::max(next - u[std::size_t(c)], 1e-9));
      mean += z[c] / spans_;
    }
    for (int c = 0; c < spans_; ++c) z[c] = std::clamp(z[c] - mean, -widest, widest);
    return z;
  }

  /// Minimises by damped Gauss-Newton steps with forward differences; fixed initial damping.
  double minimise(Eigen::VectorXd& z, const CancelToken& cancel) const {
    Eigen::VectorXd r = residuals(z);
    double value = r.squaredNorm(), damping = 1e-3;
    for (int evaluation = 0; evaluation < max_evaluations && !cancel.cancelled(); ++evaluation) {
      Eigen::MatrixXd jacobian(r.size(), z.size());
      for (Eigen::Index k = 0; k < z.size(); ++k) {
        Eigen::VectorXd moved = z;
        moved[k] += 1e-6;
        jacobian.col(k) = (residuals(moved) - r) / 1e-6;
      }
      const Eigen::MatrixXd normal = transposed_product(jacobian, jacobian);
      const Eigen::VectorXd gradient = transposed_product(jacobian, r);
      bool better = false;
      for (int attempt = 0; attempt < 8 && !better; ++attempt) {
        Eigen::MatrixXd damped = normal;
        damped.diagonal() += damping * normal.diagonal();
        damped.diagonal().array() += 1e-12 * normal.diagonal().mean() + 1e-300;
        Eigen::VectorXd next = z - solve_symmetric(damped, gradient);
        for (int c = 0; c < spans_; ++c) next[c] = std::clamp(next[c], -widest, widest);
        const Eigen::VectorXd changed = residuals(next);
        const double got = changed.squaredNorm();
        if (got < value) {
          const bool converged = value - got <= 1e-9 * value;
          z = next, r = changed, value = got, better = true;
          damping = std::max(damping / 5, 1e-12);
          if (converged) return value;
        } else {
          damping *= 6;
        }
      }
      if (!better) break;
    }
    return value;
  }

 private:
  const std::vector<SubdivisionCurve>& sections_;
  const std::vector<double>& starts_;
  bool closed_;
  int spans_;
};

/// Parameters at equal integrals of a density that is summed over the sections.
template <class Density>
std::vector<double> by_density(const std::vector<SubdivisionCurve>& sections,
                               const std::vector<double>& starts, int columns, const Density& density) {
  constexpr int steps = 1024;
  const bool closed = sections[0].closed;
  std::vector<double> sum{0};
  for (int i = 0; i < steps; ++i) {
    double d = 0;
    for (std::size_t s = 0; s < sections.size(); ++s)
      d += density(sections[s], (i + 0.5) / steps, (i + 0.5) / steps + starts[s]);
    sum.push_back(sum.back() + std::max(d, 1e-12) / steps);
  }
  const int spans = closed ? columns : columns - 1;
  std::vector<double> out;
  std::size_t at = 0;
  for (int c = 0; c < columns; ++c) {
    const double wanted = sum.back() * c / spans;
    while (at + 2 < sum.size() && sum[at + 1] < wanted) ++at;
    out.push_back((double(at) + std::clamp((wanted - sum[at]) / (sum[at + 1] - sum[at]), 0.0, 1.0)) / steps);
  }
  return out;
}

/// Density with as many columns as possible on the section's control points, or on even parts of its spans,
/// where columns reproduce the section exactly: dense up to some place, one step sparser from there on.
double stepped(const SubdivisionCurve& section, int columns, double u) {
  const double ratio = double(section.closed ? columns : columns - 1) / std::max(1, section.spans());
  const double low = ratio >= 1 ? std::floor(ratio) : 1 / std::ceil(1 / ratio),
               high = ratio >= 1 ? low + 1 : 1 / std::max(1.0, std::ceil(1 / ratio) - 1);
  return u * (high - low) < ratio - low ? high : low;
}

}  // namespace

std::vector<double> uniform_parameters(int columns, bool closed) {
  std::vector<double> out;
  for (int c = 0; c < columns; ++c) out.push_back(double(c) / (closed ? columns : columns - 1));
  return out;
}

std::vector<double> optimised_parameters(const std::vector<SubdivisionCurve>& sections, int columns,
                                         const CancelToken& cancel, const std::function<void()>& step,
                                         const std::vector<double>& given) {
  std::vector<double> starts = given;
  starts.resize(sections.size(), 0);
  const Optimiser optimiser(sections, starts, columns);
  std::vector<double> lengths;
  for (const SubdivisionCurve& section : sections) lengths.push_back(std::max(length(section), 1e-300));
  const auto size = [&](const SubdivisionCurve& s) { return lengths[std::size_t(&s - sections.data())]; };
  // Densities at fraction u of the columns, whose parameter on the section is x.
  const auto arc = [&](const SubdivisionCurve& s, double, double x) {
    return evaluate(s, x).first.norm() / size(s);
  };
  const auto bent = [&](const SubdivisionCurve& s, double, double x) {
    const CurvePoint p = evaluate(s, x);
    const double speed = p.first.norm();
    const Vector3 cross(p.first.y() * p.second.z() - p.first.z() * p.second.y(),
                        p.first.z() * p.second.x() - p.first.x() * p.second.z(),
                        p.first.x() * p.second.y() - p.first.y() * p.second.x());
    const double curvature = speed > 0 ? cross.norm() / (speed * speed * speed) : 0;
    return speed * (1 + std::sqrt(curvature * size(s))) / size(s);
  };
  // The two densities are mirror images, so that reversing sections does not change the result.
  const auto first = [&](const SubdivisionCurve& s, double u, double) { return stepped(s, columns, u); };
  const auto last = [&](const SubdivisionCurve& s, double u, double) { return stepped(s, columns, 1 - u); };
  const std::array<std::vector<double>, optimiser_seeds> seeds{
      uniform_parameters(columns, sections[0].closed), by_density(sections, starts, columns, arc),
      by_density(sections, starts, columns, bent), by_density(sections, starts, columns, first),
      by_density(sections, starts, columns, last)};
  std::vector<double> best = seeds[0];
  double least = -1;
  for (const auto& seed : seeds) {
    Eigen::VectorXd z = optimiser.unknowns_of(seed);
    const double value = optimiser.minimise(z, cancel);
    if (least < 0 || value < least) least = value, best = optimiser.parameters(z);
    if (step) step();
  }
  return best;
}

double parameter_error(const std::vector<SubdivisionCurve>& sections, const std::vector<double>& parameters) {
  std::vector<double> out;
  for (const SubdivisionCurve& section : sections) add_residuals(section, parameters, 0, out);
  double sum = 0;
  for (const double r : out) sum += r * r;
  return std::sqrt(sum);
}

}  // namespace hariko

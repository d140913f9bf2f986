#include "core/approximation/refinement/split_rule.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/geometry/angles.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

namespace {

constexpr int steps = 24;
/// Range of splits by curvature, away from the ends, where facets would become slivers.
constexpr double least = 0.1, most = 0.9;
/// Range of splits by the paper's rule: a zero nearer to an end would be chosen again and again, leaving
/// slivers.
constexpr double literal_least = 0.1, literal_most = 0.9;

/// Thresholds of images of normals, and of square roots of curvature (relative to the square root of the
/// length), that count as zero.
constexpr double flat_angle = 1e-7, flat_curvature = 1e-5;

constexpr double shortest_bend = 0.1;  ///< in parameters

/// Value rounded to 40 binary digits.
double rounded(double x) {
  constexpr std::uint64_t half = 1U << 11, mask = ~std::uint64_t{0xfff};
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(x) + half) & mask);
}

/// Fraction at which the running sum of `weight` over equal steps reaches half of the total.
double halving_fraction(const std::array<double, steps>& weight, double total) {
  double sum = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    if (sum + weight[i] >= 0.5 * total) return (double(i) + (0.5 * total - sum) / weight[i]) / steps;
    sum += weight[i];
  }
  return 0.5;
}

EdgeSplit by_weights(const std::array<double, steps>& weight) {
  double total = 0;
  for (const double w : weight) total += w;
  EdgeSplit out{total, 0.5};
  if (total > 0) out.parameter = std::clamp(halving_fraction(weight, total), least, most);
  return out;
}

std::array<Vector3, steps + 1> normals_along(const SurfaceSampler& sampler, const ParameterLine& line) {
  std::array<Vector2, steps + 1> parameters;
  std::array<Vector3, steps + 1> normals;
  for (std::size_t i = 0; i <= steps; ++i) parameters[i] = line.at(double(i) / steps);
  sampler.normals(line.patch, parameters, normals);
  return normals;
}

EdgeSplit by_gauss_image(const SurfaceSampler& sampler, const ParameterLine& line) {
  const auto normals = normals_along(sampler, line);
  std::array<double, steps> weight;
  for (std::size_t i = 0; i < steps; ++i) weight[i] = (normals[i + 1] - normals[i]).norm();
  return by_weights(weight);
}

/// Normal curvature of the surface along a line, and its speed.
struct Bend {
  double curvature = 0, speed = 0;
};
Bend bend_at(const SurfaceSampler& sampler, const ParameterLine& line, double t) {
  const PatchPoint p = sampler.second_order(line.patch, line.at(t));
  const Vector2 d = line.to - line.from;
  const Vector3 tangent = d.x() * p.ds + d.y() * p.dt;
  const Vector3 second = d.x() * d.x() * p.dss + 2 * d.x() * d.y() * p.dst + d.y() * d.y() * p.dtt;
  const double square = tangent.squaredNorm();
  if (!(square > 0)) return {};
  return {second.dot(unit_normal(p)) / square, std::sqrt(square)};
}

EdgeSplit by_curvature(const SurfaceSampler& sampler, const ParameterLine& line) {
  std::array<double, steps> weight;
  for (std::size_t i = 0; i < steps; ++i) {
    const Bend bend = bend_at(sampler, line, (double(i) + 0.5) / steps);
    weight[i] = std::sqrt(std::abs(bend.curvature)) * bend.speed / steps;
  }
  return by_weights(weight);
}

/// Zero of f between a and b, where it changes its sign.
template <class Function>
double zero_between(const Function& f, double a, double b, double fa, double fb) {
  for (int round = 0; round < 60 && b - a > 1e-12; ++round) {
    // The secant's point if it makes good progress, otherwise the midpoint.
    const double secant = a - fa * (b - a) / (fb - fa);
    const double middle = 0.5 * (a + b);
    const double t = round % 3 != 2 && secant > a && secant < b ? secant : middle;
    const double ft = f(t);
    if (ft == 0) return t;
    if ((ft > 0) == (fa > 0)) {
      a = t;
      fa = ft;
    } else {
      b = t;
      fb = ft;
    }
  }
  return 0.5 * (a + b);
}

/// Split by the paper's rule: where the normal halves the angle between the end normals, or where the normal
/// curvature vanishes (section 4.2).
EdgeSplit by_normal_halving(const SurfaceSampler& sampler, const ParameterLine& line) {
  const Vector3 na = sampler.normal(line.patch, line.from), nb = sampler.normal(line.patch, line.to);
  EdgeSplit out{angle_between(na, nb), 0.5};
  const auto curvature = [&](double t) { return bend_at(sampler, line, t).curvature; };
  double before = curvature(0);
  for (int i = 1; i <= steps; ++i) {
    const double t = double(i) / steps, here = curvature(t);
    if (before * here < 0) {
      const double zero = zero_between(curvature, double(i - 1) / steps, t, before, here);
      if (zero >= literal_least && zero <= literal_most) {
        out.parameter = zero;
        return out;
      }
    }
    before = here;
  }
  const Vector3 difference = nb - na;
  if (difference.norm() < 1e-12) return out;
  const auto height = [&](double t) { return sampler.normal(line.patch, line.at(t)).dot(difference); };
  const double h0 = height(0), h1 = height(1);
  if (h0 < 0 && h1 > 0)
    out.parameter = std::clamp(zero_between(height, 0, 1, h0, h1), literal_least, literal_most);
  return out;
}

/// Length of an edge; where the surface turns back under it, so that a half is longer than the whole, the
/// length of both halves: otherwise such an edge would never be the longest of its facets, and cutting the
/// others would not end.
double bent_length(const SurfaceSampler& sampler, const ParameterMesh& mesh, Index half_edge) {
  const double length = mesh.length(half_edge);
  const ParameterLine line = mesh.canonical_line(half_edge);
  // Shorter lines do not turn back, or their patch needs more facets than these.
  if ((line.to - line.from).squaredNorm() < shortest_bend * shortest_bend) return length;
  const Vector3 middle = sampler.position(line.patch, line.at(0.5));
  const double first = (middle - mesh.positions[mesh.from(half_edge)]).norm(),
               second = (mesh.positions[mesh.to(half_edge)] - middle).norm();
  return std::max(first, second) > length ? first + second : length;
}

}  // namespace

EdgeSplit edge_split(const SurfaceSampler& sampler, const ParameterMesh& mesh, Index half_edge,
                     SplitRule rule) {
  if (mesh.from(half_edge) == mesh.to(half_edge)) return {};
  EdgeSplit out;
  if (rule == SplitRule::midpoint) {
    out.priority = bent_length(sampler, mesh, half_edge);
  } else {
    const ParameterLine line = mesh.canonical_line(half_edge);
    out = rule == SplitRule::gauss       ? by_gauss_image(sampler, line)
          : rule == SplitRule::curvature ? by_curvature(sampler, line)
                                         : by_normal_halving(sampler, line);
  }
  // Flat edges come after all others, the longest first, and are split in the middle.
  const double length = mesh.length(half_edge);
  const double flat = rule == SplitRule::curvature ? flat_curvature * std::sqrt(length) : flat_angle;
  if (rule != SplitRule::midpoint && !(out.priority > flat)) out = {1e-30 * length, 0.5};
  out.priority = rounded(out.priority);
  return out;
}

}  // namespace hariko

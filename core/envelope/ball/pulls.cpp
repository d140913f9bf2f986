#include "core/envelope/ball/pulls.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/solvers/dense_solver.hpp"

namespace hariko {

namespace {

/// Reach relative to the way: with less the moved part would hang on a thin neck, or on none.
constexpr double reach_of_way = 2.5;
/// Square of the reach relative to way times sigma: the tip's curvature, 6 ways per squared reach, is then
/// that of a box's edge.
constexpr double reach_of_bend = 9;
/// Factor that allows for pulls that overlap.
constexpr double bound_factor = 1.25;
/// Weight of the amounts' squares beside those of the misses, for places that coincide.
constexpr double coincidence = 1e-10;

/// Share of a pull at a distance in units of its reach: with continuous curvature, and as full as a bell can
/// be.
double share(double distance) {
  const double left = std::max(0.0, 1 - distance * distance);
  return left * left * left;
}

/// Shares of a pull at the nodes of a field's lattice.
std::vector<double> shares_of(const SplineField& field, const PulledPlace& place, double reach) {
  const std::array<int, 3>& size = field.size();
  std::vector<double> out(std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]), 0);
  std::array<int, 3> first, last;
  for (std::size_t a = 0; a < 3; ++a) {
    const double middle = (place.at[Eigen::Index(a)] - field.corner()[Eigen::Index(a)]) / field.spacing();
    first[a] = std::max(int(std::ceil(middle - reach / field.spacing())), 0);
    last[a] = std::min(int(std::floor(middle + reach / field.spacing())), size[a] - 1);
  }
  for (int k = first[2]; k <= last[2]; ++k)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i) {
        const Vector3 node = field.corner() + field.spacing() * Vector3(i, j, k);
        out[field.index(i, j, k)] = share((node - place.at).norm() / reach);
      }
  return out;
}

}  // namespace

std::vector<PulledPlace> pulled_places(std::span<const Solid> solids, const Vector3& origin) {
  std::vector<PulledPlace> out;
  for (const Solid& solid : solids)
    for (const Pull& pull : solid.pulls) out.push_back({placed(solid, pull.place) - origin, pull.radius});
  return out;
}

double pull_reach(double radius, double way, double sigma) {
  return std::max({radius, reach_of_way * std::abs(way), std::sqrt(reach_of_bend * std::abs(way) * sigma)});
}

double pull_bound(double way, double reach, double distance) {
  return bound_factor * std::abs(way) * share(distance / reach);
}

double pulled_over(double beyond, double way, double reach) {
  // The unpulled value is the distance from the plane at least, and must be less than the change.
  double low = std::max(0.0, beyond), high = std::max(low, bound_factor * way);
  for (int round = 0; round < 30; ++round) {
    const double middle = 0.5 * (low + high);
    (middle <= pull_bound(way, reach, std::abs(middle - beyond)) ? low : high) = middle;
  }
  return high;
}

std::vector<double> pull_offsets(const SplineField& field, int passes, std::span<const PulledPlace> places,
                                 double sigma) {
  const auto count = Eigen::Index(places.size());
  std::vector<std::vector<double>> shares;
  Eigen::MatrixXd met(count, count);
  Eigen::VectorXd ways(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const PulledPlace& place = places[std::size_t(k)];
    ways[k] = field.value(place.at);
    shares.push_back(shares_of(field, place, pull_reach(place.radius, ways[k], sigma)));
    std::vector<double> smoothed = shares.back();
    for (int pass = 0; pass < passes; ++pass) smooth_lattice(field.size(), smoothed);
    const SplineField alone(field.corner(), field.spacing(), field.size(), std::move(smoothed));
    for (Eigen::Index j = 0; j < count; ++j) met(j, k) = alone.value(places[std::size_t(j)].at);
  }
  Eigen::MatrixXd normal = transposed_product(met, met);
  normal.diagonal().array() += coincidence;
  const Eigen::VectorXd amounts = solve_symmetric(normal, transposed_product(met, ways));
  std::vector<double> out(shares.front().size(), 0);
  for (Eigen::Index k = 0; k < count; ++k)
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += amounts[k] * shares[std::size_t(k)][i];
  return out;
}

}  // namespace hariko

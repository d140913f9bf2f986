#include "core/base/solvers/dense_solver.hpp"
#include "core/envelope/ball/ball_lattice.hpp"

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
  std::vector<double> out(node_count(field.size()), 0);
  field.for_nodes_about(place.at, reach, [&](std::size_t node, const Vector3& p) {
    out[node] = share((p - place.at).norm() / reach);
  });
  return out;
}

/// Length by which a pull outwards moves the surface over a plane at the most, where the unpulled one lies
/// behind the plane and the place is `beyond` it, or before it where that is negative.
double pulled_over(double beyond, double way, double reach) {
  // The unpulled value is the distance from the plane at least, and must be less than the change.
  double low = std::max(0.0, beyond), high = std::max(low, bound_factor * way);
  for (int round = 0; round < 30; ++round) {
    const double middle = 0.5 * (low + high);
    (middle <= pull_bound(way, reach, std::abs(middle - beyond)) ? low : high) = middle;
  }
  return high;
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

Eigen::AlignedBox3d pulled_box(const GrownUnion& solids, std::span<const PulledPlace> pulls, double sigma) {
  const Eigen::AlignedBox3d& own = solids.box();
  Eigen::AlignedBox3d out = own;
  for (const PulledPlace& pull : pulls) {
    const double way = std::max(0.0, solids.nearest(pull.at).distance);
    const double reach = pull_reach(pull.radius, way, sigma);
    for (Eigen::Index a = 0; a < 3; ++a) {
      const double low = own.min()[a], high = own.max()[a];
      out.min()[a] = std::min(out.min()[a], low - pulled_over(low - pull.at[a], way, reach));
      out.max()[a] = std::max(out.max()[a], high + pulled_over(pull.at[a] - high, way, reach));
    }
  }
  return out;
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

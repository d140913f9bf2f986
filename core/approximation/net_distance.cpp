#include "core/approximation/net_distance.hpp"

#include <algorithm>
#include <limits>

namespace hariko {

namespace {

/// Greatest depth of halvings, slightly more than three levels of quarters.
constexpr int deepest_cut = 8;
/// Bounds larger than this many tolerances are not refined: bounds of whole nets are about 1.2 times the true
/// value.
constexpr double hopeless = 2;
constexpr double narrow = 1.01;  ///< accepted ratio of a measured bound to the sampled distance

}  // namespace

NetDistance::NetDistance(const TriangleCorners& corners, const FacetNet& net, const Sides& sides)
    : corners_(corners), closed_(corners), net_(net), sides_(sides) {}

/// Bound by the largest distance of control points to the facet, and of those over a watched side to that
/// side.
double NetDistance::bound_of(const Vector3* points, const Sides& sides) const {
  double worst = closed_.largest_squared_distance({points, net_.shape->count()});
  for (int k = 0; k < 3; ++k) {
    const int side = sides[std::size_t(k)];
    if (side == no_side) continue;
    const Vector3 &a = corners_[std::size_t(side)], &b = corners_[std::size_t(side + 1) % 3];
    for (const int i : net_.shape->side(k))
      worst = std::max(worst, squared_distance_to_segment(points[i], a, b));
  }
  return std::sqrt(worst) + net_.radius;
}

double NetDistance::at_point(const Vector3& p, int side) const {
  double worst = closed_.squared_distance(p);
  if (side != no_side)
    worst = std::max(worst, squared_distance_to_segment(p, corners_[std::size_t(side)],
                                                        corners_[std::size_t(side + 1) % 3]));
  return std::sqrt(worst);
}

/// Side whose halving tightens the bound: the most strongly curved one, since the longest may be straight;
/// the longest where none is curved, as on a saddle.
int NetDistance::side_to_halve(const Vector3* points) const {
  const int n = net_.shape->degree();
  std::array<double, 3> bend{}, length{};
  for (int k = 0; k < 3; ++k) {
    const std::span<const int> side = net_.shape->side(k);
    const Vector3 &a = points[side.front()], chord = points[side.back()] - a;
    length[std::size_t(k)] = chord.squaredNorm();
    for (int i = 1; i < n; ++i)
      bend[std::size_t(k)] = std::max(
          bend[std::size_t(k)], (points[side[std::size_t(i)]] - a - (double(i) / n) * chord).squaredNorm());
  }
  const auto most = std::max_element(bend.begin(), bend.end());
  constexpr double straight = 1e-4;  ///< squared, relative to the longest side
  const auto longest = std::max_element(length.begin(), length.end());
  return int(*most > straight * *longest ? most - bend.begin() : longest - length.begin());
}

/// Halves a piece. `middle`: the distance of the surface point at the cut.
void NetDistance::halve(const Vector3* points, const Sides& sides, Piece& first, Piece& second,
                        double& middle) const {
  const int side = side_to_halve(points);
  net_.shape->split(side, 0.5, points, first.points.data(), second.points.data());
  first.sides = second.sides = sides;
  first.sides[std::size_t(side + 1) % 3] = no_side;
  second.sides[std::size_t(side + 2) % 3] = no_side;
  middle = at_point(second.points[net_.shape->corner(side)], sides[std::size_t(side)]);
}

double NetDistance::decide(double tolerance) {
  const double bound = bound_of(net_.points, sides_);
  if (bound <= tolerance || bound > hopeless * tolerance) return bound;
  const double inner = within(net_.points, sides_, tolerance, deepest_cut);
  return inner <= tolerance ? inner : bound;
}

/// Largest bound of the pieces; infinite once a point or a smallest piece is beyond the tolerance.
double NetDistance::within(const Vector3* points, const Sides& sides, double tolerance, int depth) const {
  constexpr double beyond = std::numeric_limits<double>::infinity();
  if (depth == 0) return beyond;
  Piece first, second;
  double middle = 0;
  halve(points, sides, first, second, middle);
  if (middle > tolerance) return beyond;
  double worst = 0;
  for (const Piece* piece : {&first, &second}) {
    double bound = bound_of(piece->points.data(), piece->sides);
    if (bound > tolerance) bound = within(piece->points.data(), piece->sides, tolerance, depth - 1);
    if (bound > tolerance) return beyond;
    worst = std::max(worst, bound);
  }
  return worst;
}

double NetDistance::sampled() const {
  std::array<Vector3, TriangleNet::sample_count> points;
  net_.shape->samples(net_.points, points);
  double worst = 0;
  for (std::size_t s = 0; s < points.size(); ++s)
    worst = std::max(worst, at_point(points[s], s < 9 ? sides_[s / 3] : no_side));
  return worst;
}

NetDistance::Range NetDistance::measure() {
  Range out;
  out.sampled = sampled();
  out.bound = narrowed(net_.points, sides_, bound_of(net_.points, sides_), deepest_cut + 2, out.sampled);
  out.bound = std::max(out.bound, out.sampled);
  return out;
}

double NetDistance::narrowed(const Vector3* points, const Sides& sides, double bound, int depth,
                             double& sampled) const {
  if (bound <= narrow * sampled || depth == 0) return bound;
  Piece first, second;
  double middle = 0;
  halve(points, sides, first, second, middle);
  sampled = std::max(sampled, middle);
  const double a = bound_of(first.points.data(), first.sides),
               b = bound_of(second.points.data(), second.sides);
  // The worse half first, as its samples may make the other unnecessary.
  const Piece &worse = a >= b ? first : second, &better = a >= b ? second : first;
  const double most = narrowed(worse.points.data(), worse.sides, std::max(a, b), depth - 1, sampled);
  return std::min(bound, std::max(most, narrowed(better.points.data(), better.sides, std::min(a, b),
                                                 depth - 1, sampled)));
}

}  // namespace hariko

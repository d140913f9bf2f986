#include "core/envelope/ball/grown_solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/envelope/ball/ball_lattice.hpp"
#include "core/envelope/ball/soft_solid.hpp"

namespace hariko {

namespace {

/// Distance of points, given in a solid's own axes, from the solid followed in its place.
class FollowedDistance {
 public:
  FollowedDistance(const SolidShape& solid, const SolidShape& followed)
      : solid_(solid), followed_(&followed == &solid ? nullptr : &followed) {}
  double operator()(const Vector3& own) const {
    return followed_ ? followed_->distance(solid_.from_own_axes(own)) : solid_.own_distance(own);
  }

 private:
  const SolidShape& solid_;
  const SolidShape* followed_;  ///< null: the solid itself
};

/// Mean of the distance with the weights of the final lattice, for a node at the point.
double mean_distance(const FollowedDistance& distance, const Vector3& at, double sigma) {
  // Three passes of (1 2 1) / 4, then the B-spline's (1 4 1) / 6 at its node.
  static constexpr std::array<double, 9> weights = [] {
    std::array<double, 9> out{};
    out[3] = 1.0 / 6, out[4] = 4.0 / 6, out[5] = 1.0 / 6;
    for (int pass = 0; pass < 3; ++pass) {
      std::array<double, 9> next{};
      for (std::size_t i = 0; i < 9; ++i) {
        next[i] = 0.5 * out[i];
        if (i > 0) next[i] += 0.25 * out[i - 1];
        if (i < 8) next[i] += 0.25 * out[i + 1];
      }
      out = next;
    }
    return out;
  }();
  const double spacing = lattice_spacing(sigma, final_passes);
  double sum = 0;
  for (int k = -4; k <= 4; ++k)
    for (int j = -4; j <= 4; ++j) {
      double row = 0;
      for (int i = -4; i <= 4; ++i)
        row += weights[std::size_t(i + 4)] * distance(at + spacing * Vector3(i, j, k));
      sum += weights[std::size_t(j + 4)] * weights[std::size_t(k + 4)] * row;
    }
  return sum;
}

/// Approximate mean from seven points, to compare corners of polyhedra that have many.
double rough_mean_distance(const FollowedDistance& distance, const Vector3& at, double sigma) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      sum += distance(at + side * std::sqrt(3.0) * sigma * Vector3::Unit(axis));
  return sum / 6;
}

constexpr std::size_t most_places = 12;  ///< places that are evaluated exactly

/// Places with the least approximate means where there are many, or with the largest where `sign` is -1.
std::vector<Vector3> worth_a_look(const FollowedDistance& distance, const std::vector<Vector3>& at,
                                  double sign, double sigma) {
  if (at.size() <= most_places) return at;
  std::vector<std::pair<double, Index>> order;
  for (Index i = 0; i < at.size(); ++i)
    order.emplace_back(sign * rough_mean_distance(distance, at[i], sigma), i);
  std::ranges::sort(order);
  std::vector<Vector3> out;
  for (std::size_t i = 0; i < most_places; ++i) out.push_back(at[order[i].second]);
  return out;
}

constexpr double least_depth = 0.5;  ///< depth of the centre of a solid below the zero surface, in sigma

}  // namespace

double growth_constant(const SolidShape& solid, const SolidShape& followed, double sigma) {
  const FollowedDistance distance(solid, followed);
  double out = 0;
  for (const Vector3& p : worth_a_look(distance, solid.extremes(), -1, sigma))
    out = std::max(out, mean_distance(distance, p, sigma));
  return out;
}

double face_constant(const SolidShape& solid, const SolidShape& followed, double sigma) {
  if (solid.face_middles().empty()) return growth_constant(solid, followed, sigma);
  const FollowedDistance distance(solid, followed);
  double out = 1e300;
  for (const Vector3& p : worth_a_look(distance, solid.face_middles(), 1, sigma))
    out = std::min(out, mean_distance(distance, p, sigma));
  return out;
}

/// Face constant, or if larger the constant that keeps the mean at the solid's centre below zero: sheets and
/// needles thinner than the kernel would vanish.
double lying_constant(const SolidShape& solid, const SolidShape& followed, double sigma) {
  const double constant = face_constant(solid, followed, sigma);
  if (solid.face_middles().empty()) return constant;
  const FollowedDistance distance(solid, followed);
  return std::max(constant, mean_distance(distance, solid.middle(), sigma) + least_depth * sigma);
}

double constant_of(const Solid& solid, double sigma, bool on_faces) {
  Solid unplaced = solid;
  unplaced.position = unplaced.rotation = Vector3::Zero();
  const SolidShape shape(unplaced, Vector3::Zero());
  std::optional<SolidShape> softer;
  if (solid.roundness) softer.emplace(softened(unplaced), Vector3::Zero());
  const SolidShape& followed = softer ? *softer : shape;
  return on_faces ? lying_constant(shape, followed, sigma) : growth_constant(shape, followed, sigma);
}

double GrowthConstants::of(std::size_t number, const Solid& solid, double sigma, bool on_faces) {
  if (known_.size() <= number) known_.resize(number + 1);
  Known& known = known_[number];
  Solid unplaced = solid;
  unplaced.position = unplaced.rotation = Vector3::Zero();
  unplaced.pulls.clear();
  if (known.sigma != sigma || known.on_faces != on_faces || !(known.solid == unplaced)) {
    const double constant = constant_of(unplaced, sigma, on_faces);
    known = {std::move(unplaced), sigma, on_faces, constant};
  }
  return known.constant;
}

GrownSolid grown_solid(const Solid& solid, const Vector3& origin, double growth) {
  return {SolidShape(softened(solid), origin), growth};
}

GrownUnion::GrownUnion(std::vector<GrownSolid> solids) : solids_(std::move(solids)) {
  all_.resize(solids_.size());
  std::iota(all_.begin(), all_.end(), Index(0));
  for (const GrownSolid& solid : solids_) {
    balls_.push_back({solid.shape.centre(), solid.shape.reach() + solid.growth});
    const Vector3 reach = Vector3::Constant(balls_.back().radius);
    box_.extend(Vector3(solid.shape.centre() - reach));
    box_.extend(Vector3(solid.shape.centre() + reach));
  }
}

NearestSolid GrownUnion::nearest(const Vector3& point, std::span<const Index> among) const {
  NearestSolid out;
  for (const Index i : among) {
    if (is_farther(i, point, out.distance)) continue;
    if (const double d = distance(i, point); d < out.distance) out = {i, d};
  }
  return out;
}

}  // namespace hariko

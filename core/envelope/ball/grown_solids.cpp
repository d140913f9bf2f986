#include "core/envelope/ball/grown_solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/equal_bits.hpp"
#include "core/envelope/ball/ball_lattice.hpp"

namespace hariko {

namespace {

/// Largest inward move of faces relative to the inscribed ball's radius, so that part of every solid remains.
constexpr double most_softened = 0.95;

/// Distance of a cross-section's sides from the axis, in the narrower direction.
double narrowest(const Solid& s) {
  const bool round = s.kind == SolidKind::cylinder || s.kind == SolidKind::cone;
  return s.radius * (round ? 1 : std::cos(std::numbers::pi / s.sides)) * std::min(s.scale.x(), s.scale.y());
}

/// Scales a solid by `share` about a point in its own axes.
void shrink(Solid& solid, const Vector3& about, double share) {
  solid.position += solid_rotation(solid.rotation) * (1 - share) * about.cwiseProduct(solid.scale);
  solid.radius *= share;
  solid.height *= share;
  for (Vector3& p : solid.points) p *= share;
}

/// Distance of points, given in a solid's own axes, from the solid followed in its place.
struct FollowedDistance {
  const SolidShape &solid, &followed;
  double operator()(const Vector3& own) const {
    return &followed == &solid ? solid.own_distance(own) : followed.distance(solid.from_own_axes(own));
  }
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

double growth_constant(const SolidShape& solid, const SolidShape& followed, double sigma) {
  const FollowedDistance distance{solid, followed};
  double out = 0;
  for (const Vector3& p : worth_a_look(distance, solid.extremes(), -1, sigma))
    out = std::max(out, mean_distance(distance, p, sigma));
  return out;
}

/// Face constant, or if larger the constant that keeps the mean at the solid's centre below zero: sheets and
/// needles thinner than the kernel would vanish.
double lying_constant(const SolidShape& solid, const SolidShape& followed, double sigma) {
  const double constant = face_constant(solid, followed, sigma);
  if (solid.face_middles().empty()) return constant;
  const FollowedDistance distance{solid, followed};
  return std::max(constant, mean_distance(distance, solid.middle(), sigma) + least_depth * sigma);
}

}  // namespace

Solid softened(const Solid& solid) {
  Solid out = solid;
  if (!solid.roundness) return out;
  const double part = most_softened * *solid.roundness;
  switch (solid.kind) {
    case SolidKind::sphere:
    case SolidKind::capsule:
    case SolidKind::torus:
      break;
    case SolidKind::box: {
      const Vector3 size = solid.size.cwiseProduct(solid.scale);
      out.size -= part * size.minCoeff() * solid.scale.cwiseInverse();
      break;
    }
    case SolidKind::cylinder:
    case SolidKind::prism: {
      const double beside = narrowest(solid), above = 0.5 * solid.height * solid.scale.z();
      const double inwards = part * std::min(beside, above);
      out.radius *= 1 - inwards / beside;
      out.height *= 1 - inwards / above;
      break;
    }
    case SolidKind::cone:
    case SolidKind::pyramid: {
      // The ball that touches the base and the sides stays where it is.
      const double beside = narrowest(solid), height = solid.height * solid.scale.z();
      const double held = beside * height / (beside + std::hypot(beside, height));
      shrink(out, {0, 0, held / solid.scale.z() - 0.25 * solid.height}, 1 - part);
      break;
    }
    case SolidKind::polyhedron: {
      Vector3 middle = Vector3::Zero();
      for (const Vector3& p : solid.points) middle += p / double(solid.points.size());
      shrink(out, middle, 1 - part);
      break;
    }
  }
  return out;
}

double face_constant(const SolidShape& solid, const SolidShape& followed, double sigma) {
  if (solid.face_middles().empty()) return growth_constant(solid, followed, sigma);
  const FollowedDistance distance{solid, followed};
  double out = 1e300;
  for (const Vector3& p : worth_a_look(distance, solid.face_middles(), 1, sigma))
    out = std::min(out, mean_distance(distance, p, sigma));
  return out;
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

GrownSolid KnownSolids::grown(std::size_t number, const Solid& solid, const Vector3& origin, double sigma,
                              bool on_faces, double room) {
  if (known_.size() <= number) known_.resize(number + 1);
  Known& known = known_[number];
  Solid unplaced = solid;
  unplaced.position = unplaced.rotation = Vector3::Zero();
  unplaced.pulls.clear();
  if (known.sigma != sigma || known.on_faces != on_faces || !(known.solid == unplaced)) {
    const double constant = constant_of(unplaced, sigma, on_faces);
    known = {std::move(unplaced), sigma, on_faces, constant};
  }
  const double growth = known.constant + room;
  if (!known.grown || known.grown->growth != growth || !equal_bits(known.origin, origin) ||
      !equal_bits(known.position, solid.position) || !equal_bits(known.rotation, solid.rotation)) {
    known.grown = GrownSolid{SolidShape(softened(solid), origin), growth};
    known.origin = origin;
    known.position = solid.position;
    known.rotation = solid.rotation;
  }
  return *known.grown;
}

GrownUnion::GrownUnion(std::vector<GrownSolid> solids) : solids_(std::move(solids)) {
  for (const GrownSolid& solid : solids_) {
    const SolidShape& shape = solid.shape;
    balls_.push_back({shape.centre(), shape.reach() + solid.growth});
    Vector3 low = shape.centre(), high = low;
    for (Eigen::Index a = 0; a < 3; ++a) {
      low[a] -= shape.extent(-Vector3::Unit(a)) + solid.growth;
      high[a] += shape.extent(Vector3::Unit(a)) + solid.growth;
    }
    box_.extend(low);
    box_.extend(high);
  }
}

NearestSolid GrownUnion::nearest(const Vector3& point) const {
  NearestSolid out;
  for (Index i = 0; i < solids_.size(); ++i) {
    if (is_farther(i, point, out.distance)) continue;
    if (const double d = distance(i, point); d < out.distance) out = {i, d};
  }
  return out;
}

}  // namespace hariko

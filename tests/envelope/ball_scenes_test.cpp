// Random scenes of 1 to 20 solids with sizes of 1 to 50, that touch, lie flush, in each other and far apart,
// some of them thin, at five tightnesses: closed, whole, without folds, and round the solids.
// HARIKO_REPEAT_SCALE=250 makes 500 scenes.

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <optional>
#include <utility>

#include "core/envelope/ball/tightness.hpp"
#include "tests/envelope/ball_measures.hpp"

namespace hariko::test {

namespace {

Solid varied_solid(std::mt19937_64& rng) {
  Solid out;
  out.kind = SolidKind(uniform_int(rng, 0, 8));
  const double size = log_uniform(rng, 0.04, 2), thin = chance(rng, 0.2) ? 0.05 : 1;
  const auto half = [&] { return size * log_uniform(rng, 0.5, 1); };
  out.size = {2 * half(), 2 * half(), 2 * thin * half()};
  out.radius = half();
  out.height = 2 * thin * half();
  out.length = 2 * half();
  out.tube = out.radius * uniform(rng, 0.1, 0.6);
  out.sides = std::uint32_t(uniform_int(rng, 3, 8));
  if (out.kind == SolidKind::capsule) out.radius *= thin;
  if (out.kind == SolidKind::polyhedron)
    for (int i = 0; i < 8; ++i) out.points.push_back(random_vector(rng, out.radius));
  out.rotation = random_vector(rng, 180);
  return out;
}

/// Half of the way through a solid along an axis, between two flat faces; nothing where there are none.
std::optional<double> half_between_faces(const Solid& solid, Eigen::Index axis) {
  if (solid.kind == SolidKind::box) return 0.5 * solid.size[axis];
  if (axis == 2 && (solid.kind == SolidKind::cylinder || solid.kind == SolidKind::prism))
    return 0.5 * solid.height;
  return {};
}

/// Makes a solid a ball that touches the other one from outside, in a direction from its middle.
void make_tangent(const Solid& other, const Vector3& direction, double far, Solid& solid) {
  solid.kind = SolidKind::sphere;
  const SolidShape shape(other, other.position);
  double low = 0, high = far + 2 * solid.radius;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (shape.distance(middle * direction) < solid.radius ? low : high) = middle;
  }
  solid.position = other.position + high * direction;
}

/// Places a solid about another one: across it, touching, flush with a face, inside, or far away.
void place_about(const Solid& other, std::mt19937_64& rng, Solid& solid) {
  const Vector3 direction = random_vector(rng).normalized();
  const double size = box_of(other).diagonal().norm();
  solid.position = other.position + uniform(rng, 0.1, 0.6) * size * direction;
  switch (uniform_int(rng, 0, 5)) {
    case 0:
      make_tangent(other, direction, size, solid);
      break;
    case 1: {
      const auto axis = Eigen::Index(uniform_int(rng, 0, 2));
      const std::optional<double> half = half_between_faces(other, axis);
      if (!half) break;
      solid.kind = SolidKind::box;
      solid.rotation = other.rotation;
      solid.position = other.position + solid_rotation(other.rotation) *
                                            ((*half + 0.5 * solid.size[axis]) * Vector3::Unit(axis));
      break;
    }
    case 2:
      solid.position = other.position;
      break;
    case 3:
      solid.position = other.position + (size + uniform(rng, 2, 6)) * direction;
      break;
    default:
      break;
  }
}

EnvelopeInput varied_scene(std::mt19937_64& rng) {
  EnvelopeInput out;
  const int count = uniform_int(rng, 1, 20);
  for (int k = 0; k < count; ++k) {
    Solid solid = varied_solid(rng);
    if (k > 0) place_about(out.solids[std::size_t(uniform_int(rng, 0, k - 1))], rng, solid);
    solid.id = std::uint32_t(k);
    out.solids.push_back(std::move(solid));
  }
  return out;
}

/// Whether every side of a quad is one of exactly one other, in the opposite direction, and the quads at
/// every vertex are one fan.
bool is_closed_manifold(const BallCage& cage) {
  // Neighbours of a vertex in a quad: the next one leads to the one before.
  std::map<std::pair<Index, Index>, Index> turned;
  std::map<Index, std::size_t> quads_at;
  for (const auto& quad : cage.quads)
    for (std::size_t i = 0; i < 4; ++i) {
      ++quads_at[quad[i]];
      if (!turned.try_emplace({quad[i], quad[(i + 1) % 4]}, quad[(i + 3) % 4]).second) return false;
    }
  for (const auto& [vertex, count] : quads_at) {
    const Index first = turned.lower_bound({vertex, Index{0}})->first.second;
    std::size_t fan = 0;
    for (Index next = first; fan == 0 || next != first; ++fan) {
      const auto found = turned.find({vertex, next});
      if (found == turned.end()) return false;
      next = found->second;
    }
    if (fan != count) return false;
  }
  return !cage.quads.empty();
}

/// Expects a closed surface without folds, of no more parts than solids; one without tunnels for the hull.
void expect_whole(const BallEnvelope& made, std::size_t solids, bool hull) {
  EXPECT_TRUE(is_closed_manifold(made.cage));
  EXPECT_TRUE(made.surface.boundary_sides().empty());
  const long euler =
      long(made.surface.node_count()) - long(made.surface.seams().size()) + long(made.surface.patch_count());
  EXPECT_EQ(euler, 2 * (made.topology.components - made.topology.tunnels));
  EXPECT_GE(made.topology.components, 1);
  EXPECT_LE(made.topology.components, hull ? 1 : int(solids));
  EXPECT_GE(made.topology.tunnels, 0);
  if (hull) {
    EXPECT_EQ(made.topology.tunnels, 0);
  }
  EXPECT_EQ(made.folds, 0U);
}

/// Expects the solids in the field by the patches' tolerance, and in the patches to 1e-4 of each one's own
/// size.
void expect_solids_inside(const EnvelopeInput& input, const BallEnvelope& made) {
  const std::vector<SolidShape> shapes = shapes_about(input.solids, made.surface.origin());
  double highest = -1e300;
  for (const SolidShape& shape : shapes) {
    for (const Vector3& p : shape.surface_points(100)) highest = std::max(highest, made.field.value(p));
    for (const Vector3& p : shape.extremes())
      highest = std::max(highest, made.field.value(shape.from_own_axes(p)));
  }
  // The constants are those of solids on a node of the lattice.
  EXPECT_LE(highest, -made.tolerance + 0.015 * input.settings.rounding);
  EXPECT_TRUE(made.contains_solids());
  std::vector<double> sizes;
  for (const Solid& solid : input.solids) sizes.push_back(box_of(solid).diagonal().norm());
  const EnclosureReport judged =
      check_enclosure(made.surface, shapes, {.spacing = 2e-3 * solids_size(input.solids), .covered = false},
                      1e-4 * *std::ranges::min_element(sizes));
  double worst = 0;
  for (const OutsidePoint& point : judged.points)
    worst = std::max(worst, point.distance / sizes[point.solid]);
  EXPECT_LE(worst, 1e-4) << judged.outside << " points outside";
}

struct SceneCounts {
  int scenes = 0, surfaces = 0, refined = 0, pinched = 0, coarse = 0;
};

void check_varied_scene(EnvelopeInput input, double rounding, SceneCounts& counts) {
  const double size = solids_size(input.solids);
  input.settings.method = EnvelopeMethod::ball;
  input.settings.rounding = rounding * size;
  double concave = 0;
  for (const double tightness : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    SCOPED_TRACE(testing::Message() << "tightness " << tightness);
    input.settings.ball_radius = ball_radius_at(tightness, input.settings.rounding, size);
    const BallEnvelope made = made_ball(input);
    if (made.surface.patch_count() == 0) return;
    const bool hull = tightness == 0;
    expect_whole(made, input.solids.size(), hull);
    expect_solids_inside(input, made);
    const LargestCurvatures found = largest_curvatures(made);
    concave = std::max(concave, found.concave);
    if (hull) {
      // The hull is convex, and no tip is sharper than a point's: its surface is a ball of 0.61 of the
      // rounding.
      EXPECT_LE(found.concave * input.settings.rounding, 0.1);
      EXPECT_LE(found.convex * input.settings.rounding, 1.8);
    }
    ++counts.surfaces;
    counts.refined += made.rounds > 0;
    counts.pinched += made.pinches > 0;
    counts.coarse += made.coarse > 0;
  }
  ++counts.scenes;
  std::cout << "scene " << counts.scenes << ": " << input.solids.size()
            << " solids, largest concave curvature times the rounding " << concave * input.settings.rounding
            << "\n";
}

}  // namespace

TEST(BallScenes, RandomOnesAreClosedWholeAndRoundTheirSolids) {
  SceneCounts counts;
  for_random(3601, 2, [&](std::mt19937_64& rng) {
    const EnvelopeInput input = varied_scene(rng);
    check_varied_scene(input, uniform(rng, 0.02, 0.035), counts);
  });
  std::cout << counts.scenes << " scenes, " << counts.surfaces << " surfaces: refined " << counts.refined
            << ", with pinches " << counts.pinched << ", coarse " << counts.coarse << "\n";
}

}  // namespace hariko::test

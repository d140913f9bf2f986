// The surface that a rolling ball leaves: distances, closing, rounding, patches.

#include "core/envelope/ball/ball_envelope.hpp"

#include <cmath>

#include "core/analysis/measures.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "tests/envelope/ball_measures.hpp"

namespace hariko::test {

namespace {

Solid solid_of(SolidKind kind) {
  Solid out;
  out.kind = kind;
  if (kind == SolidKind::polyhedron)
    out.points = {{1, 0, 0}, {-1, 0.2, 0}, {0, 1, 0.1}, {0, -1, 0}, {0.1, 0, 1}, {0, 0.1, -0.7}};
  return out;
}

/// Points of a solid, its surface among them, by formulas of their own.
std::vector<Vector3> points_of(const Solid& solid, int count, std::mt19937_64& rng) {
  const auto ball = [&](double radius) -> Vector3 { return radius * random_vector(rng).normalized(); };
  const auto disc = [&](double radius) {
    const double angle = uniform(rng, 0, 2 * std::numbers::pi), r = radius * std::sqrt(uniform(rng, 0, 1));
    const bool rim = chance(rng, 0.5);
    return Vector3((rim ? radius : r) * std::cos(angle), (rim ? radius : r) * std::sin(angle), 0);
  };
  std::vector<Vector3> corners = solid.points;
  const bool tip = solid.kind == SolidKind::pyramid;
  const double low = tip ? -solid.height / 4 : -solid.height / 2;
  if (solid.kind == SolidKind::prism || tip)
    for (std::uint32_t k = 0; k < solid.sides; ++k) {
      const double angle = 2 * std::numbers::pi * k / solid.sides;
      const Vector3 corner(solid.radius * std::cos(angle), solid.radius * std::sin(angle), low);
      corners.push_back(corner);
      if (!tip) corners.emplace_back(corner.x(), corner.y(), -low);
    }
  if (tip) corners.emplace_back(0, 0, 0.75 * solid.height);
  const auto own = [&]() -> Vector3 {
    switch (solid.kind) {
      case SolidKind::box: {
        Vector3 p(uniform(rng, -0.5, 0.5), uniform(rng, -0.5, 0.5), uniform(rng, -0.5, 0.5));
        p[uniform_int(rng, 0, 2)] = chance(rng, 0.5) ? 0.5 : -0.5;
        return p.cwiseProduct(solid.size);
      }
      case SolidKind::sphere:
        return ball(solid.radius);
      case SolidKind::capsule:
        return ball(solid.radius) + Vector3(0, 0, uniform(rng, -0.5, 0.5) * solid.length);
      case SolidKind::cylinder: {
        const double z = chance(rng, 0.5) ? uniform(rng, -0.5, 0.5) : chance(rng, 0.5) ? 0.5 : -0.5;
        return disc(solid.radius) + Vector3(0, 0, z * solid.height);
      }
      case SolidKind::cone: {
        const double share = chance(rng, 0.5) ? 0 : uniform(rng, 0, 1);
        return (1 - share) * disc(solid.radius) + Vector3(0, 0, (share - 0.25) * solid.height);
      }
      case SolidKind::torus: {
        const double a = uniform(rng, 0, 2 * std::numbers::pi), b = uniform(rng, 0, 2 * std::numbers::pi);
        const Vector3 out(std::cos(a), std::sin(a), 0);
        return (solid.radius + solid.tube * std::cos(b)) * out + Vector3(0, 0, solid.tube * std::sin(b));
      }
      default: {
        Vector3 sum = Vector3::Zero();
        double weights = 0;
        for (int k = 0; k < 3; ++k) {
          const double weight = uniform(rng, 0, 1);
          sum += weight * corners[std::size_t(uniform_int(rng, 0, int(corners.size()) - 1))];
          weights += weight;
        }
        return sum / weights;
      }
    }
  };
  std::vector<Vector3> out;
  for (int k = 0; k < count; ++k)
    out.push_back(solid.position + solid_rotation(solid.rotation) * own().cwiseProduct(solid.scale));
  return out;
}

Solid box_of_size(const Vector3& size, const Vector3& at = Vector3::Zero()) {
  Solid out;
  out.size = size;
  out.position = at;
  return out;
}

/// Sizes are parts of the scene's diagonal; a radius of 0 is the hull.
BallEnvelope ball_of(const EnvelopeInput& input, double radius, double sigma) {
  return made_ball(with_ball(input, radius, sigma));
}

}  // namespace

TEST(SolidShapes, DistancesAreThoseToPointsOfTheSolid) {
  std::mt19937_64 rng(7);
  for (int kind = 0; kind < 9; ++kind)
    for (const bool stretched : {false, true}) {
      EnvelopeInput input{{solid_of(SolidKind(kind))}, {}};
      Solid& solid = input.solids[0];
      solid.rotation = {20, 50, -30};
      solid.position = {0.3, 2, -1};
      if (stretched) solid.scale = {0.6, 1.7, 1.1};
      const SolidShape shape(solid, Vector3::Zero());
      const std::vector<Vector3> points = points_of(solid, 6000, rng);
      for (const Vector3& p : points)
        ASSERT_LE(shape.distance(p), 1e-8)
            << name_of(solid.kind) << (stretched ? " stretched " : " ") << p.transpose();
      for (int k = 0; k < 40; ++k) {
        const Vector3 at = solid.position + random_vector(rng, 2.5);
        const SolidPlace place = shape.place(at);
        EXPECT_NEAR(place.distance, shape.distance(at), 1e-12);
        EXPECT_NEAR(place.gradient.norm(), 1, 1e-12);
        EXPECT_NEAR((at - place.core).norm() - place.core_radius, place.distance, 1e-9);
        if (place.distance < 0.05) continue;
        double least = 1e300;
        for (const Vector3& p : points) least = std::min(least, (p - at).norm());
        EXPECT_LE(place.distance, least + 1e-9) << name_of(solid.kind);
        EXPECT_GE(place.distance, least - 0.2) << name_of(solid.kind);
      }
    }
}

TEST(SolidShapes, BoxesOfPointsHaveWholeFaces) {
  const Vector3 half(1, 0.5, 0.3);
  Solid points;
  points.kind = SolidKind::polyhedron;
  for (int k = 0; k < 27; ++k)
    if (k != 13) points.points.push_back(half.cwiseProduct(Vector3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1)));
  const SolidShape hull(points, Vector3::Zero()), box(box_of_size(2 * half), Vector3::Zero());
  EXPECT_EQ(hull.face_middles().size(), 6U);
  EXPECT_EQ(hull.sharp_curves().size(), 12U);
  for_random(23, 10, [&](std::mt19937_64& rng) {
    for (int k = 0; k < 100; ++k) {
      const Vector3 at = random_vector(rng, chance(rng, 0.5) ? 0.6 : 2);
      const SolidPlace one = hull.place(at), other = box.place(at);
      EXPECT_NEAR(one.distance, other.distance, 1e-14);
      EXPECT_NEAR((one.core - other.core).norm(), 0, 1e-14);
    }
  });
}

TEST(SolidShapes, DistancesChangeByTheWayAtMostAndGradientsAreTheirs) {
  std::mt19937_64 rng(8);
  for (int kind = 0; kind < 9; ++kind)
    for (const bool stretched : {false, true}) {
      Solid solid = solid_of(SolidKind(kind));
      if (stretched) solid.scale = {0.6, 1.7, 1.1};
      const SolidShape shape(solid, Vector3::Zero());
      for (int k = 0; k < 60; ++k) {
        const Vector3 a = random_vector(rng, 1.5), b = a + random_vector(rng, 0.3);
        EXPECT_LE(std::abs(shape.distance(a) - shape.distance(b)), (a - b).norm() + 1e-9)
            << name_of(solid.kind);
        const SolidPlace place = shape.place(a);
        if (place.distance < 0.05) continue;
        const double step = 1e-5;
        for (int axis = 0; axis < 3; ++axis) {
          const Vector3 by = step * Vector3::Unit(axis);
          EXPECT_NEAR(place.gradient[axis], (shape.distance(a + by) - shape.distance(a - by)) / (2 * step),
                      2e-4)
              << name_of(solid.kind) << stretched;
        }
      }
    }
}

TEST(SolidShapes, DistancesInPlanesOfSymmetryHaveAllDigits) {
  // Inside, in the plane across the least axis, the nearest points lie on both sides of it, and the distance
  // is known: it falls to both sides by no more than the way.
  for_random(10, 60, [](std::mt19937_64& rng) {
    Vector3 half(uniform(rng, 0.1, 0.2), uniform(rng, 0.3, 1), uniform(rng, 0.3, 1));
    const Vector3 gap = half.cwiseProduct(half) - Vector3::Constant(half.x() * half.x());
    const double angle = uniform(rng, 0, 2 * std::numbers::pi), share = uniform(rng, 0, 0.99);
    const Vector3 in_plane(0, share * std::cos(angle) * gap.y() / half.y(),
                           share * std::sin(angle) * gap.z() / half.z());
    const double known = -half.x() * std::sqrt(1 - in_plane.y() * in_plane.y() / gap.y() -
                                               in_plane.z() * in_plane.z() / gap.z());
    Solid solid = solid_of(SolidKind::sphere);
    solid.radius = 1;
    solid.scale = half;
    const SolidShape shape(solid, Vector3::Zero());
    for (const double beside : {0.0, 1e-15, -1e-12, 1e-9, -1e-6, 1e-4}) {
      const double distance = shape.distance(in_plane + beside * Vector3::UnitX());
      EXPECT_NEAR(distance, known, std::abs(beside) + 1e-15) << beside;
      EXPECT_GE(distance, known - 1e-15) << beside;
    }
  });
}

TEST(SolidShapes, StretchedToriFindTheirDeepestBall) {
  // The depth is that in one of the ellipsoids that make the tube. Where it is least on a kink, an angle that
  // is right to half of the digits leaves half of the digits.
  for_random(12, 100, [](std::mt19937_64& rng) {
    Solid solid = solid_of(SolidKind::torus);
    solid.scale = {uniform(rng, 0.5, 2), uniform(rng, 0.5, 2), uniform(rng, 0.5, 2)};
    const SolidShape shape(solid, Vector3::Zero());
    Solid part = solid_of(SolidKind::sphere);
    part.radius = solid.tube;
    part.scale = solid.scale;
    const SolidShape ball(part, Vector3::Zero());
    const auto middle = [&](double a) -> Vector3 {
      return (solid.radius * Vector3(std::cos(a), std::sin(a), 0)).cwiseProduct(solid.scale);
    };
    for (int k = 0; k < 10; ++k) {
      const double about = uniform(rng, 0, 2 * std::numbers::pi);
      const Vector3 at = middle(about) + 0.1 * random_vector(rng);
      const auto depth = [&](double a) { return ball.distance(at - middle(a)); };
      const double step = 0.01;
      int best = 0;
      for (int i = 1; i < 629; ++i)
        if (depth(i * step) < depth(best * step)) best = i;
      double low = (best - 1) * step, high = (best + 1) * step;
      for (int round = 0; round < 90; ++round) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (depth(a) < depth(b) ? high : low) = depth(a) < depth(b) ? b : a;
      }
      EXPECT_NEAR(shape.distance(at), depth(low), 1e-12) << at.transpose();
    }
  });
}

TEST(BallClosing, IsNeverFartherInThanAnySolid) {
  std::mt19937_64 rng(9);
  for (int scene = 0; scene < 12; ++scene) {
    const EnvelopeInput input = random_scene(rng);
    std::vector<GrownSolid> grown;
    for (const Solid& solid : input.solids) grown.push_back({SolidShape(solid, Vector3::Zero()), 0.02});
    const GrownUnion all(std::move(grown));
    const Closing closing(all, 0.4, 1e-5);
    for (int k = 0; k < 50; ++k) {
      const Vector3 at = input.solids[0].position + random_vector(rng, 3);
      const double least = all.nearest(at).distance;
      EXPECT_LE(closing.at(at).value, least + 1e-12);
    }
  }
}

TEST(BallClosing, FillsTheNotchOfTwoBallsByARing) {
  // Centres of the rolling ball lie on a circle about the line through both.
  Solid ball = solid_of(SolidKind::sphere);
  ball.radius = 1;
  ball.position = {-1, 0, 0};
  Solid other = ball;
  other.position = {1, 0, 0};
  std::vector<GrownSolid> grown{{SolidShape(ball, Vector3::Zero()), 0},
                                {SolidShape(other, Vector3::Zero()), 0}};
  const GrownUnion all(std::move(grown));
  const double radius = 0.5, circle = std::sqrt(1.5 * 1.5 - 1);
  const Closing closing(all, radius, 1e-7);
  for (const double y : {0.2, 0.4, 0.55})
    EXPECT_NEAR(closing.at({0, y, 0}).value, radius - (circle - y), 1e-5) << y;
}

TEST(BallEnvelopes, OneBoxIsRoundedByTheSpecifiedAmounts) {
  const EnvelopeInput input{{box_of_size({1, 1, 1})}, {}};
  const BallEnvelope made = ball_of(input, 1, 0.03);
  const double sigma = 0.03 * std::sqrt(3.0), tolerance = 0.1 * sigma;
  const double face = reach(made.field, Vector3::Zero(), Vector3::UnitX(), 1) - 0.5;
  EXPECT_NEAR(face, 0.925 * sigma + tolerance, 0.012 * sigma);
  EXPECT_NEAR(made.field.value({0.5, 0.5, 0}), -0.33 * sigma - tolerance, 0.012 * sigma) << "on an edge";
  EXPECT_LE(made.field.value({0.5, 0.5, 0.5}), 0.01 * sigma - tolerance) << "at a corner";
  double most = 0;
  for (int k = 0; k < 400; ++k) {
    const double a = k * 0.25 * std::numbers::pi / 100;
    const Vector3 way(std::cos(a), std::sin(a), 0);
    const Vector3 at = reach(made.field, Vector3::Zero(), way, 2) * way;
    const LevelCurvature form = level_curvature(made.field, at);
    most = std::max(most, -form.along(form.normal.cross(Vector3::UnitZ()).normalized()));
  }
  EXPECT_NEAR(most * sigma, 0.664, 0.03);
  EXPECT_EQ(made.coarse, 0U);
}

TEST(BallEnvelopes, PatchesMeetWithCommonTangentPlanes) {
  const BallEnvelope made = ball_of(golden_scene("four"), 0.3, 0.04);
  const auto at = [&](const PatchSide& side, double x) {
    return made.surface.patches().evaluate(side.patch, side_parameter(Domain::square, side.side, x),
                                           Order::first);
  };
  for (const Seam& seam : made.surface.seams())
    for (const double x : {0.125, 0.375, 0.5, 0.875}) {
      const PatchPoint a = at(seam.first, x), b = at(seam.second, 1 - x);
      EXPECT_EQ(a.position, b.position);
      EXPECT_LE(unit_normal(a).cross(unit_normal(b)).norm(), 1e-8);
    }
}

TEST(BallEnvelopes, ContainRandomScenes) {
  std::mt19937_64 rng(20261126);
  for (int k = 0; k < 8; ++k) {
    EnvelopeInput input = random_scene(rng);
    choose_ball(input);
    const double size = solids_size(input.solids);
    input.settings.rounding = 0.035 * size;
    input.settings.ball_radius = (k % 2 == 0 ? 0.3 : 2.0) * size;
    const EnvelopeSurface made = envelope_of(input);
    std::vector<SolidShape> shapes;
    for (const Solid& solid : input.solids) shapes.emplace_back(solid, made.origin);
    const EnclosureReport found =
        check_enclosure(made.surface, shapes, {.spacing = 0.02 * size}, 1e-4 * size);
    EXPECT_EQ(found.outside, 0U) << k;
    EXPECT_TRUE(made.enclosed) << k;
  }
}

TEST(BallEnvelopes, NothingSmallIsMissed) {
  // Smaller than the cubes, wherever these lie, and far from what is large; and a needle, which stays whole.
  std::mt19937_64 rng(14);
  for (int k = 0; k < 6; ++k) {
    EnvelopeInput input{{box_of_size({1, 1, 1})}, {}};
    Solid small = solid_of(k % 2 == 0 ? SolidKind::sphere : SolidKind::capsule);
    small.radius = 0.005;
    small.length = 0.8;
    small.position = 2 * random_vector(rng).normalized();
    small.rotation = random_vector(rng, 180);
    small.id = 1;
    input.solids.push_back(small);
    choose_ball(input);
    input.settings.ball_radius = 3 * input.settings.rounding;
    const EnvelopeSurface made = envelope_of(input);
    EXPECT_EQ(made.components, 2) << k;
    EXPECT_TRUE(made.enclosed) << k;
    std::vector<SolidShape> shapes;
    for (const Solid& solid : input.solids) shapes.emplace_back(solid, made.origin);
    const double size = solids_size(input.solids);
    EXPECT_EQ(check_enclosure(made.surface, shapes, {.spacing = 0.02 * size}, 1e-4 * size).outside, 0U) << k;
  }
}

TEST(BallEnvelopes, AreTheSameAtEverySizeAndPlace) {
  EnvelopeInput input = golden_scene("ell");
  choose_ball(input);
  input.settings.rounding = 0.05 * solids_size(input.solids);
  const EnvelopeSurface usual = envelope_of(input);
  for (const double scale : {1e-3, 1e6}) {
    EnvelopeInput other = input;
    for (Solid& solid : other.solids) {
      solid.size *= scale;
      solid.position *= scale;
    }
    other.settings.rounding *= scale;
    *other.settings.ball_radius *= scale;
    const EnvelopeSurface made = envelope_of(other);
    EXPECT_EQ(made.surface.patch_count(), usual.surface.patch_count()) << scale;
    EXPECT_NEAR(measure(made.surface).bending, measure(usual.surface).bending, 1e-3);
  }
  for (Solid& solid : input.solids) solid.position += Vector3::Constant(1e6);
  const EnvelopeSurface far = envelope_of(input);
  EXPECT_NEAR(measure(far.surface).bending, measure(usual.surface).bending,
              0.02 * measure(usual.surface).bending);
  EXPECT_TRUE(far.enclosed);
}

TEST(BallEnvelopes, AreTheirOwnImageInAPlane) {
  EnvelopeInput input{{box_of_size({1, 0.6, 0.5}, {0.45, 0.1, 0})}, {}};
  input.settings.symmetry = SymmetryPlane::x;
  choose_ball(input);
  const EnvelopeSurface made = envelope_of(input);
  EXPECT_TRUE(made.symmetric);
  std::vector<Vector3> corners;
  for (const Vector3& p : made.cage->positions) corners.push_back(p + made.origin);
  for (const Vector3& p : corners) {
    double least = 1e300;
    for (const Vector3& q : corners) least = std::min(least, (Vector3(-p.x(), p.y(), p.z()) - q).norm());
    EXPECT_LE(least, 1e-6);
  }
}

TEST(Tightness, GoesFromTheHullToTheSmallestBall) {
  EXPECT_FALSE(ball_radius_at(0, 0.1, 10).has_value());
  EXPECT_NEAR(*ball_radius_at(1, 0.1, 10), 0.3, 1e-12);
  EXPECT_NEAR(*ball_radius_at(1e-12, 0.1, 10), 80, 1e-6);
  for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0})
    EXPECT_NEAR(tightness_of(ball_radius_at(t, 0.1, 10), 0.1, 10), t, 1e-12);
}

}  // namespace hariko::test

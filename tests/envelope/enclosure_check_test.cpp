// The independent check of enclosure, on surfaces of which is known where solids reach out.

#include <Eigen/Geometry>

#include "core/envelope/enclosure_check.hpp"
#include "tests/envelope/envelope_scenes.hpp"
#include "tests/support/analytic_patches.hpp"

namespace hariko::test {

namespace {

constexpr double slack = 2e-4;
constexpr EnclosureEffort effort{16, 100, 0.01, true};

/// The nearest point of this surface to its axis is at x = 2.
Surface wide_torus() {
  return torus(3, 1, 24, 12);
}

std::vector<SolidShape> shapes_of(const std::vector<Solid>& solids) {
  std::vector<SolidShape> out;
  for (const Solid& solid : solids) out.emplace_back(solid, Vector3::Zero());
  return out;
}

/// A sphere of radius 2 with a dent in one direction.
Surface dented_sphere(const Vector3& direction, double depth) {
  const Surface round = sphere(2);
  std::vector<PatchFormula> formulas;
  std::vector<Index> nodes;
  for (Index p = 0; p < round.patch_count(); ++p) {
    for (int c = 0; c < 3; ++c) nodes.push_back(round.node(p, c));
    const auto position = [=](double s, double t) {
      const Vector3 at = round.patches().evaluate(p, {s, t}, Order::first).position.normalized();
      const double angle = std::acos(std::clamp(at.dot(direction), -1.0, 1.0)) / 0.3;
      return Vector3((2 - depth * std::exp(-angle * angle)) * at);
    };
    formulas.push_back([=](double s, double t) {
      constexpr double h = 1e-6;
      PatchPoint point = round.patches().evaluate(p, {s, t}, Order::second);
      point.position = position(s, t);
      point.ds = (position(s + h, t) - position(s - h, t)) / (2 * h);
      point.dt = (position(s, t + h) - position(s, t - h)) / (2 * h);
      return point;
    });
  }
  return make_surface(Domain::triangle, std::move(formulas), nodes);
}

/// Spheres of radius 2, some way from each other.
Surface two_spheres(double shift) {
  const Vector3 at[6] = {Vector3::UnitX(),  -Vector3::UnitX(), Vector3::UnitY(),
                         -Vector3::UnitY(), Vector3::UnitZ(),  -Vector3::UnitZ()};
  const Index corners[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  std::vector<Index> nodes;
  std::vector<PatchFormula> formulas;
  for (Index one = 0; one < 2; ++one)
    for (std::size_t k = 0; k < std::size(corners); k += 3) {
      for (std::size_t c = 0; c < 3; ++c) nodes.push_back(corners[k + c] + 6 * one);
      const PatchFormula round = sphere_patch(at[corners[k]], at[corners[k + 1]], at[corners[k + 2]], 2);
      formulas.push_back([=](double s, double t) {
        PatchPoint point = round(s, t);
        point.position.x() += shift * one;
        return point;
      });
    }
  return make_surface(Domain::triangle, std::move(formulas), nodes);
}

}  // namespace

TEST(EnclosureCheck, EdgesThatReachOutBetweenTheirTestPointsAreFound) {
  constexpr double out = 0.002;
  // An edge along y goes through the wall between y = -0.09 and 0.09, between two test points of the edge.
  const double half_width = 0.4, to_edge = half_width * std::sqrt(2.0);
  Solid box;
  box.size = {2 * half_width, 2, 2 * half_width};
  box.rotation = {0, 45, 0};
  // Nor does a vertex of the triangles lie there.
  box.position = {2 - out + to_edge, 0.1, 0.016};
  const auto solids = shapes_of({box});
  const EnclosureReport found = check_enclosure(wide_torus(), solids, effort, slack);
  EXPECT_NEAR(found.worst, out, 4e-4);
  ASSERT_FALSE(found.points.empty());
  for (const OutsidePoint& point : found.points) {
    EXPECT_EQ(point.solid, 0U);
    EXPECT_LE(std::abs(point.point.y()), 0.1);
    EXPECT_NEAR(point.point.x(), 2 - out, 1e-3);
  }
  // Only close points of the curves find it: at a spacing of 3 nothing is outside.
  EXPECT_EQ(check_enclosure(wide_torus(), solids, {16, 100, 3, true}, slack).outside, 0U);
}

TEST(EnclosureCheck, RimsThatReachOutBetweenTheirTestPointsAreFound) {
  constexpr double out = 0.0004;
  // Within the tube's wall at the far side, where the tube is as round as the rim but for a little.
  Solid drum{.kind = SolidKind::cylinder, .radius = 3.6, .height = 0.2};
  // The outer wall at z = 0.1 has the radius 3 + sqrt(1 - 0.01); the rim is moved towards it.
  const double wall = 3 + std::sqrt(1 - 0.01);
  const double turn = (0.5 / 48) * 2 * std::numbers::pi;
  drum.position = (wall + out - 3.6) * Vector3(std::cos(turn), std::sin(turn), 0);
  const EnclosureReport found = check_enclosure(torus(3, 1, 24, 12), shapes_of({drum}), effort, 1e-4);
  double farthest = 0;
  for (const OutsidePoint& point : found.points)
    if (std::hypot(point.point.x(), point.point.y()) > 3) farthest = std::max(farthest, point.distance);
  EXPECT_NEAR(farthest, out, 3e-4);
}

TEST(EnclosureCheck, TipsFarOutsideAreMeasured) {
  // A needle with its tip 5 outside of the sphere: its edges are farther from the sphere than they are long.
  Solid needle{.kind = SolidKind::pyramid, .radius = 0.2, .height = 8};
  needle.position = {0, 0, 1};  // its tip is three quarters of the height above
  const std::vector<SolidShape> shapes = shapes_of({needle});
  const EnclosureReport report = check_enclosure(sphere(2), shapes, effort, slack);
  EXPECT_NEAR(report.worst, 5, 0.01);
}

TEST(EnclosureCheck, FacesThatTheSurfaceRunsBelowAreFound) {
  constexpr double out = 0.01;
  const Vector3 middle(1, 0.2, 0.13);  // middle of a spot of 0.06 across
  Solid box;
  box.size = {2, 2, 2};
  const auto solids = shapes_of({box});
  for (const Vector3& p : solids[0].surface_points(effort.points)) ASSERT_GT((p - middle).norm(), 0.07);
  const Surface dented = dented_sphere(middle.normalized(), 2 - middle.norm() + out);
  EnclosureEffort fine = effort;
  fine.density = 64;
  const EnclosureReport found = check_enclosure(dented, solids, fine, slack);
  EXPECT_NEAR(found.worst, out, 0.003);
  ASSERT_FALSE(found.points.empty());
  for (const OutsidePoint& point : found.points) {
    EXPECT_NEAR(point.point.x() + point.distance, 1, 1e-9) << "as deep below the face";
    EXPECT_LT((point.point - middle).norm(), 0.1);
  }
}

TEST(EnclosureCheck, BodiesOfCapsulesAreSolid) {
  Solid capsule{.kind = SolidKind::capsule, .radius = 0.5, .length = 3};
  // A surface that runs into the body between two of its lines is found.
  const auto solids = shapes_of({capsule});
  const Vector3 middle = 0.5 * Vector3(std::cos(0.19), std::sin(0.19), 0.3);
  const Surface dented = dented_sphere(middle.normalized(), 2 - middle.norm() + 0.01);
  EnclosureEffort fine = effort;
  fine.density = 64;
  EXPECT_NEAR(check_enclosure(dented, solids, fine, slack).worst, 0.0075, 0.003);
}

TEST(EnclosureCheck, WhatLiesInsideOfAnotherSolidIsLeftOut) {
  Solid ball, inner;
  ball.kind = inner.kind = SolidKind::sphere;
  ball.radius = 1;
  inner.radius = 0.5;
  const Surface surface = sphere(2);
  const std::size_t alone = check_enclosure(surface, shapes_of({ball}), effort, slack).tested;
  EXPECT_EQ(check_enclosure(surface, shapes_of({ball, inner}), effort, slack).tested, alone);
  // But not what lies on both surfaces: the points of both count.
  EXPECT_EQ(check_enclosure(surface, shapes_of({ball, ball}), effort, slack).tested,
            alone + std::size_t(effort.points));
  inner.position.x() = 3;
  const EnclosureReport outside = check_enclosure(surface, shapes_of({ball, inner}), effort, slack);
  EXPECT_GT(outside.tested, alone);
  EXPECT_NEAR(outside.worst, 1.5, 0.02);
}

TEST(EnclosureCheck, PartsOfTheSurfaceInsideOfOthersAreCounted) {
  const auto covered = [](double shift, bool look) {
    return check_enclosure(two_spheres(shift), {}, {16, 100, 0.01, look}, slack).covered;
  };
  EXPECT_EQ(covered(5, true), 0U);
  // Half of each lies in the other, and a little more of the patches.
  EXPECT_GE(covered(0.5, true), 8U);
  EXPECT_EQ(covered(0.5, false), 0U);
  EXPECT_EQ(check_enclosure(wide_torus(), {}, effort, slack).covered, 0U);
}

TEST(SharpCurves, LieOnTheirSolids) {
  struct Expected {
    SolidKind kind;
    std::size_t count;
  };
  for_random(31, 5, [](std::mt19937_64& rng) {
    for (const Expected& expected : {Expected{SolidKind::box, 12},
                                     {SolidKind::sphere, 0},
                                     {SolidKind::cylinder, 2},
                                     {SolidKind::cone, 17},
                                     {SolidKind::prism, 15},
                                     {SolidKind::pyramid, 10},
                                     {SolidKind::capsule, 16},
                                     {SolidKind::torus, 0}}) {
      Solid solid;
      solid.kind = expected.kind;
      solid.sides = 5;
      solid.tube = 0.3 * solid.radius;
      solid.rotation = random_vector(rng, 180);
      solid.position = random_vector(rng, 10);
      solid.scale = {uniform(rng, 0.3, 3), uniform(rng, 0.3, 3), uniform(rng, 0.3, 3)};
      const SolidShape on(solid, Vector3::Zero());
      const auto curves = on.sharp_curves();
      EXPECT_EQ(curves.size(), expected.count) << int(expected.kind);
      for (const SharpCurve& curve : curves) {
        double length = 0;
        constexpr int steps = 64;
        for (int k = 0; k < steps; ++k) {
          const Vector3 point = curve.at((k + 0.5) / steps);
          EXPECT_NEAR(on.distance(point), 0, 1e-8);
          length += (curve.at(double(k + 1) / steps) - curve.at(double(k) / steps)).norm();
        }
        EXPECT_LE(length, curve.length() * (1 + 1e-12));
        EXPECT_EQ(curve.across.has_value(), (curve.at(1) - curve.at(0)).norm() < 1e-9);
      }
    }
  });
}

}  // namespace hariko::test

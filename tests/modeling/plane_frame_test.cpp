// Planes to draw in: from three points, from polygons, from sections, and where rays meet them.

#include "core/modeling/objects/plane_frame.hpp"

#include <Eigen/Geometry>

#include "core/geometry/polygon.hpp"
#include "core/skinning/columns/simple_skin.hpp"
#include "core/skinning/sections/section_frame.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

Vector3 somewhere(std::mt19937_64& rng) {
  return {uniform(rng, -50, 50), uniform(rng, -50, 50), uniform(rng, -50, 50)};
}

void expect_axes(const PlaneFrame& plane) {
  EXPECT_LT((plane.axes.transpose() * plane.axes - Matrix3::Identity()).norm(), 1e-12);
  EXPECT_NEAR(plane.axes.determinant(), 1, 1e-12);
}

TEST(PlaneFrame, ThreePointsGiveZeroTheAxisAndTheSide) {
  for_random(4301, 500, [](std::mt19937_64& rng) {
    const Vector3 a = somewhere(rng), b = somewhere(rng), c = somewhere(rng);
    const auto plane = must(plane_through(a, b, c));
    expect_axes(*plane);
    EXPECT_EQ(plane->point, a);
    const Vector3 second = plane->local(b), third = plane->local(c);
    EXPECT_NEAR(second.x(), (b - a).norm(), 1e-10);
    EXPECT_LT(second.tail<2>().norm(), 1e-10);
    EXPECT_GT(third.y(), 0);
    EXPECT_NEAR(third.z(), 0, 1e-10);
    const Vector3 beside = somewhere(rng), foot = plane->foot(beside);
    EXPECT_NEAR((foot - a).dot(plane->normal()), 0, 1e-10);
    EXPECT_LT((beside - foot).cross(plane->normal()).norm(), 1e-9);
    EXPECT_LT((plane->at(plane->local(beside)) - beside).norm(), 1e-10);
  });
}

TEST(PlaneFrame, PointsInALineAreRefused) {
  for_random(4302, 100, [](std::mt19937_64& rng) {
    const Vector3 a = somewhere(rng), way = somewhere(rng);
    must_fail(plane_through(a, a + way, a + uniform(rng, -3, 3) * way), e_plane_in_line);
    EXPECT_FALSE(plane_through(a, a, a + way)) << "two points in one place";
    const std::vector<Vector3> corners{a, a + way, a + 2 * way};
    EXPECT_FALSE(plane_of_polygon(corners));
  });
}

TEST(PlaneFrame, APolygonHasItsOwnSideUpAndALevelAxis) {
  for_random(4303, 300, [](std::mt19937_64& rng) {
    const std::vector<Vector3> corners{somewhere(rng), somewhere(rng), somewhere(rng)};
    const auto plane = must(plane_of_polygon(corners));
    expect_axes(*plane);
    EXPECT_GT(plane->normal().dot(newell_normal(corners)), 0);
    EXPECT_LT((plane->point - (corners[0] + corners[1] + corners[2]) / 3).norm(), 1e-10);
    for (const Vector3& corner : corners) EXPECT_NEAR(plane->local(corner).z(), 0, 1e-9);
    // Nearly level planes take the y axis instead.
    if (std::abs(plane->normal().z()) < 0.99) {
      EXPECT_NEAR(plane->axes.col(0).z(), 0, 1e-12);
      EXPECT_GE(plane->axes.col(1).z(), 0);
    }
  });
  const PlaneFrame level = upright_plane({1, 2, 3}, Vector3::UnitZ());
  EXPECT_LT((level.axes - Matrix3::Identity()).norm(), 1e-15) << "as the ground";
}

TEST(PlaneFrame, ASectionLiesInItsPlaneOnThePath) {
  const Skin skin = arched_skin(150, 100, 50, 7);
  for (const SkinSection& section : skin.sections) {
    const PlaneFrame plane = plane_of_section(skin, section);
    expect_axes(plane);
    EXPECT_LT((plane.normal() + section_direction_of_view(skin, section)).norm(), 1e-12);
    EXPECT_LT((plane.point - evaluate(skin.path, section.v).position).norm(), 1e-12);
  }
}

TEST(PlaneFrame, RaysMeetItOrRunAlongIt) {
  for_random(4304, 300, [](std::mt19937_64& rng) {
    const auto plane = must(plane_through(somewhere(rng), somewhere(rng), somewhere(rng)));
    const Vector3 target = plane->at({uniform(rng, -9, 9), uniform(rng, -9, 9), 0});
    const Vector3 origin = target + uniform(rng, 1, 99) * plane->normal() + 3 * plane->axes.col(0);
    const auto t = where_ray_meets(*plane, origin, (target - origin).normalized(), 0.01);
    ASSERT_TRUE(t);
    EXPECT_NEAR(*t, (target - origin).norm(), 1e-8);
    EXPECT_FALSE(where_ray_meets(*plane, origin, plane->axes.col(1), 0.01));
  });
}

}  // namespace
}  // namespace hariko::test

// Grids on planes of their own: where they lie, and when the ground or the side's plane stands in for them.

#include "render/grid_plane.hpp"

#include <cmath>

#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

TEST(GridPlace, AGridOfItsOwnLiesInItsPlaneWithLinesThroughItsZero) {
  for_random(4401, 200, [](std::mt19937_64& rng) {
    const Eigen::Quaterniond turn = Eigen::Quaterniond(uniform(rng, 0.1, 1), uniform(rng, -1, 1),
                                                       uniform(rng, -1, 1), uniform(rng, -1, 1))
                                        .normalized();
    GridSettings grid;
    grid.plane = GridSettings::Plane{Vector3(uniform(rng, -9, 9), uniform(rng, -9, 9), uniform(rng, -9, 9)),
                                     turn.toRotationMatrix()};
    Camera camera = Camera::standard(StandardView::iso);
    camera.target = {uniform(rng, -99, 99), uniform(rng, -99, 99), uniform(rng, -99, 99)};
    const Vector3 normal = grid.plane->axes.col(2);
    const GridPlace place = grid_place(camera, grid);
    if (std::abs(normal.dot(camera.forward())) <= 0.01) return;  // seen from its edge
    EXPECT_EQ(place.axes, grid.plane->axes);
    EXPECT_FALSE(place.backdrop);
    EXPECT_NEAR((place.centre - grid.plane->point).dot(normal), 0, 1e-9);
    // The centre is a whole number of coarse cells away from zero, and near the target's foot.
    const double coarse = grid_cells * grid_lines(grid, camera.view_height()).spacing;
    const Vector3 zero = place.centre + place.axes * Vector3(place.zero.x(), place.zero.y(), 0);
    EXPECT_LT((zero - grid.plane->point).norm(), 1e-9);
    for (const double steps : {place.zero.x() / coarse, place.zero.y() / coarse})
      EXPECT_NEAR(steps, std::round(steps), 1e-9);
    const Vector3 foot = camera.target - (camera.target - grid.plane->point).dot(normal) * normal;
    EXPECT_LT((place.centre - foot).norm(), coarse);
  });
}

TEST(GridPlace, FromItsEdgeAPlaneGivesWayToTheGroundOrTheSide) {
  GridSettings grid;
  grid.plane = GridSettings::Plane{Vector3(1, 2, 3), Matrix3::Identity()};
  Camera front = Camera::standard(StandardView::front);
  EXPECT_FALSE(grid_place(front, grid).backdrop) << "perspective";
  EXPECT_EQ(grid_place(front, grid).centre.z(), 0) << "the ground";
  front.orthographic = true;
  EXPECT_TRUE(grid_place(front, grid).backdrop);
  int decimals = 0;
  EXPECT_FALSE(grid_labels(front, {900, 600}, grid, 64, decimals).empty());
  Camera top = Camera::standard(StandardView::top);
  top.orthographic = true;
  EXPECT_FALSE(grid_place(top, grid).backdrop);
  EXPECT_EQ(grid_place(top, grid).centre.z(), 3);
  EXPECT_TRUE(grid_labels(top, {900, 600}, grid, 64, decimals).empty()) << "its numbers would be others";
  grid.plane.reset();
  EXPECT_TRUE(grid_place(top, grid).backdrop);
  EXPECT_FALSE(grid_labels(top, {900, 600}, grid, 64, decimals).empty());
}

}  // namespace
}  // namespace hariko::test

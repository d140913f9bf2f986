#include "render/camera.hpp"

#include <numbers>

#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

constexpr PixelSize picture_size{800, 600};
constexpr double pi = std::numbers::pi;

Camera random_camera(std::mt19937_64& rng) {
  Camera camera;
  camera.target = random_vector(rng, 10);
  camera.orientation =
      Eigen::Quaterniond(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1), 1.1).normalized();
  camera.distance = log_uniform(rng, 0.1, 100);
  camera.field_of_view = uniform(rng, 0.2, 1.2);
  camera.orthographic = chance(rng, 0.5);
  return camera;
}

TEST(Camera, StandardViewsLookWhereTheySay) {
  const auto expect_axes = [](StandardView view, Vector3 forward, Vector3 up) {
    const Camera camera = Camera::standard(view);
    EXPECT_LT((camera.forward() - forward).norm(), 1e-12) << to_string(view);
    EXPECT_LT((camera.up() - up).norm(), 1e-12) << to_string(view);
  };
  const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
  expect_axes(StandardView::front, y, z);
  expect_axes(StandardView::back, -y, z);
  expect_axes(StandardView::left, x, z);
  expect_axes(StandardView::right, -x, z);
  expect_axes(StandardView::top, -z, y);
  expect_axes(StandardView::bottom, z, -y);
  EXPECT_LT((Camera::standard(StandardView::iso).forward() - Vector3(-1, 1, -1).normalized()).norm(), 1e-12);
}

TEST(Camera, ViewNamesGoBothWays) {
  for (const char* name : {"iso", "front", "back", "left", "right", "top", "bottom"})
    EXPECT_EQ(to_string(*standard_view_from(name)), name);
  EXPECT_FALSE(standard_view_from("Front"));
  EXPECT_FALSE(standard_view_from(""));
}

TEST(Camera, MatricesAgreeWithProjection) {
  for_random(1, 100, [](std::mt19937_64& rng) {
    const Camera camera = random_camera(rng);
    const Projector projector(camera, picture_size);
    const Vector3 point = camera.target + random_vector(rng, 0.3 * camera.distance);
    const auto pixel = projector.project(point);
    ASSERT_TRUE(pixel);
    const Eigen::Vector4d clip =
        camera.projection_matrix(picture_size, {0.01, 1000}) * camera.view_matrix() * point.homogeneous();
    EXPECT_NEAR(pixel->x(), (clip.x() / clip.w() + 1) / 2 * picture_size.width, 1e-7);
    EXPECT_NEAR(pixel->y(), (1 - clip.y() / clip.w()) / 2 * picture_size.height, 1e-7);
    EXPECT_NEAR(pixel->z(), (point - camera.eye()).dot(camera.forward()), 1e-9 * camera.distance);
  });
}

TEST(Camera, RaysPassThroughWhatTheyShow) {
  for_random(2, 100, [](std::mt19937_64& rng) {
    const Camera camera = random_camera(rng);
    const Projector projector(camera, picture_size);
    const Vector3 point = camera.target + random_vector(rng, 0.3 * camera.distance);
    const Vector3 pixel = *projector.project(point);
    const Ray ray = projector.ray(pixel.head<2>());
    EXPECT_NEAR(ray.direction.norm(), 1, 1e-12);
    const Vector3 to = point - ray.origin;
    EXPECT_LT(to.cross(ray.direction).norm(), 1e-9 * camera.distance);
    EXPECT_GT(to.dot(ray.direction), 0);
    EXPECT_LT((projector.on_facing_plane(pixel.head<2>(), point) - point).norm(), 1e-9 * camera.distance);
  });
}

TEST(Camera, PointsBehindTheEyeHaveNoPixel) {
  const Camera camera = Camera::standard(StandardView::front);
  EXPECT_FALSE(Projector(camera, picture_size).project(camera.eye() - camera.forward()));
  EXPECT_FALSE(Projector(camera, picture_size).project(camera.eye()));
}

TEST(Camera, OrbitKeepsThePivotThereAndTheHorizonLevel) {
  for_random(3, 100, [](std::mt19937_64& rng) {
    Camera camera = Camera::standard(StandardView::iso);
    camera.orthographic = chance(rng, 0.5);
    const Vector3 pivot = random_vector(rng, 3);
    const Camera turned = camera.orbit(uniform(rng, -2, 2), uniform(rng, -0.5, 0.5), pivot);
    const auto before = Projector(camera, picture_size).project(pivot),
               after = Projector(turned, picture_size).project(pivot);
    EXPECT_LT((*before - *after).norm(), 1e-8);
    EXPECT_NEAR(turned.right().z(), 0, 1e-12);
    EXPECT_GE(turned.up().z(), -1e-12);
  });
}

TEST(Camera, OrbitStopsAtThePoles) {
  const Camera top = Camera::standard(StandardView::front).orbit(0, 10);
  EXPECT_LT((top.forward() + Vector3::UnitZ()).norm(), 1e-7);
  const Camera back = top.orbit(0, -pi / 2);
  EXPECT_LT((back.forward() - Vector3::UnitY()).norm(), 1e-7);
}

TEST(Camera, DraggingRightTurnsTheModelRight) {
  const Camera camera = Camera::standard(StandardView::front);
  const Vector3 nearest = camera.target - Vector3::UnitY();
  const auto moved = Projector(camera.orbit(0.1, 0), picture_size).project(nearest);
  EXPECT_GT(moved->x(), picture_size.width / 2.0 + 1);
  const auto down = Projector(camera.orbit(0, 0.1), picture_size).project(nearest);
  EXPECT_GT(down->y(), picture_size.height / 2.0 + 1);
}

TEST(Camera, PanFollowsTheCursor) {
  for_random(4, 50, [](std::mt19937_64& rng) {
    const Camera camera = random_camera(rng);
    const Camera panned = camera.pan(30, -12, picture_size);
    const auto pixel = Projector(panned, picture_size).project(camera.target);
    EXPECT_NEAR(pixel->x(), picture_size.width / 2.0 + 30, 1e-6);
    EXPECT_NEAR(pixel->y(), picture_size.height / 2.0 - 12, 1e-6);
  });
}

TEST(Camera, ZoomKeepsThePointUnderTheCursor) {
  for_random(5, 50, [](std::mt19937_64& rng) {
    const Camera camera = random_camera(rng);
    const Vector2 cursor(uniform(rng, 0, picture_size.width), uniform(rng, 0, picture_size.height));
    const Vector3 under = Projector(camera, picture_size).on_facing_plane(cursor, camera.target);
    const Camera zoomed = camera.zoom(0.8, cursor, picture_size);
    EXPECT_NEAR(zoomed.distance, 0.8 * camera.distance, 1e-12 * camera.distance);
    EXPECT_LT((Projector(zoomed, picture_size).project(under)->head<2>() - cursor).norm(), 1e-6);
  });
}

TEST(Camera, FrameShowsEverythingAndTouchesTheMargin) {
  for_random(6, 100, [](std::mt19937_64& rng) {
    std::vector<Vector3> points;
    for (int i = 0; i < 20; ++i) points.push_back(Vector3(5, 6, 7) + random_vector(rng, 2));
    const Camera camera = random_camera(rng).frame(points, picture_size);
    const Projector projector(camera, picture_size);
    double most = 0;
    for (const Vector3& point : points) {
      const auto pixel = projector.project(point);
      ASSERT_TRUE(pixel);
      most = std::max({most, std::abs(pixel->x() / picture_size.width * 2 - 1),
                       std::abs(pixel->y() / picture_size.height * 2 - 1)});
    }
    EXPECT_NEAR(most, 1 / 1.08, 0.02);
  });
}

TEST(Camera, FrameOfNothingOrOnePointIsSane) {
  const Camera camera = Camera::standard(StandardView::iso);
  EXPECT_EQ(camera.frame(Box3(), picture_size).distance, camera.distance);
  const std::vector<Vector3> bad{Vector3::Constant(NAN)};
  EXPECT_EQ(camera.frame(bad, picture_size).distance, camera.distance);
  const Camera at = camera.frame(Box3(Vector3(1, 2, 3), Vector3(1, 2, 3)), picture_size);
  EXPECT_GT(at.distance, 0);
  EXPECT_LT((at.target - Vector3(1, 2, 3)).norm(), 1e-9);
}

TEST(Camera, ClipRangeEnclosesTheBox) {
  for_random(7, 100, [](std::mt19937_64& rng) {
    const Vector3 low = random_vector(rng, 5), extent = random_vector(rng, 2).cwiseAbs();
    const Box3 box(low, low + extent);
    const Camera camera = random_camera(rng).frame(box, picture_size);
    const ClipRange clip = camera.clip_range(box);
    EXPECT_LT(clip.near_plane, clip.far_plane);
    if (!camera.orthographic) {
      EXPECT_GT(clip.near_plane, 0);
    }
    for (int i = 0; i < 8; ++i) {
      const double depth =
          (box.corner(static_cast<Box3::CornerType>(i)) - camera.eye()).dot(camera.forward());
      EXPECT_GE(depth, clip.near_plane);
      EXPECT_LE(depth, clip.far_plane);
    }
  });
}

TEST(Camera, MixEndsAtItsEndsAndStaysRigid) {
  const Camera a = Camera::standard(StandardView::front),
               b = Camera::standard(StandardView::top).pan(10, 5, picture_size);
  EXPECT_EQ(Camera::mix(a, b, 0).target, a.target);
  EXPECT_EQ(Camera::mix(a, b, 1).target, b.target);
  EXPECT_NEAR(Camera::mix(a, b, 0.3).orientation.norm(), 1, 1e-12);
}

TEST(Camera, FarFromZeroProjectsAsPreciselyAsNear) {
  Camera near_camera = Camera::standard(StandardView::iso), far_camera = near_camera;
  const Vector3 far_away(1e6, -2e6, 3e6), point(0.5, 0.25, -0.75);
  far_camera.target += far_away;
  const auto p = Projector(near_camera, picture_size).project(point),
             q = Projector(far_camera, picture_size).project(far_away + point);
  EXPECT_LT((*p - *q).norm(), 1e-6);
}

}  // namespace
}  // namespace hariko::test

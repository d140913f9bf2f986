// Two-point perspective and focal lengths: what the picture keeps, and that rays, matrices and drawings
// agree.

#include <cmath>
#include <numbers>

#include "render/drawing_camera.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

constexpr PixelSize wide_picture{900, 600};
constexpr double two_point_pi = std::numbers::pi;

/// Level camera in two-point perspective that looks from above or below by up to `steepest` radians.
Camera upright_camera(std::mt19937_64& rng, double steepest) {
  Camera camera = Camera::standard(StandardView::front);
  camera = camera.orbit(uniform(rng, -3, 3), uniform(rng, -steepest, steepest));
  camera.target = random_vector(rng, 10);
  camera.distance = log_uniform(rng, 0.1, 100);
  camera.field_of_view = uniform(rng, 0.2, 1.0);
  camera.two_point = true;
  return camera;
}

TEST(TwoPoint, VerticalsOfTheWorldAreUprightAndTheTargetStaysInTheMiddle) {
  for_random(31, 200, [](std::mt19937_64& rng) {
    const Camera camera = upright_camera(rng, 1.0);
    const Projector projector(camera, wide_picture);
    const Vector3 middle = *projector.project(camera.target);
    EXPECT_NEAR(middle.x(), 450, 1e-8);
    EXPECT_NEAR(middle.y(), 300, 1e-8);
    const Vector3 foot = camera.target + random_vector(rng, 0.2 * camera.distance);
    const auto bottom = projector.project(foot);
    const auto top = projector.project(foot + Vector3(0, 0, 0.1 * camera.distance));
    ASSERT_TRUE(bottom && top);
    EXPECT_NEAR(top->x(), bottom->x(), 1e-7);
    EXPECT_LT(top->y(), bottom->y());
    // The same camera with three vanishing points lets them run together.
    Camera plain = camera;
    plain.two_point = false;
    const Projector other(plain, wide_picture);
    if (std::abs(camera.lean()) > 0.2 && std::abs(bottom->x() - 450) > 50)
      EXPECT_GT(std::abs(other.project(foot)->x() -
                         other.project(foot + Vector3(0, 0, 0.1 * camera.distance))->x()),
                1e-3);
  });
}

TEST(TwoPoint, MatricesRaysAndDrawingsAgreeWithTheProjection) {
  for_random(32, 200, [](std::mt19937_64& rng) {
    Camera camera = upright_camera(rng, 1.5);
    if (chance(rng, 0.3)) camera = camera.trackball(0.3, 0.2, camera.target);  // with a tilted horizon
    const Projector projector(camera, wide_picture);
    const Vector3 point = camera.target + random_vector(rng, 0.2 * camera.distance);
    const auto pixel = projector.project(point);
    ASSERT_TRUE(pixel);
    const Eigen::Vector4d clip =
        camera.projection_matrix(wide_picture, {0.01, 1000}) * camera.view_matrix() * point.homogeneous();
    EXPECT_NEAR(pixel->x(), (clip.x() / clip.w() + 1) / 2 * wide_picture.width, 1e-7);
    EXPECT_NEAR(pixel->y(), (1 - clip.y() / clip.w()) / 2 * wide_picture.height, 1e-7);
    EXPECT_NEAR(pixel->z(), clip.w(), 1e-9 * camera.distance);
    const Ray ray = projector.ray(pixel->head<2>());
    EXPECT_LT((point - ray.origin).cross(ray.direction).norm(), 1e-9 * camera.distance);
    EXPECT_GT((point - ray.origin).dot(ray.direction), 0);
    EXPECT_LT((projector.on_facing_plane(pixel->head<2>(), point) - point).norm(), 1e-9 * camera.distance);
    const DrawingView drawing = drawing_view(camera, 900, 600, Box3(point, point), {});
    EXPECT_LT((drawing.project(point) - *pixel).norm(), 1e-7);
  });
}

TEST(TwoPoint, SteepViewsLeanLessWithoutAJump) {
  Camera camera = Camera::standard(StandardView::front);
  camera.two_point = true;
  double last = 0;
  for (int i = 0; i <= 900; ++i) {
    const double elevation = i * two_point_pi / 1800;
    const double lean = camera.orbit(0, elevation).lean();
    if (elevation <= two_point_pi / 3) EXPECT_NEAR(lean, elevation, 1e-9);
    EXPECT_LE(std::abs(lean - last), 2.1 * two_point_pi / 1800) << elevation;
    last = lean;
  }
  EXPECT_NEAR(last, 0, 1e-6) << "from above there is no upright plane";
  camera.orthographic = true;
  EXPECT_EQ(camera.orbit(0, 0.5).lean(), 0);
}

TEST(TwoPoint, FramingShowsEverything) {
  for_random(33, 100, [](std::mt19937_64& rng) {
    const Camera camera = upright_camera(rng, 1.4);
    std::vector<Vector3> points;
    for (int i = 0; i < 20; ++i) points.push_back(random_vector(rng, 5));
    const Camera framed = camera.frame(points, wide_picture);
    EXPECT_EQ(framed.orientation.coeffs(), camera.orientation.coeffs());
    const Projector projector(framed, wide_picture);
    double nearest_border = 1e9;
    for (const Vector3& point : points) {
      const auto pixel = projector.project(point);
      ASSERT_TRUE(pixel);
      for (const double room : {pixel->x(), 900 - pixel->x(), pixel->y(), 600 - pixel->y()}) {
        EXPECT_GT(room, 0);
        nearest_border = std::min(nearest_border, room);
      }
    }
    EXPECT_LT(nearest_border, 60) << "as large as possible";
  });
}

TEST(TwoPoint, PansFollowThePointerAndZoomsKeepWhatIsUnderIt) {
  for_random(34, 100, [](std::mt19937_64& rng) {
    const Camera camera = upright_camera(rng, 1.2);
    const Vector3 target = camera.target;
    const Vector3 panned = *Projector(camera.pan(30, -20, wide_picture), wide_picture).project(target);
    EXPECT_NEAR(panned.x(), 480, 1e-6);
    EXPECT_NEAR(panned.y(), 280, 1e-6);
    const Vector2 pixel(200, 450);
    const Vector3 under = Projector(camera, wide_picture).on_facing_plane(pixel, target);
    const Vector3 after = *Projector(camera.zoom(0.7, pixel, wide_picture), wide_picture).project(under);
    EXPECT_LT((after.head<2>() - pixel).norm(), 1e-6);
  });
}

TEST(TwoPoint, ClippingEnclosesTheBox) {
  for_random(35, 100, [](std::mt19937_64& rng) {
    const Camera camera = upright_camera(rng, 1.2);
    Box3 box(camera.target);
    box.extend(Vector3(camera.target + random_vector(rng, 0.3 * camera.distance)));
    const ClipRange range = camera.clip_range(box);
    for (int i = 0; i < 8; ++i) {
      const auto pixel =
          Projector(camera, wide_picture).project(box.corner(static_cast<Box3::CornerType>(i)));
      ASSERT_TRUE(pixel);
      EXPECT_GT(pixel->z(), range.near_plane);
      EXPECT_LT(pixel->z(), range.far_plane);
    }
  });
}

TEST(FocalLength, IsThatOfFilmOf36By24Millimetres) {
  // 24 mm of film at 50 mm: 2 atan(12 / 50) = 26.99 degrees, as tables of lenses say.
  EXPECT_NEAR(field_of_view_of(50) * 180 / two_point_pi, 26.99, 0.005);
  EXPECT_NEAR(field_of_view_of(15) * 180 / two_point_pi, 77.32, 0.005);
  for (const double length : {15.0, 35.0, 50.0, 135.0, 300.0})
    EXPECT_NEAR(focal_length_of(field_of_view_of(length)), length, 1e-10 * length);
}

TEST(FocalLength, ChangesKeepTheSizeOfTheTarget) {
  for_random(36, 100, [](std::mt19937_64& rng) {
    Camera camera = upright_camera(rng, 1.2);
    camera.two_point = chance(rng, 0.5);
    const Camera changed = camera.with_focal_length(uniform(rng, 15, 300));
    EXPECT_NEAR(changed.view_height(), camera.view_height(), 1e-12 * camera.view_height());
    EXPECT_EQ(changed.target, camera.target);
  });
}

}  // namespace
}  // namespace hariko::test

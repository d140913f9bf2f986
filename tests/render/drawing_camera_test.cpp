#include "render/drawing_camera.hpp"

#include "tests/support/random.hpp"

namespace hariko {

TEST(DrawingCamera, ThePageShowsWhatThePictureShows) {
  test::for_random(1, 50, [](std::mt19937_64& rng) {
    const double size = test::log_uniform(rng, 1e-3, 1e4);
    Camera camera =
        Camera::standard(StandardView::iso).orbit(test::uniform(rng, -3, 3), test::uniform(rng, -1, 1));
    camera.target = test::random_vector(rng, 5 * size);
    camera.distance = size * test::uniform(rng, 3, 10);
    camera.orthographic = test::chance(rng, 0.5);
    const PixelSize picture{800, 500};
    const double scale = test::log_uniform(rng, 0.1, 10);  // scale of the page to the picture
    const Box3 shown(camera.target - Vector3::Constant(size), camera.target + Vector3::Constant(size));
    const DrawingView view = drawing_view(camera, scale * 800, scale * 500, shown);
    const Projector projector(camera, picture);
    for (int i = 0; i < 20; ++i) {
      const Vector3 point = camera.target + test::random_vector(rng, size);
      const auto pixel = projector.project(point);
      ASSERT_TRUE(pixel.has_value());
      const Vector3 page = view.project(point);
      EXPECT_NEAR(page.x(), scale * pixel->x(), 1e-6 * scale);
      EXPECT_NEAR(page.y(), scale * pixel->y(), 1e-6 * scale);
      EXPECT_NEAR(page.z(), pixel->z(), 1e-9 * camera.distance);
      EXPECT_TRUE(view.in_front(page.z()));
    }
  });
}

TEST(DrawingCamera, TheSectionKeepsTheSameSide) {
  SectionPlane section;
  section.normal = Vector3(1, 2, -2) / 3;
  section.offset = 0.7;
  const Camera camera = Camera::standard(StandardView::front);
  const DrawingView view = drawing_view(camera, 100, 100, Box3(), section);
  ASSERT_TRUE(view.section.has_value());
  test::for_random(2, 30, [&](std::mt19937_64& rng) {
    const Vector3 point = test::random_vector(rng, 2);
    EXPECT_EQ(view.section->signedDistance(point) > 0, section.cuts(point));
  });
  EXPECT_FALSE(drawing_view(camera, 100, 100, Box3()).section.has_value());
}

}  // namespace hariko

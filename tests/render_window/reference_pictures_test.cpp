// Reference pictures as they are drawn: their place, opacity, order, the views they belong to, and how they
// come to the GPU.

#include "tests/render_window/gl_context.hpp"
#include "tests/render_window/models.hpp"

namespace hariko {
namespace {

using namespace hariko::test;

std::shared_ptr<const ReferenceImage> image_of(int width, int height,
                                               const std::function<Color(int, int)>& paint) {
  auto out = std::make_shared<ReferenceImage>();
  out->size = {width, height};
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.blend(x, y, paint(x, y), 1);
  while (true) {
    out->levels.push_back(image);
    if (image.width == 1 && image.height == 1) return out;
    Image half(std::max(1, image.width / 2), std::max(1, image.height / 2));
    for (int y = 0; y < half.height; ++y)
      for (int x = 0; x < half.width; ++x)
        std::copy_n(image.pixel(std::min(2 * x, image.width - 1), std::min(2 * y, image.height - 1)), 4,
                    half.pixel(x, y));
    image = half;
  }
}

constexpr Color red{1, 0, 0, 1}, green{0, 1, 0, 1}, blue{0, 0, 1, 1}, white{1, 1, 1, 1};

class ReferencePictures : public GlTest {
 protected:
  ReferencePictures() {
    camera.orthographic = true;
    camera.distance = 10;
    scene.background = Background::transparent;
    scene.grid.visible = false;
  }
  /// Seen from the front at this depth: larger is farther away.
  ScenePicture upright(std::shared_ptr<const ReferenceImage> image, double depth) {
    ScenePicture picture;
    picture.image = std::move(image);
    picture.half = {1, 1};
    picture.transform.topLeftCorner<3, 3>() = facing(PictureSide::front).toRotationMatrix();
    picture.transform.topRightCorner<3, 1>() = Vector3(0, depth, 0);
    picture.look.opacity = 1;
    return picture;
  }
  /// Pixel of the screen at a point of the front plane.
  std::array<int, 4> at(double x, double z) {
    const Image image = draw(scene, camera, size);
    const auto place = Projector(camera, size).project({x, 0, z}).value();
    const std::uint8_t* p = image.pixel(int(place.x()), int(place.y()));
    return {p[0], p[1], p[2], p[3]};
  }

  PixelSize size{200, 160};
  Camera camera = Camera::standard(StandardView::front);
  Scene scene;
};

using Pixel = std::array<int, 4>;

TEST_F(ReferencePictures, StandAtTheirPlaceTheRightWayUp) {
  scene.pictures = {upright(
      image_of(64, 64,
               [](int x, int y) { return y < 32 ? (x < 32 ? red : green) : (x < 32 ? blue : white); }),
      0)};
  EXPECT_EQ(at(-0.5, 0.5), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(at(0.5, 0.5), (Pixel{0, 255, 0, 255}));
  EXPECT_EQ(at(-0.5, -0.5), (Pixel{0, 0, 255, 255}));
  EXPECT_EQ(at(0.5, -0.5), (Pixel{255, 255, 255, 255}));
  EXPECT_EQ(at(1.05, 0), (Pixel{0, 0, 0, 0})) << "beside it";
  scene.pictures[0].transform.topRightCorner<3, 1>() = Vector3(1.2, 0, 0);
  EXPECT_EQ(at(0.7, 0.5), (Pixel{255, 0, 0, 255})) << "moved";
}

TEST_F(ReferencePictures, ShowAsMuchAsTheirOpacitySays) {
  scene.pictures = {upright(image_of(8, 8, [](int, int) { return red; }), 0)};
  for (const double opacity : {0.25, 0.5, 0.9}) {
    scene.pictures[0].look.opacity = opacity;
    const Pixel pixel = at(0, 0);
    EXPECT_NEAR(pixel[3], 255 * opacity, 1.5);
    EXPECT_NEAR(pixel[0], 255, 2) << "the colour is not darkened";
    EXPECT_EQ(pixel[1], 0);
  }
  scene.pictures[0].look.opacity = 0;
  EXPECT_EQ(at(0, 0)[3], 0);
}

TEST_F(ReferencePictures, LieBehindAmongOrBeforeTheSurfaces) {
  SceneObject ball = object_of(sphere(0.5), SurfaceMap::shaded, 16);
  scene.objects = {ball};
  const auto shows_red = [&] {
    const Pixel pixel = at(0, 0);
    return pixel[0] > 200 && pixel[1] < 40;
  };
  const auto image = image_of(8, 8, [](int, int) { return red; });
  for (const double depth : {-3.0, 3.0}) {
    scene.pictures = {upright(image, depth)};
    scene.pictures[0].look.layer = PictureLayer::space;
    EXPECT_EQ(shows_red(), depth < 0) << "as it lies: " << depth;
    scene.pictures[0].look.layer = PictureLayer::behind;
    EXPECT_FALSE(shows_red()) << depth;
    EXPECT_EQ(at(0.8, 0.8), (Pixel{255, 0, 0, 255})) << "beside the ball it shows";
    scene.pictures[0].look.layer = PictureLayer::front;
    EXPECT_TRUE(shows_red()) << depth;
  }
  // The nearer of two translucent ones covers the farther, in whatever order they are listed.
  scene.objects.clear();
  const auto other = image_of(8, 8, [](int, int) { return green; });
  for (const bool swapped : {false, true}) {
    scene.pictures = {upright(image, 1), upright(other, -1)};
    for (ScenePicture& picture : scene.pictures) picture.look.opacity = 0.75;
    if (swapped) std::swap(scene.pictures[0], scene.pictures[1]);
    EXPECT_GT(at(0, 0)[1], 180) << swapped;
    EXPECT_LT(at(0, 0)[0], 90) << swapped;
  }
}

TEST_F(ReferencePictures, OfOneViewAreHiddenInTheOthers) {
  scene.pictures = {upright(image_of(8, 8, [](int, int) { return red; }), 0)};
  scene.pictures[0].look.only_from = PictureSide::front;
  EXPECT_EQ(at(0, 0)[3], 255);
  camera = camera.orbit(0.01, 0);
  EXPECT_EQ(at(0, 0)[3], 0) << "while the view turns";
  scene.pictures[0].look.only_from.reset();
  EXPECT_EQ(at(0, 0)[3], 255);
}

TEST_F(ReferencePictures, ComeToTheGpuBitByBitAndLeaveItWhenHidden) {
  // Stripes that a coarse level shows as grey.
  const auto image = image_of(512, 256, [](int x, int) { return x % 2 ? white : red; });
  scene.pictures = {upright(image, 0)};
  scene.pictures[0].half = {1, 0.5};
  Camera close = camera;
  close.distance = 1;
  DrawOptions options{size, 1, 0, 40'000};
  int drawings = 0;
  std::size_t uploaded = 0;
  do {
    ASSERT_TRUE(renderer_->draw(scene, close, options).ok());
    uploaded += renderer_->statistics().uploaded_bytes;
    EXPECT_LE(renderer_->statistics().uploaded_bytes, 40'000U + 512 * 4);
    EXPECT_GT(renderer_->read().pixel(100, 80)[3], 0) << "it shows from the beginning";
    ++drawings;
  } while (renderer_->statistics().unfinished && drawings < 100);
  EXPECT_EQ(uploaded, image->bytes());
  EXPECT_GE(drawings, int(image->bytes() / 45'000));
  const Image bit_by_bit = renderer_->read();
  ASSERT_TRUE(renderer_->draw(scene, close, options).ok());
  EXPECT_EQ(renderer_->statistics().uploaded_bytes, 0U) << "it is there";
  // Hidden, its memory is free: shown again, it comes again.
  Scene without = scene;
  without.pictures.clear();
  ASSERT_TRUE(renderer_->draw(without, close, options).ok());
  options.upload_limit = std::size_t(-1);
  ASSERT_TRUE(renderer_->draw(scene, close, options).ok());
  EXPECT_EQ(renderer_->statistics().uploaded_bytes, image->bytes());
  EXPECT_FALSE(renderer_->statistics().unfinished);
  EXPECT_EQ(renderer_->read().rgba, bit_by_bit.rgba);
}

TEST_F(ReferencePictures, MissingOnesAreACrossedFrame) {
  ScenePicture gone = upright(nullptr, 0);
  gone.missing = true;
  scene.pictures = {gone};
  EXPECT_GT(at(0, 0)[3], 0) << "where the lines cross";
  EXPECT_GT(at(-1, 0)[3], 0) << "the frame";
  EXPECT_EQ(at(0.5, 0)[3], 0) << "nothing between";
}

}  // namespace
}  // namespace hariko

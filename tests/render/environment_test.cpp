// Environments: the pictures made by formula, their levels for rough surfaces, and files of them.

#include <cmath>

#include "render/environment.hpp"
#include "render/image.hpp"
#include "render/reference_image.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

constexpr std::array made_by_formula{EnvironmentKind::studio, EnvironmentKind::tubes,
                                     EnvironmentKind::horizon, EnvironmentKind::overcast};

double luminance(const std::array<double, 3>& c) {
  return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}
double brightness(const RadianceImage& image) {
  return luminance(mean_radiance(image));
}

/// Bytes of a PNG file of all directions: red above the horizon, black below it.
std::string png_of_red_sky(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      image.pixel(x, y)[0] = y < height / 2 ? 255 : 0;
      image.pixel(x, y)[3] = 255;
    }
  test::TemporaryFolder folder;
  EXPECT_TRUE(write_png(folder.path() / "sky.png", image).ok());
  return test::slurp(folder.path() / "sky.png");
}

TEST(EnvironmentPicture, IsFiniteAndHasNoNegativeLight) {
  for (const EnvironmentKind kind : made_by_formula)
    for (const Radiance& pixel : environment_picture(kind).pixels)
      for (const float channel : pixel) ASSERT_TRUE(std::isfinite(channel) && channel >= 0) << int(kind);
}

TEST(EnvironmentPicture, HasNoSeamWhereItsEndsMeet) {
  for (const EnvironmentKind kind : made_by_formula) {
    const RadianceImage image = environment_picture(kind);
    // The greatest step between neighbours: edges of lights are as sharp everywhere.
    float inside = 0, across = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        for (std::size_t c = 0; c < 3; ++c) {
          const float step = std::abs(image.at(x, y)[c] - image.at((x + 1) % image.width, y)[c]);
          float& greatest = x + 1 == image.width ? across : inside;
          greatest = std::max(greatest, step);
        }
    EXPECT_LE(across, 1.05F * inside) << int(kind);
  }
}

TEST(EnvironmentPicture, IsAboutAsBrightAsTheOthers) {
  for (const EnvironmentKind kind : made_by_formula) {
    const double mean = brightness(environment_picture(kind));
    EXPECT_GT(mean, 0.25) << int(kind);
    EXPECT_LT(mean, 0.60) << int(kind);
  }
}

TEST(EnvironmentPicture, IsTheSameEveryTime) {
  for (const EnvironmentKind kind : made_by_formula)
    EXPECT_EQ(environment_picture(kind).pixels, environment_picture(kind).pixels);
}

TEST(EnvironmentPicture, ShowsInItsMiddleWhatTheFrontFaces) {
  EXPECT_LT((environment_direction(0.5, 0.5) - Vector3::UnitY()).norm(), 1e-12);
  EXPECT_LT((environment_direction(0.75, 0.5) - Vector3::UnitX()).norm(), 1e-12);
  EXPECT_LT((environment_direction(0.3, 0) - Vector3::UnitZ()).norm(), 1e-12);
}

TEST(EnvironmentLevels, HaveHalfTheSizeEachAndKeepTheLight) {
  for (const EnvironmentKind kind : made_by_formula) {
    const EnvironmentLevels made = environment_levels(environment_picture(kind));
    ASSERT_EQ(made.levels.size(), std::size_t(environment_level_count));
    const auto mean = mean_radiance(made.levels.front());
    for (std::size_t i = 0; i < made.levels.size(); ++i) {
      const RadianceImage& level = made.levels[i];
      EXPECT_EQ(level.width, environment_width >> i);
      EXPECT_EQ(level.height, environment_height >> i);
      const auto now = mean_radiance(level);
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(now[c], mean[c], 0.01 * mean[c]) << int(kind) << i;
    }
  }
}

/// A single bright texel, anywhere: what a picture of the sun amounts to.
TEST(EnvironmentLevels, KeepTheLightOfASun) {
  for (const int row : {0, 3, 20, 63, 64, 127}) {
    RadianceImage picture(environment_width, environment_height);
    picture.at(17, row) = {1000, 500, 250};
    const EnvironmentLevels made = environment_levels(picture);
    const auto mean = mean_radiance(picture);
    for (const RadianceImage& level : made.levels)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(mean_radiance(level)[c], mean[c], 0.01 * mean[c]) << row << " " << level.width;
  }
}

TEST(EnvironmentLevels, LeaveEvenLightAsItIs) {
  RadianceImage picture(environment_width, environment_height);
  for (Radiance& pixel : picture.pixels) pixel = {0.5F, 1.0F, 2.0F};
  for (const RadianceImage& level : environment_levels(picture).levels)
    for (const Radiance& pixel : level.pixels) {
      EXPECT_NEAR(pixel[0], 0.5F, 1e-5F);
      EXPECT_NEAR(pixel[2], 2.0F, 1e-5F);
    }
}

TEST(EnvironmentLevels, BlurMoreAndMore) {
  double before = 1e300;
  for (const RadianceImage& level : environment_levels(environment_picture(EnvironmentKind::tubes)).levels) {
    float brightest = 0;
    for (const Radiance& pixel : level.pixels) brightest = std::max(brightest, pixel[1]);
    EXPECT_LT(double(brightest), before);
    before = double(brightest);
  }
}

TEST(EnvironmentAxes, TurnAnticlockwiseFromAbove) {
  Environment environment;
  EXPECT_EQ(environment.axes(), Matrix3::Identity());
  environment.turn = 90;
  // The light that stood at +y stands at -x then: that direction looks up where +y was
  EXPECT_LT((environment.axes() * Vector3(-1, 0, 0) - Vector3::UnitY()).norm(), 1e-12);
  const Matrix3 quarter = environment.axes();
  environment.turn = 450;
  EXPECT_EQ(environment.axes(), quarter) << "the same bits";
  environment.turn = -270;
  EXPECT_EQ(environment.axes(), quarter);
}

TEST(ReadEnvironment, ReducesPicturesOfAnySizeInLinearLight) {
  for (const int height : {2, 100, 128, 300}) {
    const auto read = test::must(read_environment(png_of_red_sky(2 * height, height)));
    EXPECT_EQ(read->width, environment_width);
    EXPECT_EQ(read->height, environment_height);
    EXPECT_NEAR(read->at(5, 3)[0], 1, 1e-5F);
    EXPECT_NEAR(read->at(200, 100)[0], 0, 1e-5F);
    EXPECT_NEAR(mean_radiance(*read)[0], 0.5, 1e-6) << height;
    EXPECT_EQ(mean_radiance(*read)[1], 0);
  }
}

TEST(ReadEnvironment, ReducesRadianceFiles) {
  std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n";
  // Above 4 and below 1, in all channels: mantissa 128, and half a step
  for (const char exponent :
       {char(131), char(131), char(131), char(131), char(129), char(129), char(129), char(129)})
    file += std::string(3, char(128)) + exponent;
  const auto read = test::must(read_environment(file));
  EXPECT_NEAR(read->at(0, 0)[1], 4 * 128.5F / 128, 1e-4F);
  EXPECT_NEAR(read->at(255, 127)[1], 128.5F / 128, 1e-4F);
}

TEST(ReadEnvironment, RefusesOtherFilesAndShapesWithASentence) {
  const auto code = [](const std::string& file) { return read_environment(file).error().code; };
  EXPECT_EQ(code(""), e_picture_kind);
  EXPECT_EQ(code("no picture"), e_picture_kind);
  const auto square = read_environment(png_of_red_sky(100, 100));
  test::must_fail(square, e_environment_shape);
  EXPECT_NE(square.error().text.find("100 x 100"), std::string::npos);
  EXPECT_EQ(code("#?RADIANCE\n\n-Y 4 +X 4\n"), e_environment_shape);
  EXPECT_EQ(code("#?RADIANCE\n\n-Y 4 +X 8\n"), e_image_read);
}

}  // namespace
}  // namespace hariko

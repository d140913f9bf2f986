#include "render/image.hpp"

#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>

#include "core/base/files/file_io.hpp"
#include "render/legend.hpp"
#include "render/text_painter.hpp"
#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko::test {
namespace {

class PngFile : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "image.png";
};

Image random_image(std::mt19937_64& rng, int width, int height) {
  Image image(width, height);
  for (auto& byte : image.rgba) byte = static_cast<std::uint8_t>(rng());
  return image;
}

TEST_F(PngFile, RoundTripKeepsEveryPixelInItsPlace) {
  for_random(9, 5, [&](std::mt19937_64& rng) {
    const Image image = random_image(rng, uniform_int(rng, 1, 70), uniform_int(rng, 1, 50));
    ASSERT_TRUE(write_png(path_, image).ok());
    const Result<Image> back = must(read_png(path_));
    EXPECT_EQ(back->width, image.width);
    EXPECT_EQ(back->height, image.height);
    EXPECT_EQ(back->rgba, image.rgba);
  });
}

TEST_F(PngFile, AFolderThatDoesNotExistIsAnError) {
  must_fail(write_png("/nonexistent-folder/a.png", Image(2, 2)), e_file_write);
}

TEST_F(PngFile, BrokenFilesAreErrors) {
  std::mt19937_64 rng(3);
  ASSERT_TRUE(write_png(path_, random_image(rng, 40, 40)).ok());
  const std::string whole = read_file(path_).value();
  for (const std::size_t length : {std::size_t(0), std::size_t(7), std::size_t(30), whole.size() / 2}) {
    std::ofstream(path_, std::ios::binary) << whole.substr(0, length);
    const Result<Image> back = read_png(path_);
    ASSERT_FALSE(back.ok()) << length;
    EXPECT_EQ(back.error().code, e_image_read);
  }
}

TEST(Image, DownsamplingAveragesLight) {
  Image image(4, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x)
      for (int c = 0; c < 4; ++c) image.pixel(x, y)[c] = c == 3 || x >= 2 || (x + y) % 2 == 0 ? 255 : 0;
  const Image half = downsample(image, 2);
  ASSERT_EQ(half.width, 2);
  ASSERT_EQ(half.height, 1);
  EXPECT_NEAR(half.pixel(0, 0)[0], 188, 1);  // half the light is 188 of 255 in sRGB
  EXPECT_EQ(half.pixel(1, 0)[0], 255);
  EXPECT_EQ(half.pixel(0, 0)[3], 255);
}

TEST(Image, BlendingMixesAndClips) {
  Image image(2, 1);
  image.blend(0, 0, {1, 0, 0, 1}, 1);
  EXPECT_EQ(image.pixel(0, 0)[0], 255);
  EXPECT_EQ(image.pixel(0, 0)[3], 255);
  image.blend(0, 0, {0, 0, 1, 1}, 0.5);
  EXPECT_NEAR(image.pixel(0, 0)[0], 128, 1);
  EXPECT_NEAR(image.pixel(0, 0)[2], 128, 1);
  const Image before = image;
  image.blend(-1, 0, {1, 1, 1, 1}, 1);
  image.blend(0, 5, {1, 1, 1, 1}, 1);
  EXPECT_EQ(image.rgba, before.rgba);
}

TEST(Legend, BarRunsFromLowToHigh) {
  Image image(400, 400);
  const Legend legend{SurfaceMap::mean, {-2, 2}, "1/mm", {}, true, 1};
  paint_legend(image, legend);
  const auto expect_at = [&](double fraction) {
    const int y = static_cast<int>(372 - fraction * 200);
    const Color wanted = color_at(ColorScale::diverging, fraction);
    EXPECT_NEAR(image.pixel(31, y)[0], wanted.r * 255, 4) << fraction;
    EXPECT_NEAR(image.pixel(31, y)[2], wanted.b * 255, 4) << fraction;
  };
  for (const double fraction : {0.1, 0.3, 0.5, 0.7, 0.9}) expect_at(fraction);
}

/// Pixels right of the bar, where the numbers stand, that are neither panel nor background.
int ink_of_numbers(const Image& image) {
  int ink = 0;
  for (int y = 165; y < 385; ++y)
    for (int x = 50; x < 120; ++x) ink += image.pixel(x, y)[0] > 150 ? 1 : 0;
  return ink;
}

/// Pictures of machines without fonts had legends without numbers.
TEST(Legend, HasNumbersAndTitleWithoutAnyFont) {
  const Legend legend{SurfaceMap::mean, {-2, 2}, "1/mm\u00b2", {}, true, 1};
  for (const std::optional<FontFile>& font :
       {std::optional<FontFile>(), std::optional(FontFile{"/nowhere.ttf", 0, ""}), font_files().text}) {
    Image image(400, 400);
    paint_legend(image, legend, font);
    EXPECT_GT(ink_of_numbers(image), 60) << (font ? font->path : "none");
  }
}

/// The picture of a text is turned with it.
TEST(TextPainter, TurnsLettersOfDots) {
  const auto ink = [](double angle) {
    Image image(200, 200);
    TextPainter painter{std::optional<FontFile>()};
    painter.paint_turned(image, "F1", {100, 100}, angle, 60, 43, {1, 1, 1, 1});
    return image;
  };
  const Image level = ink(0), quarter = ink(std::numbers::pi / 2);
  int marks = 0;
  for (int y = 1; y < 199; ++y)
    for (int x = 1; x < 199; ++x) {
      marks += level.pixel(x, y)[3] > 0 ? 1 : 0;
      // Counter-clockwise, about the middle between the pixels 99 and 100.
      EXPECT_NEAR(level.pixel(x, y)[3], quarter.pixel(y, 199 - x)[3], 40) << x << ' ' << y;
    }
  EXPECT_GT(marks, 500);
}

TEST(Legend, FitsTinyPictures) {
  Image image(20, 10);
  paint_legend(image, Legend{});
  Image empty;
  paint_legend(empty, Legend{});
}

}  // namespace
}  // namespace hariko::test

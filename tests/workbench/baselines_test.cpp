// Baseline pictures: what the scenes of the workspaces look like, beside pictures that were looked at. They
// are small and compared with a threshold, as drivers draw edges and shades differently.
// HARIKO_BASELINES=write makes them anew, to be looked at; a picture that differs is kept beside the test, in
// failed_baselines.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "core/document/file.hpp"
#include "render/image.hpp"
#include "tests/support/must.hpp"
#include "tests/support/places.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

struct BaselineScene {
  const char *name, *sample;
  std::vector<const char*> commands;  ///< run one after the other
  ThemeId theme = ThemeId::dark;
};

const std::vector<BaselineScene>& baseline_scenes() {
  static const std::vector<BaselineScene> scenes = {
      {"polyhedron", "fig2", {"select.edges", "select.all"}},
      {"polyhedron_light", "fig5d", {"analyse.tensions"}, ThemeId::light},
      {"patches", "wheel_arch", {}},
      {"solids", "solids_four", {}},
      {"skin", "skin_car_smooth", {"analyse.isophotes"}},
      {"outline", "sphere_holes", {}},
      {"analysis_zebra", "car", {"analyse.zebra"}},
      {"analysis_mean", "torus", {"analyse.mean"}},
      {"making_draft", "solids_bottle", {"analyse.draft"}},
      {"arranging", "cube", {"select.objects", "select.all", "object.array_row"}},
  };
  return scenes;
}

/// A third of the size: means of nine pixels.
Image small_picture(const Image& image) {
  constexpr int block = 3;
  Image out(image.width / block, image.height / block);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      for (int channel = 0; channel < 4; ++channel) {
        int sum = 0;
        for (int row = 0; row < block; ++row)
          for (int column = 0; column < block; ++column)
            sum += image.pixel(block * x + column, block * y + row)[channel];
        out.pixel(x, y)[channel] = static_cast<std::uint8_t>(sum / (block * block));
      }
  return out;
}

Image drawn_scene(test::HeadlessWorkbench& bench, ThemeId theme) {
  constexpr PixelSize size{480, 360};
  constexpr int unused_picture = 6;  // no view draws into it
  Scene scene = bench.workbench().viewport().scene().scene();
  scene.background = theme == ThemeId::light ? Background::light : Background::dark;
  const Camera camera = framed(Camera::standard(StandardView::iso), scene, size);
  const auto done = bench.renderer().draw(scene, camera, {size, 4, unused_picture});
  EXPECT_TRUE(done.ok());
  Image image = bench.renderer().read(unused_picture);
  bench.renderer().forget(unused_picture);
  return small_picture(image);
}

/// Mean difference of the channels, 0 .. 255, and the share of pixels that are far from each other.
struct PictureDifference {
  double mean = 0, far = 0;
};

PictureDifference difference_of(const Image& a, const Image& b) {
  constexpr int far_apart = 40;
  PictureDifference out;
  const int pixels = a.width * a.height;
  for (int i = 0; i < pixels; ++i) {
    int largest = 0;
    for (int channel = 0; channel < 3; ++channel) {
      const auto at = static_cast<std::size_t>(4 * i + channel);
      const int apart = std::abs(int(a.rgba[at]) - int(b.rgba[at]));
      out.mean += apart / (3.0 * pixels);
      largest = std::max(largest, apart);
    }
    if (largest > far_apart) out.far += 1.0 / pixels;
  }
  return out;
}

class Baselines : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Baselines, LookAsTheyDidWhenTheyWereLookedAt) {
  const BaselineScene& wanted = baseline_scenes().at(GetParam());
  const std::string samples = test::source_folder() + "/assets/samples/";
  test::HeadlessWorkbench bench(test::must(load_document(samples + wanted.sample + ".hariko")).value());
  bench.wait_for_surfaces();
  for (const char* command : wanted.commands) {
    const auto outcome = bench.workbench().commands().run(command);
    ASSERT_TRUE(outcome.ran) << command << ": " << outcome.reason;
    bench.frames(2);
  }
  bench.wait_for_surfaces();
  const Image now = drawn_scene(bench, wanted.theme);
  const std::string file = std::string(wanted.name) + ".png";
  const fs::path kept = fs::path(test::source_folder()) / "tests" / "workbench" / "baselines" / file;
  if (const char* write = std::getenv("HARIKO_BASELINES"); write && std::string(write) == "write") {
    fs::create_directories(kept.parent_path());
    ASSERT_TRUE(write_png(kept, now).ok());
    GTEST_SKIP() << kept << " is new: look at it";
  }
  const auto before = read_png(kept);
  ASSERT_TRUE(before.ok()) << kept << " is not there; HARIKO_BASELINES=write makes it";
  ASSERT_EQ(before->width, now.width);
  ASSERT_EQ(before->height, now.height);
  const PictureDifference difference = difference_of(*before, now);
  const bool alike = difference.mean < 2 && difference.far < 0.015;
  if (!alike) {
    fs::create_directories("failed_baselines");
    EXPECT_TRUE(write_png(fs::path("failed_baselines") / file, now).ok());
  }
  EXPECT_TRUE(alike) << "mean difference " << difference.mean << " of 255, " << 100 * difference.far
                     << " % of the pixels far off; the picture is in failed_baselines/" << file;
}

INSTANTIATE_TEST_SUITE_P(Workspaces, Baselines, ::testing::Range(std::size_t(0), baseline_scenes().size()),
                         [](const ::testing::TestParamInfo<std::size_t>& info) {
                           return std::string(baseline_scenes().at(info.param).name);
                         });

TEST(PictureComparison, NoticesWhatAnEyeWould) {
  Image plain(20, 10);
  std::fill(plain.rgba.begin(), plain.rgba.end(), std::uint8_t(100));
  EXPECT_EQ(difference_of(plain, plain).mean, 0);
  Image spotted = plain;
  for (int x = 0; x < 10; ++x) spotted.pixel(x, 0)[0] = 200;
  EXPECT_NEAR(difference_of(plain, spotted).far, 10.0 / 200, 1e-12);
  Image lighter = plain;
  for (std::uint8_t& value : lighter.rgba) value = static_cast<std::uint8_t>(value + 10);
  EXPECT_NEAR(difference_of(plain, lighter).mean, 10, 1e-9);
  EXPECT_EQ(difference_of(plain, lighter).far, 0);
}

}  // namespace
}  // namespace hariko

// Pictures of samples, as the build draws them.

#include "app/pictures/sample_pictures.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <set>

#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

/// Assets with some of the samples.
void copy_samples(const fs::path& assets, std::initializer_list<const char*> names) {
  fs::create_directories(assets / "samples");
  for (const char* name : names)
    fs::copy_file(fs::path(test::source_folder()) / "assets" / "samples" / name, assets / "samples" / name);
}

std::size_t colours_of(const Image& image) {
  std::set<std::array<std::uint8_t, 3>> colours;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    colours.insert({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
  return colours.size();
}

TEST(SamplePictures, ShowOneOfEveryKindInBothThemes) {
  test::TemporaryFolder folder;
  copy_samples(folder.path(), {"cube.hariko", "solids_t.hariko", "skin_smooth.hariko", "saddle.hariko"});
  const auto made = make_sample_pictures(folder.path(), folder.path() / "out");
  ASSERT_TRUE(made.ok()) << made.error().text;
  EXPECT_EQ(*made, 4U);
  EXPECT_TRUE(fs::exists(folder.path() / "out" / "complete"));
  for (const char* name : {"cube", "solids_t", "skin_smooth", "saddle"}) {
    SCOPED_TRACE(name);
    const auto dark = read_png(folder.path() / "out" / (std::string(name) + "-dark.png"));
    const auto light = read_png(folder.path() / "out" / (std::string(name) + "-light.png"));
    ASSERT_TRUE(dark.ok() && light.ok());
    EXPECT_DOUBLE_EQ(double(dark->width) / dark->height, 1.5);
    EXPECT_GT(colours_of(*dark), 500U) << "a model, and not its background alone";
    EXPECT_LT(dark->pixel(0, 0)[0], 100);
    EXPECT_GT(light->pixel(0, 0)[0], 200);
  }
}

TEST(SamplePictures, NameTheSampleThatShowsNothing) {
  test::TemporaryFolder folder;
  fs::create_directories(folder.path() / "samples");
  std::ofstream(folder.path() / "samples" / "broken.hariko") << "{}";
  const auto made = make_sample_pictures(folder.path(), folder.path() / "out");
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, e_sample_picture);
  EXPECT_NE(made.error().text.find("broken.hariko"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder.path() / "out" / "complete"));
}

}  // namespace
}  // namespace hariko

// Radiance pictures: both run-length encodings, flat rows, and files that are none.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "render/read_radiance.hpp"

namespace hariko {
namespace {

using RadianceBytesOf = std::vector<std::array<std::uint8_t, 4>>;

std::string radiance_file(int width, int height, const std::string& lines = "FORMAT=32-bit_rle_rgbe\n") {
  return "#?RADIANCE\n" + lines + "\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
}
std::string raw_bytes(std::initializer_list<int> values) {
  std::string out;
  for (const int value : values) out += char(value);
  return out;
}

/// A row in the newer encoding, with runs of at most `longest` values.
std::string with_runs(std::span<const std::array<std::uint8_t, 4>> row, std::size_t longest) {
  std::string out = raw_bytes({2, 2, int(row.size() / 256), int(row.size() % 256)});
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t x = 0; x < row.size();) {
      std::size_t count = 1;
      while (x + count < row.size() && count < longest && row[x + count][c] == row[x][c]) ++count;
      if (count > 1)
        out += raw_bytes({int(128 + count), row[x][c]});
      else
        out += raw_bytes({1, row[x][c]});
      x += count;
    }
  return out;
}

std::string flat_row(std::span<const std::array<std::uint8_t, 4>> row) {
  std::string out;
  for (const auto& pixel : row) out += raw_bytes({pixel[0], pixel[1], pixel[2], pixel[3]});
  return out;
}

/// Rows of a file in the middles of their channels' intervals.
Result<std::vector<Radiance>> pixels_of(const std::string& file) {
  std::vector<Radiance> out;
  int next = 0;
  const auto read = read_radiance(file, [&](int row, std::span<const Radiance> pixels) {
    EXPECT_EQ(row, next++);
    out.insert(out.end(), pixels.begin(), pixels.end());
  });
  if (!read) return read.error();
  return out;
}

/// The sentence of a file that is refused; empty, and a failure, where it is read.
std::string why_no_radiance(const std::string& file) {
  const auto read = pixels_of(file);
  EXPECT_FALSE(read.ok());
  if (read.ok()) return {};
  EXPECT_EQ(read.error().code, e_image_read);
  EXPECT_FALSE(read.error().remedy.empty());
  return read.error().text;
}

Radiance value_of(const std::array<std::uint8_t, 4>& p, double factor = 1) {
  Radiance out{};
  for (std::size_t c = 0; c < 3 && p[3] > 0; ++c)
    out[c] = static_cast<float>((p[c] + 0.5) * std::pow(2.0, int(p[3]) - 136) * factor);
  return out;
}

TEST(ReadRadiance, AllEncodingsGiveTheSamePixels) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const int width : {1, 7, 8, 9, 200, 700}) {
    const int height = 3;
    std::string plain = radiance_file(width, height), runs = plain;
    std::vector<Radiance> wanted;
    for (int y = 0; y < height; ++y) {
      RadianceBytesOf row(static_cast<std::size_t>(width));
      for (std::size_t x = 0; x < row.size(); ++x) {
        row[x] = {std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random()),
                  std::uint8_t(120 + random() % 20)};
        if (row[x][0] < 3) row[x][0] = 3;  // neither a repetition nor the mark of the newer encoding
        if (x > 0 && random() % 3 > 0) row[x] = row[x - 1];
        wanted.push_back(value_of(row[x]));
      }
      plain += flat_row(row);
      runs += width >= 8 ? with_runs(row, 1 + random() % 127) : flat_row(row);
    }
    const auto flat_pixels = pixels_of(plain), run_pixels = pixels_of(runs);
    ASSERT_TRUE(flat_pixels.ok()) << flat_pixels.error().text;
    ASSERT_TRUE(run_pixels.ok()) << run_pixels.error().text;
    EXPECT_EQ(*flat_pixels, wanted);
    EXPECT_EQ(*run_pixels, wanted);
    EXPECT_EQ(radiance_size(plain)->width, width);
    EXPECT_EQ(radiance_size(plain)->height, height);
  }
}

TEST(ReadRadiance, TheOlderEncodingRepeatsPixelsAndCountsFurtherRepetitions256Times) {
  const std::array<std::uint8_t, 4> red{200, 10, 10, 129}, green{10, 200, 10, 129};
  const auto three = pixels_of(radiance_file(4, 1) + raw_bytes({200, 10, 10, 129, 1, 1, 1, 3}));
  ASSERT_TRUE(three.ok()) << three.error().text;
  EXPECT_EQ(*three, std::vector<Radiance>(4, value_of(red)));
  // 1 + 4 + 1 * 256 of one colour and 2 of another
  const auto many = pixels_of(radiance_file(263, 1) + raw_bytes({200, 10, 10, 129, 1,  1,   1, 4, 1, 1,
                                                                 1,   1,  10, 200, 10, 129, 1, 1, 1, 1}));
  ASSERT_TRUE(many.ok()) << many.error().text;
  ASSERT_EQ(many->size(), 263U);
  EXPECT_EQ((*many)[260], value_of(red));
  EXPECT_EQ((*many)[261], value_of(green));
  EXPECT_EQ((*many)[262], value_of(green));
}

TEST(ReadRadiance, ExposuresAreDividedOutAndAnExponentOfZeroIsBlack) {
  const auto read = pixels_of(radiance_file(2, 1, "EXPOSURE=4\nSOFTWARE=none\nEXPOSURE= 0.5 \n") +
                              raw_bytes({128, 64, 32, 129, 128, 128, 128, 0}));
  ASSERT_TRUE(read.ok()) << read.error().text;
  EXPECT_EQ((*read)[0], value_of({128, 64, 32, 129}, 0.5));
  EXPECT_EQ((*read)[1], Radiance{});
}

TEST(ReadRadiance, TheBrightestPixelIsFinite) {
  const auto read = pixels_of(radiance_file(1, 1, "EXPOSURE=1e-30\n") + raw_bytes({255, 255, 255, 255}));
  ASSERT_TRUE(read.ok());
  EXPECT_TRUE(std::isfinite((*read)[0][0]));
}

TEST(ReadRadiance, DamagedHeadersAreRefusedWithASentence) {
  EXPECT_NE(why_no_radiance("").find("does not begin with #?"), std::string::npos);
  EXPECT_NE(why_no_radiance("#?RADIANCE").find("no end"), std::string::npos);
  EXPECT_NE(why_no_radiance("#?RADIANCE\n\n").find("its size"), std::string::npos);
  EXPECT_NE(why_no_radiance("#?RADIANCE\n\n-Y 4\n").find("its size"), std::string::npos);
  EXPECT_NE(why_no_radiance("#?RADIANCE\n\n-Y 4 +Y 4\n").find("its size"), std::string::npos);
  EXPECT_NE(why_no_radiance("#?RADIANCE\n\n-Y 4 +X 4 more\n").find("too long"), std::string::npos);
  EXPECT_NE(why_no_radiance("#?RADIANCE\n\n-Y 0 +X 4\n").find("no size"), std::string::npos);
  EXPECT_NE(why_no_radiance("#?RADIANCE\n\n-Y 4 +X -4\n").find("no size"), std::string::npos);
  EXPECT_NE(why_no_radiance("#?RADIANCE\n\n-Y four +X 4\n").find("no size"), std::string::npos);
  EXPECT_NE(why_no_radiance("#?RADIANCE\n\n+Y 4 +X 4\n").find("from the top"), std::string::npos);
  EXPECT_NE(why_no_radiance(radiance_file(4, 4, "FORMAT=32-bit_rle_xyze\n")).find("red, green"),
            std::string::npos);
  EXPECT_NE(why_no_radiance(radiance_file(4, 4, "EXPOSURE=0\n")).find("exposure"), std::string::npos);
  EXPECT_NE(why_no_radiance(radiance_file(4, 4, "EXPOSURE=bright\n")).find("exposure"), std::string::npos);
  std::string endless = "#?RADIANCE\n";
  while (endless.size() < 100'000) endless += "COMMENT=more and more\n";
  EXPECT_NE(why_no_radiance(endless + "\n-Y 1 +X 1\n").find("no end"), std::string::npos);
}

TEST(ReadRadiance, SizesAboveTheLimitsAreRefusedBeforeMemoryIsTaken) {
  EXPECT_NE(why_no_radiance(radiance_file(20'000, 10'000)).find("150 million"), std::string::npos);
  EXPECT_NE(why_no_radiance(radiance_file(2'000'000'000, 1)).find("150 million"), std::string::npos);
  EXPECT_NE(why_no_radiance(radiance_file(100'000, 1)).find("65536"), std::string::npos);
}

TEST(ReadRadiance, DamagedRowsAreRefused) {
  EXPECT_NE(why_no_radiance(radiance_file(2, 2) + raw_bytes({9, 9, 9, 129, 9, 9, 9, 129})).find("missing"),
            std::string::npos);
  EXPECT_NE(why_no_radiance(radiance_file(2, 1) + raw_bytes({1, 1, 1, 1, 9, 9, 9, 129})).find("begins with"),
            std::string::npos);
  EXPECT_NE(why_no_radiance(radiance_file(2, 1) + raw_bytes({9, 9, 9, 129, 1, 1, 1, 2})).find("longer"),
            std::string::npos);
  EXPECT_NE(why_no_radiance(radiance_file(8, 1) + raw_bytes({2, 2, 0, 9})).find("another length"),
            std::string::npos);
  EXPECT_NE(why_no_radiance(radiance_file(8, 1) + raw_bytes({2, 2, 0, 8, 128 + 9, 5})).find("longer"),
            std::string::npos);
  EXPECT_NE(why_no_radiance(radiance_file(8, 1) + raw_bytes({2, 2, 0, 8, 0, 5})).find("longer"),
            std::string::npos);
  EXPECT_NE(why_no_radiance(radiance_file(8, 1) + raw_bytes({2, 2, 0, 8, 8, 5, 5})).find("missing"),
            std::string::npos);
}

/// Every beginning of a whole file is damaged, and every byte may be any: neither crashes nor hangs.
TEST(ReadRadiance, CutAndChangedFilesNeverCrash) {
  RadianceBytesOf row(40, {90, 80, 70, 128});
  const std::string whole = radiance_file(40, 2) + with_runs(row, 9) + flat_row(row);
  ASSERT_TRUE(pixels_of(whole).ok());
  for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_FALSE(pixels_of(whole.substr(0, size)).ok());
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 3000; ++i) {
    std::string changed = whole;
    changed[random() % changed.size()] = char(random());
    (void)read_radiance(changed, [](int, std::span<const Radiance> pixels) {
      for (const Radiance& pixel : pixels)
        for (const float channel : pixel) EXPECT_TRUE(std::isfinite(channel) && channel >= 0);
    });
  }
}

}  // namespace
}  // namespace hariko

#include "render/color_map.hpp"

#include <cmath>
#include <limits>

#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

/// CIE lightness (0 .. 100) of an sRGB colour.
double lightness(Color c) {
  const auto linear = [](double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
  const double y = 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(ColorMap, WordsGoBothWays) {
  for (const char* word : {"shaded", "patches", "zebra", "gauss", "mean", "k1", "k2", "continuity",
                           "isophotes", "draft", "radius", "thickness", "deviation"})
    EXPECT_EQ(word_of(*surface_map_from(word)), word);
  EXPECT_FALSE(surface_map_from("gaussian"));
  EXPECT_EQ(unit_of(SurfaceMap::gaussian, "mm"), "1/mm\u00b2");
  EXPECT_EQ(unit_of(SurfaceMap::mean, "in"), "1/in");
  EXPECT_EQ(unit_of(SurfaceMap::shaded, "mm"), "");
  EXPECT_EQ(unit_of(SurfaceMap::draft, "mm"), "\u00b0");
  for (const SurfaceMap map : {SurfaceMap::radius, SurfaceMap::thickness, SurfaceMap::deviation})
    EXPECT_EQ(unit_of(map, "in"), "in");
}

TEST(ColorMap, SequentialGetsSteadilyLighter) {
  double last = lightness(color_at(ColorScale::sequential, 0));
  EXPECT_LT(last, 25);
  for (int i = 1; i <= 64; ++i) {
    const double next = lightness(color_at(ColorScale::sequential, i / 64.0));
    EXPECT_GT(next - last, 0.5) << i;
    EXPECT_LT(next - last, 2.0) << i;
    last = next;
  }
  EXPECT_GT(last, 80);
}

TEST(ColorMap, DivergingIsWhiteInTheMiddleBlueBelowAndRedAbove) {
  const Color middle = color_at(ColorScale::diverging, 0.5);
  EXPECT_GT(std::min({middle.r, middle.g, middle.b}), 0.95F);
  const Color low = color_at(ColorScale::diverging, 0), high = color_at(ColorScale::diverging, 1);
  EXPECT_GT(low.b, low.r + 0.4F);
  EXPECT_GT(high.r, high.b + 0.4F);
  for (double x = 0; x <= 0.5; x += 0.05)  // equal magnitudes look equally strong
    EXPECT_NEAR(lightness(color_at(ColorScale::diverging, 0.5 - x)),
                lightness(color_at(ColorScale::diverging, 0.5 + x)), 6);
}

TEST(ColorMap, SafeScalesReadInGreyAndWithoutRedOrGreen) {
  double last = lightness(color_at(ColorScale::sequential_safe, 0));
  for (int i = 1; i <= 64; ++i) {
    const double next = lightness(color_at(ColorScale::sequential_safe, i / 64.0));
    EXPECT_GT(next - last, 0.5) << i;
    last = next;
  }
  for (int i = 0; i <= 64; ++i) {
    // Red and green are what most colour-blind people confuse: nothing leans to either alone.
    const Color c = color_at(ColorScale::sequential_safe, i / 64.0);
    EXPECT_LT(std::abs(c.r - c.g), 0.17F) << i;
  }
  const Color low = color_at(ColorScale::diverging_safe, 0), high = color_at(ColorScale::diverging_safe, 1);
  EXPECT_GT(low.b, low.r + 0.3F);
  EXPECT_GT(high.r, high.b + 0.3F);
  EXPECT_GT(high.g, 0.30F) << "orange, not red";
}

TEST(ColorMap, WhiteIsZeroWhereZeroIsInTheRange) {
  const auto scale = [](ValueRange range) { return scale_for(SurfaceMap::mean, range, false); };
  EXPECT_EQ(scale({-1, 3}), ColorScale::diverging);
  EXPECT_EQ(scale({0.5, 3}), ColorScale::sequential);
  EXPECT_EQ(scale({-3, 0}), ColorScale::sequential);
  EXPECT_EQ(scale_for(SurfaceMap::mean, {-1, 1}, true), ColorScale::diverging_safe);
  EXPECT_EQ(scale_for(SurfaceMap::continuity, {-1, 1}, true), ColorScale::sequential_safe);
  for (const ValueRange range : {ValueRange{-1, 3}, ValueRange{-2, 2}, ValueRange{-1e-9, 1e6}}) {
    EXPECT_EQ(scale_fraction(ColorScale::diverging, range, 0), 0.5);
    EXPECT_NEAR(scale_fraction(ColorScale::diverging, range, range.low), 0, 1e-12);
    EXPECT_NEAR(scale_fraction(ColorScale::diverging, range, range.high), 1, 1e-12);
  }
  EXPECT_NEAR(scale_fraction(ColorScale::sequential, {2, 6}, 3), 0.25, 1e-15);
  EXPECT_EQ(scale_fraction(ColorScale::sequential, {2, 2}, 2), 0.5);
}

TEST(ColorMap, RangesFollowTheirMode) {
  std::vector<float> values;
  for (int i = -10; i <= 90; ++i) values.push_back(static_cast<float>(i));
  const auto range = [&](RangeMode mode) { return value_range(SurfaceMap::mean, {mode, -3, 4}, values); };
  EXPECT_EQ(range(RangeMode::symmetric), automatic_range(SurfaceMap::mean, values));
  EXPECT_EQ(range(RangeMode::percentile), (ValueRange{-8, 88}));
  EXPECT_EQ(range(RangeMode::full), (ValueRange{-10, 90}));
  EXPECT_EQ(range(RangeMode::manual), (ValueRange{-3, 4}));
  for (const RangeMode mode : {RangeMode::symmetric, RangeMode::percentile, RangeMode::full}) {
    for (const std::vector<float>& flat :
         {std::vector<float>{}, std::vector<float>(9, 0.0F), std::vector<float>(9, -2.0F),
          std::vector<float>{1e-15F, -1e-15F}}) {
      const ValueRange found = value_range(SurfaceMap::gaussian, {mode}, flat);
      EXPECT_LT(found.low, found.high);
      EXPECT_GT(found.high - found.low, 1e-9);
    }
  }
}

TEST(ColorMap, TableIsTheFunction) {
  for (const ColorScale scale : {ColorScale::diverging, ColorScale::sequential, ColorScale::diverging_safe,
                                 ColorScale::sequential_safe}) {
    const auto table = color_table(scale);
    for (std::size_t i = 0; i < 256; i += 17) {
      EXPECT_NEAR(table[4 * i], color_at(scale, double(i) / 255).r * 255, 0.51);
      EXPECT_EQ(table[4 * i + 3], 255);
    }
  }
  EXPECT_EQ(color_at(ColorScale::sequential, -3), color_at(ColorScale::sequential, 0));
}

TEST(ColorMap, HexColors) {
  const Color c = color_from_hex("#f29e38");
  EXPECT_NEAR(c.r * 255, 0xf2, 0.01);
  EXPECT_NEAR(c.g * 255, 0x9e, 0.01);
  EXPECT_NEAR(c.b * 255, 0x38, 0.01);
  EXPECT_EQ(c.a, 1.0F);
  EXPECT_NEAR(color_from_hex("#00000080").a * 255, 128, 0.01);
}

TEST(Range, IgnoresWhatIsNoNumber) {
  const std::vector<float> values{nan_value, 3, -1, std::numeric_limits<float>::infinity(), 2};
  EXPECT_EQ(full_range(values), (ValueRange{-1, 3}));
  EXPECT_EQ(percentile_range(values, 0), (ValueRange{-1, 3}));
  const std::vector<float> none{nan_value};
  EXPECT_EQ(full_range(none), (ValueRange{0, 1}));
  EXPECT_EQ(full_range({}), (ValueRange{0, 1}));
}

TEST(Range, PercentilesCutOutliers) {
  std::vector<float> values;
  for (int i = 0; i <= 1000; ++i) values.push_back(static_cast<float>(i));
  values.push_back(1e9F);
  const ValueRange range = percentile_range(values, 0.02);
  EXPECT_NEAR(range.low, 20, 1);
  EXPECT_NEAR(range.high, 980, 2);
}

TEST(Range, AutomaticRangesAreRoundAndNeverEmpty) {
  const std::vector<float> values{-0.1F, 0.37F, 0.2F};
  EXPECT_EQ(automatic_range(SurfaceMap::mean, values), (ValueRange{-0.4, 0.4}));
  const std::vector<float> jumps{0, 0.1F, 0.34F};
  EXPECT_EQ(automatic_range(SurfaceMap::continuity, jumps), (ValueRange{0, 0.4}));
  const std::vector<float> flat{0, 1e-15F};
  EXPECT_EQ(automatic_range(SurfaceMap::mean, flat), (ValueRange{-1, 1}));
  EXPECT_EQ(automatic_range(SurfaceMap::mean, {}), (ValueRange{-1, 1}));
}

TEST(Ticks, AreRoundAndLabelled) {
  const auto ticks = legend_ticks({-0.4, 0.4}, 5);
  ASSERT_EQ(ticks.size(), 5U);
  EXPECT_EQ(ticks[0].label, "\u22120.4");
  EXPECT_EQ(ticks[1].label, "\u22120.2");
  EXPECT_EQ(ticks[2].label, "0");
  EXPECT_EQ(ticks[4].label, "0.4");
  EXPECT_NEAR(ticks[1].fraction, 0.25, 1e-12);
}

TEST(Ticks, EveryAutomaticRangeHasFiveToNineInside) {
  for_random(8, 300, [](std::mt19937_64& rng) {
    const std::vector<float> values{static_cast<float>(log_uniform(rng, 1e-9, 1e9))};
    for (const SurfaceMap map : {SurfaceMap::gaussian, SurfaceMap::continuity}) {
      const ValueRange range = automatic_range(map, values);
      const auto ticks = legend_ticks(range, 5);
      EXPECT_GE(ticks.size(), 5U) << range.high;
      EXPECT_LE(ticks.size(), 9U) << range.high;
      EXPECT_NEAR(ticks.back().value, range.high, 1e-6 * range.high);
      for (std::size_t i = 0; i < ticks.size(); ++i) {
        EXPECT_GE(ticks[i].fraction, 0);
        EXPECT_LE(ticks[i].fraction, 1);
        if (i > 0) {
          EXPECT_NE(ticks[i].label, ticks[i - 1].label);
        }
        EXPECT_LE(ticks[i].label.size(), 12U) << ticks[i].label;
      }
    }
  });
}

TEST(Ticks, DegenerateRangesHaveOne) {
  EXPECT_EQ(legend_ticks({3, 3}).size(), 1U);
  EXPECT_EQ(legend_ticks({NAN, 1}).size(), 1U);
}

TEST(Histogram, CountsWithinTheRange) {
  const std::vector<float> values{0.1F, 0.2F, 0.9F, 5, nan_value, 1.0F};
  const auto bins = histogram(values, {0, 1}, 2);
  EXPECT_EQ(bins, (std::vector<float>{1, 1}));
  EXPECT_EQ(histogram({}, {0, 1}, 3), (std::vector<float>{0, 0, 0}));
}

}  // namespace
}  // namespace hariko::test

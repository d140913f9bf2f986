// Colours of maps with a limit: what is below it is told apart at a glance, by every kind of colour vision.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/color_map.hpp"

namespace hariko {
namespace {

double color_gap(const Color& a, const Color& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

TEST(LimitColors, TheScaleIsCentredOnTheLimit) {
  EXPECT_EQ(value_range(SurfaceMap::draft, {}, {}, 3), (ValueRange{-3, 9, 3}));
  EXPECT_EQ(value_range(SurfaceMap::draft, {}, {}, 0), (ValueRange{-5, 5, 0}));
  EXPECT_EQ(value_range(SurfaceMap::draft, {}, {}, 80), (ValueRange{70, 90, 80}));
  EXPECT_EQ(value_range(SurfaceMap::radius, {}, {}, 2.5), (ValueRange{0, 5, 2.5}));
  EXPECT_EQ(value_range(SurfaceMap::thickness, {}, {}, 1e-3), (ValueRange{0, 2e-3, 1e-3}));
  const std::vector<float> values{0.5F, 7, 12};
  // The step stays at the limit, whatever the ends are.
  for (const MapRange settings : {MapRange{RangeMode::full}, MapRange{RangeMode::manual, 1, 30},
                                  MapRange{RangeMode::percentile}, MapRange{RangeMode::manual, 5, 6}}) {
    const ValueRange range = value_range(SurfaceMap::thickness, settings, values, 2);
    EXPECT_LT(range.low, range.high);
    EXPECT_EQ(range.centre, 2);
    const ColorScale scale = scale_for(SurfaceMap::thickness, range, false);
    EXPECT_EQ(scale, ColorScale::limit);
    EXPECT_EQ(scale_fraction(scale, range, 2), 0.5);
    if (range.low < 2) {
      EXPECT_NEAR(scale_fraction(scale, range, range.low), 0, 1e-12);
    }
    EXPECT_NEAR(scale_fraction(scale, range, range.high), 1, 1e-12);
  }
}

TEST(LimitColors, BelowTheLimitIsRedAndAboveItBlue) {
  for (const bool safe : {false, true}) {
    const ValueRange range{0, 4, 2};
    for (const double value : {0.0, 0.5, 1.0, 1.9, 1.999}) {
      const Color bad = color_of_value(SurfaceMap::thickness, range, safe, value);
      EXPECT_GT(bad.r, bad.b + 0.1F) << value << " " << safe;
      const Color good = color_of_value(SurfaceMap::thickness, range, safe, 4 - value);
      EXPECT_LT(good.r, good.b + 0.01F) << value << " " << safe;
    }
    const Color before = color_of_value(SurfaceMap::thickness, range, safe, 2 - 1e-9),
                after = color_of_value(SurfaceMap::thickness, range, safe, 2);
    EXPECT_GT(color_gap(before, after), 0.15) << "there is a step at the limit";
  }
}

TEST(LimitColors, UndercutsHaveAColourOfTheirOwn) {
  for (const bool safe : {false, true}) {
    const auto floor = floor_of(SurfaceMap::draft, safe);
    ASSERT_TRUE(floor);
    const ValueRange range{-3, 9, 3};
    EXPECT_EQ(color_of_value(SurfaceMap::draft, range, safe, -1e-3), floor->color);
    EXPECT_EQ(color_of_value(SurfaceMap::draft, range, safe, -90), floor->color);
    for (double value = 0; value <= 9; value += 0.125)
      EXPECT_GT(color_gap(color_of_value(SurfaceMap::draft, range, safe, value), floor->color), 0.2) << value;
    EXPECT_FALSE(floor_of(SurfaceMap::thickness, safe));
  }
}

}  // namespace
}  // namespace hariko

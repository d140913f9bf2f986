// Cheat sheet: how it takes hints apart and fills its columns.

#include "ui/shell/cheat_sheet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hariko {
namespace {

TEST(CheatSheet, TakesHintsApart) {
  EXPECT_EQ(hint_parts("Orbit   Esc goes back"), (std::vector<std::string>{"Orbit", "Esc goes back"}));
  EXPECT_EQ(hint_parts("1 vertex   |   drag moves"), (std::vector<std::string>{"1 vertex", "drag moves"}));
  EXPECT_EQ(hint_parts("one"), std::vector<std::string>{"one"});
  EXPECT_TRUE(hint_parts("").empty());
  EXPECT_EQ(hint_parts("a      b"), (std::vector<std::string>{"a", "b"}));
}

/// The least height of the tallest column, by trying every way to cut.
float best(const std::vector<float>& heights, std::size_t from, int columns) {
  float sum = 0, least = 1e9F;
  if (columns == 1) {
    for (std::size_t i = from; i < heights.size(); ++i) sum += heights[i];
    return sum;
  }
  for (std::size_t i = from; i <= heights.size(); ++i) {
    least = std::min(least, std::max(sum, best(heights, i, columns - 1)));
    if (i < heights.size()) sum += heights[i];
  }
  return least;
}

TEST(CheatSheet, ColumnsAreAsLowAsTheOrderAllows) {
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round) {
    std::vector<float> heights(1 + random() % 9);
    for (float& height : heights) height = static_cast<float>(10 + random() % 200);
    const int columns = 1 + static_cast<int>(random() % 4);
    const auto places = columns_of(heights, columns);
    ASSERT_EQ(places.size(), heights.size());
    ASSERT_TRUE(std::is_sorted(places.begin(), places.end()));
    ASSERT_LT(places.back(), columns);
    std::vector<float> filled(static_cast<std::size_t>(columns), 0.0F);
    for (std::size_t i = 0; i < heights.size(); ++i)
      filled[static_cast<std::size_t>(places[i])] += heights[i];
    ASSERT_NEAR(*std::max_element(filled.begin(), filled.end()), best(heights, 0, columns), 0.01F)
        << "round " << round;
  }
}

}  // namespace
}  // namespace hariko

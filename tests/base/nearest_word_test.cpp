#include "core/base/text/nearest_word.hpp"

#include <gtest/gtest.h>

namespace hariko {
namespace {

TEST(NearestWord, DistancesCountSingleMistakes) {
  EXPECT_EQ(spelling_distance("", ""), 0U);
  EXPECT_EQ(spelling_distance("", "mesh"), 4U);
  EXPECT_EQ(spelling_distance("mesh", "mesh"), 0U);
  EXPECT_EQ(spelling_distance("exprot", "export"), 1U) << "a swap is one mistake";
  EXPECT_EQ(spelling_distance("rendr", "render"), 1U);
  EXPECT_EQ(spelling_distance("renderr", "render"), 1U);
  EXPECT_EQ(spelling_distance("rander", "render"), 1U);
  EXPECT_EQ(spelling_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(spelling_distance("abcdef", "badcfe"), 3U);
}

TEST(NearestWord, DistanceIsSymmetric) {
  const std::vector<std::string> words{"info", "export", "exprot", "mesh", "unfold", "", "evaluate"};
  for (const std::string& a : words)
    for (const std::string& b : words) EXPECT_EQ(spelling_distance(a, b), spelling_distance(b, a)) << a << b;
}

TEST(NearestWord, FindsWhatWasMeant) {
  const std::vector<std::string> commands{"info", "export", "render", "evaluate", "unfold", "mesh"};
  EXPECT_EQ(nearest_word("exprot", commands), "export");
  EXPECT_EQ(nearest_word("EXPORT", commands), "export");
  EXPECT_EQ(nearest_word("inf", commands), "info");
  EXPECT_EQ(nearest_word("eval", commands), "evaluate") << "the beginning of a word";
  EXPECT_EQ(nearest_word("open", commands), std::nullopt);
  EXPECT_EQ(nearest_word("", commands), std::nullopt);
  EXPECT_EQ(nearest_word("mesh", {}), std::nullopt);
  EXPECT_EQ(nearest_word(std::string(100'000, 'e'), commands), std::nullopt);
}

TEST(NearestWord, DashesDoNotCount) {
  const std::vector<std::string> options{"--density", "--distance", "--help"};
  EXPECT_EQ(nearest_word("--densty", options), "--density");
  EXPECT_EQ(nearest_word("-density", options), "--density");
  EXPECT_EQ(nearest_word("help", options), "--help");
  EXPECT_EQ(nearest_word("--", options), std::nullopt);
}

}  // namespace
}  // namespace hariko

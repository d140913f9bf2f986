// Numbers typed into tools.

#include <gtest/gtest.h>

#include "ui/editor/numeric_input.hpp"

namespace hariko {
namespace {

TEST(NumericInput, TakesNumbersAndLeavesKeys) {
  NumericInput input;
  const auto press = [&](Key key, char32_t text) { return input.key({{key, false, false, false}, text}); };
  EXPECT_FALSE(press(Key::x, U'x')) << "an axis";
  EXPECT_FALSE(press(Key::p, U'p')) << "letters begin no number";
  EXPECT_FALSE(press(Key::backspace, 0));
  EXPECT_FALSE(input.active());
  EXPECT_TRUE(press(Key{'2'}, U'2'));
  EXPECT_FALSE(press(Key::x, U'x'));
  EXPECT_TRUE(press(Key{'8'}, U'*')) << "by the character, not by the key";
  EXPECT_FALSE(input.value().has_value());
  EXPECT_TRUE(input.error().has_value());
  for (const char c : std::string("max(1,3)")) EXPECT_TRUE(press(Key::none, static_cast<char32_t>(c))) << c;
  EXPECT_EQ(input.value(), 6);
  EXPECT_TRUE(press(Key::backspace, 0));
  EXPECT_EQ(input.text(0), "2*max(1,3");
  input.clear();
  EXPECT_FALSE(input.active());
}

}  // namespace
}  // namespace hariko

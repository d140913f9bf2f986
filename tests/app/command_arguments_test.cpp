#include "ui/editor/command_arguments.hpp"

#include <gtest/gtest.h>

#include "ui/editor/last_operation.hpp"

namespace hariko {
namespace {

using List = std::vector<WrittenScalar>;

std::vector<ArgumentSpec> some_specs() {
  return {length_argument("width", "", 25.4, 1e-9),
          whole_argument("sides", "", 6, 3, 64),
          point_argument("at", "", ArgumentUnit::length, Vector3(10, 20, 30)),
          word_argument("axis", "", {"x", "y", "z"}, "z"),
          optional(angle_argument("angle", "", {})),
          optional(list_argument("ids", ""))};
}

std::string error_of(std::vector<WrittenArgument> written) {
  const auto read = read_arguments(some_specs(), written, Unit::millimetre);
  return read ? std::string() : read.error().text;
}

TEST(CommandArguments, DefaultsAreInTheDocumentsUnit) {
  const auto in_inches = read_arguments(some_specs(), {}, Unit::inch);
  ASSERT_TRUE(in_inches.ok());
  EXPECT_DOUBLE_EQ(in_inches->number("width"), 1);
  EXPECT_LT((in_inches->point("at") - Vector3(10, 20, 30) / 25.4).norm(), 1e-15);
  EXPECT_EQ(in_inches->whole("sides"), 6);
  EXPECT_EQ(in_inches->text("axis"), "z");
  EXPECT_FALSE(in_inches->has("angle"));
}

TEST(CommandArguments, NumbersMayBeExpressionsWithUnits) {
  const std::vector<WrittenArgument> written{{"width", std::string("2 cm + 1")},
                                             {"angle", std::string("pi rad")},
                                             {"at", List{std::string("1 m"), 2.0, std::string("3*4")}},
                                             {"ids", List{3.0, std::string("4-5")}}};
  const auto read = read_arguments(some_specs(), written, Unit::millimetre);
  ASSERT_TRUE(read.ok()) << read.error().text;
  EXPECT_DOUBLE_EQ(read->number("width"), 21);
  EXPECT_NEAR(read->number("angle"), 180, 1e-9);
  EXPECT_EQ(read->point("at"), Vector3(1000, 2, 12));
  EXPECT_EQ(read->list("ids"), (std::vector<std::string>{"3", "4-5"}));
}

TEST(CommandArguments, WhatIsWrongIsNamed) {
  EXPECT_NE(error_of({{"widht", 3.0}}).find("Did you mean \"width\"?"), std::string::npos);
  EXPECT_NE(error_of({{"width", 0.0}}).find("\"width\" is 0, but must be at least 1e-09"), std::string::npos)
      << error_of({{"width", 0.0}});
  EXPECT_NE(error_of({{"sides", 65.0}}).find("3 to 64"), std::string::npos);
  EXPECT_NE(error_of({{"sides", std::string("6")}}).find("a whole number"), std::string::npos);
  EXPECT_NE(error_of({{"at", List{1.0, 2.0}}}).find("three numbers"), std::string::npos);
  EXPECT_NE(error_of({{"axis", std::string("w")}}).find("one of x, y, z"), std::string::npos);
  EXPECT_NE(error_of({{"axis", std::string("x")}, {"axis", std::string("y")}}).find("twice"),
            std::string::npos);
  EXPECT_NE(error_of({{"ids", List{1.5}}}).find("whole numbers"), std::string::npos);
}

TEST(CommandArguments, RangesOfLengthsWaitForTheUnit) {
  const std::vector<ArgumentSpec> specs{length_argument("width", "", {}, 1000)};
  const std::vector<WrittenArgument> written{{"width", std::string("5 m")}};
  EXPECT_TRUE(read_arguments(specs, written, std::nullopt).ok());
  EXPECT_TRUE(read_arguments(specs, written, Unit::millimetre).ok());
  EXPECT_FALSE(read_arguments(specs, written, Unit::metre).ok());
}

TEST(CommandArguments, NumbersOfOperationsBecomeArguments) {
  std::vector<OperationNumber> numbers{{"width", "Width", 10, 1, 100, false},
                                       {"count", "Count", 3, 1, 9, true}};
  numbers.push_back({"kind", "Kind", 1, 0, 1, true, false, {"Line", "Ring"}});
  const auto specs = arguments_of(numbers);
  ASSERT_EQ(specs.size(), 3U);
  EXPECT_EQ(specs[0].unit, ArgumentUnit::length);
  EXPECT_EQ(specs[1].type, ArgumentType::whole);
  EXPECT_EQ(specs[2].words, (std::vector<std::string>{"Line", "Ring"}));
  const std::vector<WrittenArgument> written{{"count", 5.0}, {"kind", std::string("Line")}};
  const auto read = read_arguments(specs, written, Unit::millimetre);
  ASSERT_TRUE(read.ok()) << read.error().text;
  const auto chosen = with_values(numbers, *read);
  EXPECT_EQ(chosen[0].value, 10);
  EXPECT_EQ(chosen[1].value, 5);
  EXPECT_EQ(chosen[2].value, 0);
}

}  // namespace
}  // namespace hariko

#include "core/base/text/expression.hpp"

#include <clocale>
#include <cmath>
#include <locale>
#include <string>

#include "tests/support/random.hpp"

namespace hariko {
namespace {

constexpr UnitFactor millimetres[] = {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}, {"\"", 25.4}};

double value_of(std::string_view text) {
  const auto value = evaluate(text, millimetres);
  EXPECT_TRUE(value.ok()) << text;
  return value.ok() ? *value : NAN;
}

TEST(Expression, Arithmetic) {
  EXPECT_EQ(value_of("10"), 10);
  EXPECT_EQ(value_of("-2.5"), -2.5);
  EXPECT_EQ(value_of(".5"), 0.5);
  EXPECT_EQ(value_of("1 + 2*3"), 7);
  EXPECT_EQ(value_of("(1+2)*3"), 9);
  EXPECT_EQ(value_of("2^3"), 8);
  EXPECT_EQ(value_of("2*pi"), 2 * M_PI);
  EXPECT_EQ(value_of("2pi"), 2 * M_PI);
  EXPECT_EQ(value_of("3(1+1)"), 6);
  EXPECT_EQ(value_of("1e3"), 1000);
  EXPECT_EQ(value_of("1.5e-2"), 0.015);
  EXPECT_EQ(value_of("sqrt(16)+max(1,2)"), 6);
  EXPECT_NEAR(value_of("sin(30)"), 0.5, 1e-15);
}

TEST(Expression, AUnitMultipliesTheTermOnItsLeft) {
  EXPECT_EQ(value_of("12mm+3"), 15);
  EXPECT_EQ(value_of("2cm"), 20);
  EXPECT_EQ(value_of("1.5m"), 1500);
  EXPECT_EQ(value_of("1in"), 25.4);
  EXPECT_DOUBLE_EQ(value_of("1/4in"), 6.35);
  EXPECT_DOUBLE_EQ(value_of("1/4\""), 6.35);
  EXPECT_EQ(value_of("-3 cm"), -30);
  EXPECT_EQ(value_of("(1+1)cm"), 20);
  EXPECT_DOUBLE_EQ(value_of("1in+2cm-4mm"), 25.4 + 20 - 4);
  const auto angle = test::must(evaluate("90deg", angle_units));
  EXPECT_EQ(*angle, 90);
  EXPECT_EQ(*evaluate("45°", angle_units), 45);
  EXPECT_NEAR(*evaluate("pi rad", angle_units), 180, 1e-12);
}

TEST(Expression, RefusesWhatIsNoNumber) {
  for (const char* text :
       {"",    " ",     "mm",     "1+",      "1,5", "(1",     "1)",   "a=3", "x",        "1?2:3",
        "1<2", "\"a\"", "1/0",    "2^99999", "0/0", "1 2 3,", "inf",  "nan", "sqrt(-1)", "min(1)",
        "..",  "1..2",  "1.2.3,", "3kg",     "_pi", "1;2",    "\xff", "--",  "e e,"})
    EXPECT_FALSE(evaluate(text, millimetres).ok()) << text;
  EXPECT_FALSE(evaluate(std::string(max_expression_length + 1, '1'), millimetres).ok());
  const auto refused = evaluate("3kg", millimetres);
  EXPECT_EQ(refused.error().code, e_expression);
  EXPECT_NE(refused.error().text.find("kg"), std::string::npos);
}

TEST(Expression, DoesNotDependOnTheLocale) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  EXPECT_EQ(value_of("1.5+2.25"), 3.75);
  EXPECT_EQ(value_of("1.234in"), 1.234 * 25.4);
  std::locale::global(before);
}

/// Junk of the signs that expressions are made of: a finite number or a refusal, never anything else.
TEST(Expression, JunkIsRefusedOrFinite) {
  constexpr std::string_view signs =
      "0123456789..++--**//^^(()),,  eepiinmmcmdegsqrtminabs\"\xc2\xb0=<>?:;&|!x_'";
  int numbers = 0;
  test::for_random(3, 20000, [&](std::mt19937_64& rng) {
    std::string text;
    for (int n = test::uniform_int(rng, 0, 24); n > 0; --n) text += signs[rng() % signs.size()];
    const auto value = evaluate(text, millimetres);
    if (!value.ok()) return;
    ++numbers;
    EXPECT_TRUE(std::isfinite(*value)) << text;
  });
  EXPECT_GT(numbers, 20) << "nothing of the junk is an expression: the test means nothing";
}

TEST(Expression, DeepNestingIsNoDanger) {
  const std::string deep = std::string(99, '(') + "1" + std::string(99, ')');
  EXPECT_EQ(value_of(deep), 1);
  EXPECT_FALSE(evaluate(std::string(200, '('), millimetres).ok());
  EXPECT_FALSE(evaluate(std::string(200, '-'), millimetres).ok());
}

}  // namespace
}  // namespace hariko

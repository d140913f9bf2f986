#include "core/exchange/number_text.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "tests/support/random.hpp"

namespace hariko {
namespace {

TEST(NumberText, RealsAreRoundedAsTheStandardLibraryDoes) {
  test::for_random(1, 3, [](std::mt19937_64& rng) {
    for (int i = 0; i < 20'000; ++i) {
      std::string text = test::chance(rng, 0.5) ? "-" : "";
      const int before = test::uniform_int(rng, 0, 12),
                after = test::uniform_int(rng, before == 0 ? 1 : 0, 20);
      for (int d = 0; d < before; ++d) text += static_cast<char>('0' + test::uniform_int(rng, 0, 9));
      if (after > 0 || test::chance(rng, 0.2)) text += '.';
      for (int d = 0; d < after; ++d) text += static_cast<char>('0' + test::uniform_int(rng, 0, 9));
      if (test::chance(rng, 0.3)) text += "e" + std::to_string(test::uniform_int(rng, -30, 30));
      double expected = 0, value = 0;
      std::from_chars(text.data(), text.data() + text.size(), expected);
      ASSERT_EQ(parse_real(text, value), NumberStatus::ok) << text;
      ASSERT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << text;
    }
  });
}

TEST(NumberText, EveryDoubleComesBack) {
  std::mt19937_64 rng(test::random_seed(5));
  for (int i = 0; i < 100'000; ++i) {
    const double value = std::bit_cast<double>(rng());
    if (!std::isfinite(value)) continue;
    std::string text;
    append_real(text, value);
    double back = 0;
    ASSERT_EQ(parse_real(text, back), NumberStatus::ok) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value)) << text;
  }
}

TEST(NumberText, ExponentsOfFortran) {
  double value = 0;
  const std::pair<const char*, double> cases[] = {
      {"0.125D+01", 1.25}, {"-1.5d-3", -0.0015}, {"+2D2", 200}, {".5D0", 0.5}, {"1D-400", 0}};
  for (const auto& [text, expected] : cases) {
    EXPECT_EQ(parse_real(text, value), NumberStatus::ok) << text;
    EXPECT_EQ(value, expected) << text;
  }
  EXPECT_EQ(parse_real("1D400", value), NumberStatus::too_large);
  for (const char* text : {"D", "1D", "D5", "1D2D3", "1DD2", "1D2e3", "+-1D2", "++1D2", "0xD"})
    EXPECT_EQ(parse_real(text, value), NumberStatus::malformed) << text;
}

TEST(NumberText, RefusedForms) {
  double value = 77;
  for (const char* text : {"", "+", "-", ".", "e5", "1e", "1e+", "1,5", "1 ", " 1", "0x1p3", "1.5.2", "--1",
                           "+-1", "++1", "1_0", "-.", "nanx"})
    EXPECT_EQ(parse_real(text, value), NumberStatus::malformed) << text;
  for (const char* text : {"nan", "NAN", "-nan", "inf", "-Infinity", "+inf"})
    EXPECT_EQ(parse_real(text, value), NumberStatus::not_finite) << text;
  for (const char* text : {"1e309", "-1e400", "1e99999999999999999999", "0.001e400", "1e9223372036854775807"})
    EXPECT_EQ(parse_real(text, value), NumberStatus::too_large) << text;
  EXPECT_EQ(parse_real("1" + std::string(400, '0'), value), NumberStatus::too_large);
  EXPECT_EQ(value, 77);
  for (const char* text :
       {"1e-400", "-1e-99999999999999999999", "0.000001e-9223372036854775807", "0", "0e999"}) {
    value = 77;
    EXPECT_EQ(parse_real(text, value), NumberStatus::ok) << text;
    EXPECT_EQ(value, 0) << text;
  }
  value = 77;
  EXPECT_EQ(parse_real("1" + std::string(400, '0') + "e-800", value), NumberStatus::ok);
  EXPECT_EQ(value, 0);
}

TEST(NumberText, Integers) {
  std::int64_t value = 0;
  EXPECT_EQ(parse_integer("+12", value), NumberStatus::ok);
  EXPECT_EQ(value, 12);
  EXPECT_EQ(parse_integer("-9223372036854775808", value), NumberStatus::ok);
  EXPECT_EQ(value, std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(parse_integer("9223372036854775808", value), NumberStatus::too_large);
  for (const char* text : {"", "+", "-", "1.0", "1e3", "0x1", "1 ", "+-1", "a"})
    EXPECT_EQ(parse_integer(text, value), NumberStatus::malformed) << text;
}

}  // namespace
}  // namespace hariko

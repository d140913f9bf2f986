#include "core/base/text/json_writer.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

namespace hariko {
namespace {

template <class T>
std::string text_of(const T& value) {
  JsonWriter json;
  json.value(value);
  return json.take();
}

TEST(JsonWriter, Scalars) {
  EXPECT_EQ(text_of(nullptr), "null");
  EXPECT_EQ(text_of(true), "true");
  EXPECT_EQ(text_of(false), "false");
  EXPECT_EQ(text_of(-7), "-7");
  EXPECT_EQ(text_of(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
  EXPECT_EQ(text_of(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
  EXPECT_EQ(text_of("a pointer is no boolean"), "\"a pointer is no boolean\"");
  EXPECT_EQ(text_of(std::optional<int>()), "null");
  EXPECT_EQ(text_of(std::optional<double>(0.5)), "0.5");
}

TEST(JsonWriter, RealNumbersCanBeToldFromIntegers) {
  EXPECT_EQ(text_of(0.0), "0.0");
  EXPECT_EQ(text_of(-0.0), "-0.0");
  EXPECT_EQ(text_of(1.0), "1.0");
  EXPECT_EQ(text_of(-120.0), "-120.0");
  EXPECT_EQ(text_of(0.1), "0.1");
  EXPECT_EQ(text_of(12.5), "12.5");
  EXPECT_EQ(text_of(0.0001), "0.0001");
  EXPECT_EQ(text_of(0.00001), "1e-05");
  EXPECT_EQ(text_of(1.25e-7), "1.25e-07");
  EXPECT_EQ(text_of(100000000000000.0), "100000000000000.0");
  EXPECT_EQ(text_of(1e15), "1e+15");
  EXPECT_EQ(text_of(-1.5e300), "-1.5e+300");
  EXPECT_EQ(text_of(5e-324), "5e-324");
}

TEST(JsonWriter, NumbersThatAreNotFiniteAreNull) {
  EXPECT_EQ(text_of(std::nan("")), "null");
  EXPECT_EQ(text_of(-std::numeric_limits<double>::infinity()), "null");
}

TEST(JsonWriter, RealNumbersReadBackAsTheSame) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 20'000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(std::strtod(text_of(value).c_str(), nullptr), value) << text_of(value);
  }
}

TEST(JsonWriter, StringsAreEscaped) {
  EXPECT_EQ(text_of("a\"b\\c"), R"("a\"b\\c")");
  EXPECT_EQ(text_of("\b\f\n\r\t"), R"("\b\f\n\r\t")");
  EXPECT_EQ(text_of(std::string("\x01\x1f\0x", 4)), R"("\u0001\u001f\u0000x")");
  EXPECT_EQ(text_of("h\u00e4rter \u5f35\u5b50"), "\"h\u00e4rter \u5f35\u5b50\"");
  EXPECT_EQ(text_of("a\xff"
                    "b\xe5\xbc"),
            "\"a\uFFFDb\uFFFD\uFFFD\"")
      << "what is no UTF-8";
}

void write_example(JsonWriter& json) {
  json.object([&] {
    json.member("name", "box");
    json.array("empty", [] {});
    json.object("nothing", [] {});
    json.member("at", Vector3(1, 2.5, -3));
    json.list("edges", std::vector<int>{1, 2}, [&](int i) {
      json.object([&] {
        json.member("ends", {i, i + 1});
        json.member("sharp", i == 1);
      });
    });
    json.key("raw");
    json.raw("[1, 2]");
  });
}

TEST(JsonWriter, OnOneLine) {
  JsonWriter json;
  write_example(json);
  EXPECT_EQ(json.take(),
            R"({"name":"box","empty":[],"nothing":{},"at":[1.0,2.5,-3.0],)"
            R"("edges":[{"ends":[1,2],"sharp":true},{"ends":[2,3],"sharp":false}],"raw":[1, 2]})");
}

TEST(JsonWriter, OnLinesOfTheirOwn) {
  JsonWriter json(2);
  json.object([&] {
    json.member("a", std::vector<std::string>{"x", "y"});
    json.array("empty", [] {});
    json.object("inner", [&] { json.member("b", 1U); });
  });
  EXPECT_EQ(json.take(), R"({
  "a": [
    "x",
    "y"
  ],
  "empty": [],
  "inner": {
    "b": 1
  }
})");
}

}  // namespace
}  // namespace hariko

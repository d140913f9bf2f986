// Bezier patch files.

#include "core/exchange/read_bpt.hpp"

#include <gtest/gtest.h>

#include "core/exchange/imported_mesh.hpp"

namespace hariko {
namespace {

std::string points(int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += std::to_string(i % 4) + " " + std::to_string(i / 4) + " 0.5\n";
  return out;
}

TEST(ReadBpt, PatchesOfTheTeapotKind) {
  const auto nets = read_bpt("2\n3 3\n" + points(16) + "3 3\n" + points(16));
  ASSERT_TRUE(nets.ok()) << to_string(nets.error());
  ASSERT_EQ(nets->size(), 2U);
  EXPECT_EQ((*nets)[1].at(2, 3), Vector3(2, 3, 0.5));
  EXPECT_EQ((*nets)[1].patch_count(), 1U);
}

TEST(ReadBpt, SaysWhatIsWrongAndWhere) {
  const auto code = [](const std::string& text) {
    const auto nets = read_bpt(text);
    return nets.ok() ? Code{"none"} : nets.error().code;
  };
  EXPECT_EQ(code(""), e_empty);
  EXPECT_EQ(code("x"), e_parse);
  EXPECT_EQ(code("0"), e_limit);
  EXPECT_EQ(code("1\n2 3\n" + points(12)), e_format_unknown);
  EXPECT_EQ(code("1\n3 3\n" + points(15)), e_truncated);
  EXPECT_EQ(code("1\n3 3\n" + points(15) + "1 2 nan"), e_parse);
  const auto broken = read_bpt("1\n3 3\n" + points(3) + "1 oops 3\n");
  ASSERT_FALSE(broken.ok());
  EXPECT_NE(broken.error().text.find("Line 6"), std::string::npos) << broken.error().text;
}

}  // namespace
}  // namespace hariko

#include "core/skinning/sections/closing_points.hpp"

#include <gtest/gtest.h>

#include "core/document/format/read_skin.hpp"

namespace hariko {
namespace {

/// Two squares along a path. `last`: rows of numbers behind the four corners of the first one; `rest`:
/// further members, each with a comma before it.
Skin two_squares(const std::string& last, bool closed = true, const std::string& rest = "") {
  const std::string corners = "[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]";
  auto skin = read_skin_layout(
      R"({"path": {"points": [[0, 0, 0], [0, 0, 1], [0, 0, 2]], "closed": false}, "sections": [{"v": 0, "closed": )" +
      std::string(closed ? "true" : "false") + R"(, "points": [)" + corners + last +
      R"(]}, {"v": 1, "closed": true, "points": [[1, 0, 2], [0, 1, 2], [-1, 0, 2], [0, -1, 2]]}])" + rest +
      "}");
  EXPECT_TRUE(skin.ok()) << to_string(skin.error());
  return std::move(skin).value();
}

TEST(ClosingPoints, TheRepeatedPointOfAClosedSectionGoes) {
  Skin skin = two_squares(", [1, 0, 0]");
  EXPECT_EQ(drop_closing_points(skin), 1U);
  const Skin expected = two_squares("");
  ASSERT_EQ(skin.sections[0].size(), 4);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_EQ(skin.sections[0].points[k].position, expected.sections[0].points[k].position);
  EXPECT_EQ(skin.sections[1].size(), 4);
  EXPECT_EQ(drop_closing_points(skin), 0U);
}

TEST(ClosingPoints, OthersStay) {
  for (const auto& [last, closed] :
       {std::pair{", [1, 0, 0]", false}, std::pair{", [1, 1e-6, 0]", true}, std::pair{"", true}}) {
    Skin skin = two_squares(last, closed);
    const Skin before = skin;
    EXPECT_EQ(drop_closing_points(skin), 0U) << last;
    EXPECT_EQ(skin, before);
  }
}

TEST(ClosingPoints, ItsLinksGoToTheFirstPoint) {
  Skin skin =
      two_squares(", [1, 0, 0]", true,
                  R"(, "links": [{"strip": 0, "a": [4], "b": [0]}, {"strip": 0, "a": [0, 4], "b": [1]}])");
  const std::uint32_t first = skin.sections[0].points[0].id;
  ASSERT_EQ(skin.links.size(), 2U);
  EXPECT_EQ(drop_closing_points(skin), 1U);
  EXPECT_EQ(skin.links[0].a, std::vector<std::uint32_t>{first});
  EXPECT_EQ(skin.links[1].a, std::vector<std::uint32_t>{first});
}

}  // namespace
}  // namespace hariko

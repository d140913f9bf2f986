#include "core/document/format/read_outline.hpp"

#include <gtest/gtest.h>

#include "core/base/files/file_io.hpp"
#include "core/gaussmap/outlines/outline_check.hpp"
#include "tests/support/places.hpp"

namespace hariko {
namespace {

std::string golden(const std::string& name) {
  const auto text = read_file(test::source_folder() + "/tests/golden/gaussmap/" + name + ".json", 1 << 20);
  EXPECT_TRUE(text.ok());
  return text.ok() ? *text : std::string();
}

TEST(ReadOutline, ReadsTheCases) {
  const auto holes = read_outline(golden("three_holes"));
  ASSERT_TRUE(holes.ok()) << to_string(holes.error());
  EXPECT_EQ(holes->loops.size(), 3u);
  EXPECT_EQ(holes->point_count(), 42u);
  EXPECT_TRUE(holes->has_curvature());
  EXPECT_TRUE(check_outline(*holes, GaussMode::curvature).empty());
}

TEST(ReadOutline, SaysWhereTheMistakeIs) {
  const auto message = [](const std::string& text) {
    const auto outline = read_outline(text);
    EXPECT_FALSE(outline.ok()) << text;
    return outline.ok() ? std::string() : to_string(outline.error());
  };
  const auto expect = [&](const std::string& text, const std::string& part) {
    EXPECT_NE(message(text).find(part), std::string::npos) << message(text);
  };
  expect("{", "E_PARSE");
  expect("[]", "E_SCHEMA");
  expect("{}", "\"loops\" is missing");
  expect("{\"loops\": [{\"points\": [[0, 0]], \"normals\": []}]}", "loops[0].points[0]");
  expect("{\"loops\": [{\"points\": [[0, 0, 0]], \"normals\": []}]}", "loops[0].normals");
  expect("{\"loops\": [{\"points\": [[0, 0, 0]], \"normals\": [[0, 0, \"1\"]]}]}", "loops[0].normals[0]");
  expect("{\"loops\": [{\"points\": [[0, 0, 0]], \"normals\": [[0, 0, 1]], \"K\": [1, 2]}]}", "loops[0].K");
  expect("{\"loops\": [{\"points\": [], \"normals\": [], \"k\": []}]}", "\"k\" is unknown");
}

TEST(ReadOutline, CurvatureMayBeMissing) {
  const auto outline = read_outline("{\"loops\": [{\"points\": [[0, 0, 0]], \"normals\": [[0, 0, 1]]}]}");
  ASSERT_TRUE(outline.ok());
  EXPECT_FALSE(outline->has_curvature());
}

}  // namespace
}  // namespace hariko

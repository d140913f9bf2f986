#include "core/exchange/triangles/read_off.hpp"

#include "tests/exchange/fixture_files.hpp"
#include "tests/exchange/mesh_text.hpp"

namespace hariko::test {
namespace {

const std::string three_points = "0 0 0\n1 0 0\n0 1 0\n";

TEST(ReadOff, HeadersOfAllKindsGiveTheSameMesh) {
  for (const std::string header :
       {"OFF\n3 2 0\n", "OFF 3 2 0\n", "# made by hand\nOFF # keyword\n\n3 2\n", "3 2 0\n", "COFF\n3 2 0\n",
        "NOFF 3 2 5\n", "STCNOFF\n3 2 0\n", "off\n3 2 0\n", "Off 3 2\n", "noff\n3 2 0\n",
        "\xEF\xBB\xBFOFF\r3 2 0\r"}) {
    const auto result = read_off(header + three_points + "3 0 1 2\n4 2 1 0 1 255 0 0\n");
    ASSERT_TRUE(result.ok()) << header << to_string(result.error());
    test::expect_sound(result->mesh);
    EXPECT_EQ(result->mesh.positions[1], Vector3(1, 0, 0));
    EXPECT_EQ(result->mesh.face_vertices, (std::vector<Index>{0, 1, 2, 2, 1, 0, 1}));
    EXPECT_EQ(result->mesh.face_count(), 2U);
    EXPECT_TRUE(result->warnings.empty());
  }
}

TEST(ReadOff, CountsMayBeGluedToTheKeyword) {
  const auto read = test::must(read_mesh_file(test::case_file("off_header_glued.off")));
  EXPECT_EQ(read->mesh.positions.size(), 8U);
  EXPECT_EQ(read->mesh.face_count(), 6U);
  const std::string rest = " 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* start : {"OFF3", "COFF3", "OFF 3", "OFF\n3"}) {
    EXPECT_EQ(outcome(read_off(start + rest)), "ok") << start;
    EXPECT_TRUE(looks_like_off(start + rest));
  }
  for (const char* start : {"OFF3x", "OFFICE", "4OFF3"})
    EXPECT_EQ(outcome(read_off(start + rest)), "E_FORMAT_UNKNOWN 1") << start;
}

TEST(ReadOff, ColoursAndNormalsOfVerticesAreIgnored) {
  const auto result =
      read_off("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0.5 0.5 0.5 1\n\n0 1 0 # no colour\n3 0 1 2 map\n");
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->mesh.positions[2], Vector3(0, 1, 0));
}

TEST(ReadOff, WordsCountAndNotLines) {
  const std::string lines = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  const auto expected = test::must(read_off(lines));
  for (const char* text :
       {"OFF\n4 2 0\n0 0 0 1 0 0\n1 1 0 0 1 0\n3 0 1 2\n3 0 2 3\n",              // two vertices a line
        "OFF\n4 2 0\n0 0 0 1 0 0 1 1 0 0 1 0\n3 0 1 2 3 0 2 3\n",                // as it comes
        "OFF 4 2 0 0 0 0 1 0 0 1 1 0 0 1 0 3 0 1 2 3 0 2 3",                     // one line
        "OFF\n4\n2\n0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",          // counts
        "OFF\n4 2 0\n0\n0 0\n1 0 0\n1 1 0\n0 1 0 # c\n3\n0 1\n2\n3 0 2\n3\n",    // anywhere
        "OFF\n4 2 0\n0 0 0 1 0 0\n1 1 0 0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 map\n",  // colours
        "NOFF\n4 2 0\n0 0 0 0 0 1 1 0 0 0 0 1\n1 1 0 0 0 1 0 1 0 0 0 1\n3 0 1 2\n3 0 2 3\n"}) {
    const auto read = read_off(text);
    ASSERT_TRUE(read.ok()) << text << to_string(read.error());
    EXPECT_EQ(read->mesh.positions, expected->mesh.positions) << text;
    EXPECT_EQ(read->mesh.face_vertices, expected->mesh.face_vertices) << text;
    EXPECT_TRUE(read->warnings.empty()) << text;
  }
  // Files with too few or too many numbers are refused.
  EXPECT_FALSE(read_off("OFF\n4 2 0\n0 0 0 1 0 0\n1 1 0 0 1 0\n3 0 1 2\n3 0 2\n").ok());
  EXPECT_FALSE(read_off("OFF\n4 2 0\n0 0 0 1 0 0\n1 1 0 0 1 0\n3 0 1 2\n3 0 2 3\n7\n").ok());
}

TEST(ReadOff, DataAfterTheLastFaceGivesAWarning) {
  const auto result = test::must(read_off("OFF\n3 1 0\n" + three_points + "3 0 1 2\n3 0 1 2\n"));
  ASSERT_EQ(result->warnings.size(), 1U);
  EXPECT_EQ(result->warnings[0].code, w_trailing_data);
  EXPECT_EQ(result->warnings[0].element.id, 7U);
}

TEST(ReadOff, EveryMalformationHasItsCodeAndLine) {
  const std::string good = "OFF\n3 1 0\n" + three_points;
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "E_EMPTY 1"},
      {"# nothing\n", "E_EMPTY 2"},
      {"OBJ\n", "E_FORMAT_UNKNOWN 1"},
      {"4OFF\n3 1 0\n", "E_FORMAT_UNKNOWN 1"},
      {"nOFF\n3\n3 1 0\n", "E_FORMAT_UNKNOWN 1"},
      {"OFF BINARY\n", "E_FORMAT_UNKNOWN 1"},
      {"OFF\n", "E_TRUNCATED 2"},
      {"OFF\nx 1 0\n", "E_PARSE 2"},
      {"OFF\n3\n", "E_PARSE 2"},
      {"OFF\n3 y 0\n", "E_PARSE 2"},
      {"OFF\n3 1 z\n", "E_PARSE 2"},
      {"OFF\n3 1 0 7\n", "E_PARSE 2"},
      {"OFF\n-3 1 0\n", "E_PARSE 2"},
      {"OFF\n3 -1 0\n", "E_PARSE 2"},
      {"OFF\n3.5 1 0\n", "E_PARSE 2"},
      {"OFF\n4000000000 1 0\n", "E_LIMIT 2"},
      {"OFF\n3 4000000000 0\n", "E_LIMIT 2"},
      {"OFF\n3 99999999999999999999 0\n", "E_LIMIT 2"},
      {"OFF\n100000000 400000000 0\n0 0 0\n", "E_TRUNCATED 4"},
      {"OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "E_PARSE 4"},
      {"OFF\n3 1 0\n0 0 0\n1 a 0\n", "E_PARSE 4"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0 blue\n", "E_PARSE 4"},
      {"OFF\n3 1 0\n0 0 0\n1 nan 0\n", "E_PARSE 4"},
      {"OFF\n3 1 0\n0 0 0\n1 0 0\n", "E_TRUNCATED 5"},
      {good, "E_TRUNCATED 6"},
      {good + "3 0 1\n", "E_PARSE 6"},
      {good + "3 0 1", "E_TRUNCATED 6"},
      {good + "-3 0 1 2\n", "E_PARSE 6"},
      {good + "3 0 1 x\n", "E_PARSE 6"},
      {good + "3 0 1 3\n", "E_INDEX_RANGE 6"},
      {good + "3 0 -1 2\n", "E_INDEX_RANGE 6"},
      {good + "9223372036854775807 0 1 2\n", "E_PARSE 6"},
      {"OFF\n3 0 0\n" + three_points, "E_EMPTY 6"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(outcome(read_off(text)), expected) << text;
}

TEST(ReadOff, LimitsAreErrors) {
  const std::string text = "OFF\n3 2 0\n" + three_points + "3 0 1 2\n3 0 1 2\n";
  EXPECT_EQ(outcome(read_off(text, {.vertices = 2, .corners = 100})), "E_LIMIT 2");
  EXPECT_EQ(outcome(read_off(text, {.vertices = 3, .corners = 5})), "E_LIMIT 7");
}

TEST(ReadOff, TruncationAtEveryByteIsHandled) {
  const std::string text = "COFF # c\n3 2 0\n0 0 0 1 1 1\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 1\n";
  for (std::size_t size = 0; size <= text.size(); ++size) {
    const auto result = read_off(std::string(text, 0, size));
    if (result.ok()) test::expect_sound(result->mesh);
    EXPECT_EQ(result.ok(), size >= text.size() - 1) << size;
  }
}

}  // namespace
}  // namespace hariko::test

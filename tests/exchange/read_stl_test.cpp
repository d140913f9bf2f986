#include "core/exchange/triangles/read_stl.hpp"

#include <algorithm>
#include <cstring>

#include "core/exchange/repair/point_welder.hpp"
#include "tests/exchange/mesh_text.hpp"

namespace hariko::test {
namespace {

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return " facet normal 0 0 1\n  outer loop\n   vertex " + a + "\n   vertex " + b + "\n   vertex " + c +
         "\n  endloop\n endfacet\n";  // 7 lines
}

const std::string two_facets = facet("0 0 0", "1 0 0", "0 1 0") + facet("1 0 0", "1 1 0", "0 1 0");

std::string binary(const std::string& header, std::uint32_t count, std::initializer_list<float> corners) {
  std::string out = header;
  out.resize(80, ' ');
  for (int i = 0; i < 4; ++i) out += static_cast<char>(count >> (8 * i));
  std::size_t i = 0;
  for (const float value : corners) {
    if (i % 9 == 0) out.append(12, '\0');
    char raw[4];
    std::memcpy(raw, &value, 4);
    out.append(raw, 4);
    if (++i % 9 == 0) out.append("\x12\x34");
  }
  return out;
}

std::string two_binary_facets(const std::string& header, std::uint32_t count = 2) {
  return binary(header, count, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, -0.0F, 0, 1, 1, 0, -0.0F, 1, 0});
}

TEST(ReadStl, TextAndBinaryAreWelded) {
  for (const std::string& bytes :
       {"solid two parts\n" + two_facets + "endsolid two parts\n", "SOLID\r\n" + two_facets + "EndSolid",
        two_binary_facets("something"), two_binary_facets("solid but binary"),
        two_binary_facets("solid facet normal 0 0 0 outer loop\n")}) {
    const auto result = test::must(read_stl(bytes));
    test::expect_sound(result->mesh);
    EXPECT_EQ(result->mesh.positions, (std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
    EXPECT_EQ(result->mesh.face_vertices, (std::vector<Index>{0, 1, 2, 1, 3, 2}));
    EXPECT_TRUE(result->warnings.empty());
  }
}

TEST(ReadStl, NameSeveralSolidsAndNormalsThatAreNotNumbers) {
  std::string text = "solid first part \n" + facet("0 0 0", "1 0 0", "0 1 0") +
                     "endsolid first part\n\nsolid\n" + facet("0 0 0", "0 1 0", "0 0 1") + "endsolid\n";
  text.replace(text.find("0 0 1"), 5, "-nan(ind) nan nan");
  const auto result = test::must(read_stl(text));
  EXPECT_EQ(result->name, "first part");
  EXPECT_EQ(result->mesh.face_count(), 2U);
}

TEST(ReadStl, DegenerateTrianglesAreLeftOutWithOneWarning) {
  const auto result = test::must(read_stl("solid\n" + two_facets + facet("0 0 0", "0 0 0", "1 0 0") +
                                          facet("0 0 0", "1 0 0", "-0 0 0") + "endsolid\n"));
  EXPECT_EQ(result->mesh.face_count(), 2U);
  ASSERT_EQ(result->warnings.size(), 1U);
  EXPECT_EQ(result->warnings[0].code, w_degenerate_triangles);
  EXPECT_TRUE(result->warnings[0].text.starts_with("2 triangles"));
}

TEST(ReadStl, EveryMalformedTextHasItsCodeAndLine) {
  const std::string one = facet("0 0 0", "1 0 0", "0 1 0");
  const auto broken = [&](const std::string& what, const std::string& by) {
    std::string text = one;
    EXPECT_NE(text.find(what), std::string::npos);
    return "solid s\n" + text.replace(text.find(what), what.size(), by) + "endsolid s\n";
  };
  const std::vector<std::pair<std::string, std::string>> cases{
      {"solid s\n", "E_TRUNCATED 2"},
      {"solid s\nendsolid s\n", "E_EMPTY 0"},
      {"solid s\n" + facet("0 0 0", "0 0 0", "0 1 0") + "endsolid s\n", "E_EMPTY 0"},
      {"solid s\n" + one + "facet normal 0 0 1\n", "E_TRUNCATED 10"},
      {"solid s\n" + one + "endsolid s\nmore\n", "E_PARSE 10"},
      {"solid s\nface\n", "E_PARSE 2"},
      {broken("normal", "normals"), "E_PARSE 2"},
      {broken("outer", "inner"), "E_PARSE 3"},
      {broken("loop", "hoop"), "E_PARSE 3"},
      {broken("vertex 1 0 0", "vertex 1 0"), "E_PARSE 5"},
      {broken("vertex 1 0 0", "vertex 1 0,5 0"), "E_PARSE 5"},
      {broken("vertex 1 0 0", "vertex nan 0 0"), "E_EMPTY 0"},
      {broken("vertex 1 0 0", "vertex 1e400 0 0"), "E_PARSE 5"},
      {broken("   vertex 1 0 0\n", ""), "E_PARSE 6"},
      {broken("  endloop", "   vertex 1 1 1\n  endloop"), "E_PARSE 7"},
      {broken(" endfacet", " endface"), "E_PARSE 8"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(outcome(read_stl(text)), expected) << text;
}

TEST(ReadStl, EveryMalformedBinaryFileHasItsCode) {
  const std::string good = two_binary_facets("x");
  EXPECT_EQ(outcome(read_stl("")), "E_EMPTY 0");
  EXPECT_EQ(outcome(read_stl("short")), "E_TRUNCATED 0");
  EXPECT_EQ(outcome(read_stl(binary("x", 0, {}))), "E_EMPTY 0");
  EXPECT_EQ(outcome(read_stl(two_binary_facets("x", 3))), "E_TRUNCATED 0");
  EXPECT_EQ(outcome(read_stl(two_binary_facets("x", 0xfffffffeU))), "E_TRUNCATED 0");
  EXPECT_EQ(outcome(read_stl(two_binary_facets("solid", 0xfffffffeU))), "E_TRUNCATED 0");
  EXPECT_EQ(
      outcome(read_stl(binary("x", 1, {0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0}))),
      "E_EMPTY 0");
  EXPECT_EQ(
      outcome(read_stl(binary("x", 1, {0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::infinity(), 0}))),
      "E_EMPTY 0");
  EXPECT_EQ(outcome(read_stl(good, {.vertices = 3, .corners = 100})), "E_LIMIT 0");
  EXPECT_EQ(outcome(read_stl(good, {.vertices = 9, .corners = 5})), "E_LIMIT 0");
  const auto longer = test::must(read_stl(good + "tail"));
  EXPECT_EQ(longer->warnings.at(0).code, w_trailing_data);
}

TEST(ReadStl, TrianglesThatAreNotFiniteAreLeftOutAndCounted) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  // The second triangle shares two corners with its neighbours.
  for (const std::string& bytes :
       {binary("x", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, none, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}),
        "solid s\n" + facet("0 0 0", "1 0 0", "0 1 0") + facet("1 0 0", "NaN 1 0", "0 1 0") +
            facet("1 0 0", "1 1 0", "0 1 0") + "endsolid s\n"}) {
    const auto read = test::must(read_stl(bytes));
    test::expect_sound(read->mesh);
    EXPECT_EQ(read->mesh.positions.size(), 4U);
    EXPECT_EQ(read->mesh.face_vertices, (std::vector<Index>{0, 1, 2, 1, 3, 2}));
    ASSERT_EQ(read->warnings.size(), 1U);
    EXPECT_EQ(read->warnings[0].text, "1 face with a coordinate that is not finite was left out.");
  }
}

TEST(ReadStl, ACountThatIsLeftOutIsTheFilesOwn) {
  for (const std::uint32_t count : {0U, 0xffffffffU})
    for (const char* header : {"x", "solid"}) {
      const auto read = test::must(read_stl(two_binary_facets(header, count) + "tail"));
      EXPECT_EQ(read->mesh.face_count(), 2U);
      ASSERT_EQ(read->warnings.size(), 2U);
      EXPECT_EQ(read->warnings[0].code, w_count_missing);
      EXPECT_EQ(read->warnings[1].code, w_trailing_data);
    }
}

TEST(ReadStl, TextWithoutItsEndIsReadWithAWarning) {
  const auto read = test::must(read_stl("solid s\n" + two_facets));
  EXPECT_EQ(read->mesh.face_count(), 2U);
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_EQ(read->warnings[0].code, w_end_missing);
  // The solid before has no end: the next one begins.
  const auto several = read_stl("solid a\n" + two_facets + "solid b\n" + two_facets + "endsolid b\n");
  ASSERT_TRUE(several.ok()) << to_string(several.error());
  EXPECT_EQ(several->mesh.face_count(), 4U);
  EXPECT_EQ(several->name, "a");
}

TEST(ReadStl, EachSolidIsAPartWithItsName) {
  const std::string left = facet("0 0 0", "1 0 0", "0 1 0"), right = facet("0 0 0", "0 1 0", "0 0 1");
  for (const std::string& text :
       {"solid left side\n" + left + "endsolid left side\nsolid empty\nendsolid\nsolid right\n" + right +
            "endsolid\n",
        "solid left side\n" + left + "solid right\n" + right + "endsolid right\n"}) {
    const auto scene = test::must(read_stl_scene(text));
    ASSERT_EQ(scene->parts.size(), 2U);
    EXPECT_EQ(scene->parts[0].name, "left side");
    EXPECT_EQ(scene->parts[1].name, "right");
    for (const ImportedPart& part : scene->parts) {
      test::expect_sound(part.mesh);
      EXPECT_EQ(part.mesh.positions.size(), 3U) << "solids share no corners";
    }
  }
  // Limits hold for all solids together.
  EXPECT_EQ(outcome(read_stl("solid\n" + left + "endsolid\nsolid\n" + right + "endsolid\n",
                             {.vertices = 99, .corners = 5})),
            "E_LIMIT 15");
}

TEST(ReadStl, MoreSolidsThanCanBeToldApartBecomeOneAndThatIsTold) {
  std::string text;
  for (std::size_t k = 0; k <= ImportedScene::max_parts; ++k)
    text += "solid part\n" + facet("0 0 0", "1 0 0", "0 1 0") + "endsolid part\n";
  const auto scene = test::must(read_stl_scene(text));
  ASSERT_EQ(scene->parts.size(), 1U);
  EXPECT_EQ(scene->parts[0].mesh.face_count(), ImportedScene::max_parts + 1);
  ASSERT_EQ(scene->warnings.size(), 1U);
  EXPECT_EQ(scene->warnings[0].code, w_objects_joined);
}

TEST(ReadStl, BlanksAndLineEndsAreAlike) {
  const std::string text = "solid facet of two\n" + two_facets + "endsolid facet of two\nsolid b\n" +
                           facet("0 0 0", "0 1 0", "0 0 1") + "endsolid b\n";
  std::string one_line = text, many_lines = text;
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  const std::size_t begin = text.find('\n');  // a name ends with its line
  for (std::size_t k = begin; k < text.find("endsolid"); ++k)
    if (many_lines[k] == ' ') many_lines[k] = '\n';
  for (const std::string& form : {text, one_line, many_lines}) {
    const auto scene = read_stl_scene(form);
    ASSERT_TRUE(scene.ok()) << to_string(scene.error()) << form;
    ASSERT_EQ(scene->parts.size(), 2U) << form;
    EXPECT_EQ(scene->parts[0].name, "facet of two");
    EXPECT_EQ(scene->parts[0].mesh.face_count(), 2U);
    EXPECT_EQ(scene->parts[1].name, "b");
    EXPECT_TRUE(scene->warnings.empty());
  }
}

TEST(ReadStl, OtherTextIsNotCalledCutOff) {
  std::string text;
  for (int k = 0; k < 20; ++k) text += "This is a letter.\n";
  EXPECT_EQ(outcome(read_stl(text)), "E_FORMAT_UNKNOWN 0");
}

TEST(ReadStl, TruncationAtEveryByteIsHandled) {
  for (const std::string& bytes :
       {"solid s\n" + two_facets + "endsolid", two_binary_facets("x"), two_binary_facets("solid")})
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      const auto read = read_stl(std::string(bytes, 0, size));
      if (!read.ok()) continue;
      // Text that ends behind a facet says so; a count tells what is missing.
      EXPECT_NE(bytes.find("facet"), std::string::npos) << size;
      EXPECT_EQ(read->warnings.at(0).code, w_end_missing) << size;
    }
}

TEST(PointWelder, AgreesWithASearchOfAllPoints) {
  test::for_random(1, 20, [](std::mt19937_64& rng) {
    PointWelder welder(0);  // grows many times
    std::vector<Vector3> seen;
    for (int i = 0; i < 1000; ++i) {
      const Vector3 p(test::uniform_int(rng, -4, 4), test::uniform_int(rng, -4, 4),
                      test::uniform_int(rng, -4, 4) * 1e-9);
      auto at = std::find(seen.begin(), seen.end(), p);
      if (at == seen.end()) at = seen.insert(seen.end(), p);
      ASSERT_EQ(welder.add(p), static_cast<Index>(at - seen.begin()));
    }
    EXPECT_EQ(welder.add({0.0, -0.0, 0.0}), welder.add({-0.0, 0.0, -0.0}));
  });
}

}  // namespace
}  // namespace hariko::test

// Files of Bezier patches of any degree.

#include "core/exchange/read_patches.hpp"

#include "core/exchange/imported_mesh.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

TEST(ReadPatches, TextOfAnyDegree) {
  const auto patches =
      read_bezier_text("2\n1 2\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n1 1\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n");
  ASSERT_TRUE(patches.ok()) << to_string(patches.error());
  ASSERT_EQ(patches->size(), 2U);
  EXPECT_EQ((*patches)[0].degree_s, 2);
  EXPECT_EQ((*patches)[0].degree_t, 1);
  EXPECT_EQ((*patches)[0].points[(*patches)[0].index(2, 1)], Vector3(2, 1, 0));
}

TEST(ReadPatches, TextIsRefusedWithItsLine) {
  const auto points = [](int count) {
    std::string out;
    for (int i = 0; i < count; ++i) out += std::to_string(i % 4) + " " + std::to_string(i / 4) + " 0.5\n";
    return out;
  };
  const auto code = [](const std::string& text) {
    const auto patches = read_bezier_text(text);
    return patches.ok() ? Code{"none"} : patches.error().code;
  };
  EXPECT_EQ(code("2\n3 3\n" + points(16) + "3 3\n" + points(16)), Code{"none"});
  EXPECT_EQ(code(""), e_empty);
  EXPECT_EQ(code("x"), e_parse);
  EXPECT_EQ(code("0"), e_limit);
  EXPECT_EQ(code("1\n3 3\n" + points(15)), e_truncated);
  EXPECT_EQ(code("1\n3 3\n" + points(15) + "1 2 nan"), e_parse);
  const auto broken = read_bezier_text("1\n3 3\n" + points(3) + "1 oops 3\n");
  ASSERT_FALSE(broken.ok());
  EXPECT_NE(broken.error().text.find("Line 6"), std::string::npos) << broken.error().text;
}

TEST(ReadPatches, IndexedText) {
  std::string text =
      "2\n1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16\n1,1,1,1,5,6,7,8,9,10,11,12,13,14,15,16\n16\n";
  for (int i = 0; i < 16; ++i) text += std::to_string(i % 4) + ", " + std::to_string(i / 4) + ",0.5\n";
  const auto patches = test::must(read_bezier_text(text));
  ASSERT_EQ(patches->size(), 2U);
  EXPECT_EQ((*patches)[0].points[6], Vector3(2, 1, 0.5));
  EXPECT_EQ((*patches)[1].points[3], Vector3(0, 0, 0.5));
  text.replace(text.find("16\n1,1"), 2, "17");
  const auto beyond = read_bezier_text(text);
  test::must_fail(beyond, e_index_range);
  EXPECT_NE(beyond.error().text.find("Line 2"), std::string::npos) << beyond.error().text;
}

TEST(ReadPatches, JsonHasRowsAlongS) {
  const auto named =
      read_bezier_json(R"({"a": [{"degree": [2, 1], "ctrl": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]],
      [[2,0,0],[2,1,0]]], "weights": [[1,1],[2,3],[1,1]]}], "note": "kept out"})");
  ASSERT_TRUE(named.ok()) << to_string(named.error());
  ASSERT_EQ(named->size(), 1U);
  const BezierPatch& patch = (*named)[0].patches[0];
  EXPECT_EQ((*named)[0].name, "a");
  EXPECT_EQ(patch.degree_s, 2);
  EXPECT_EQ(patch.points[patch.index(2, 1)], Vector3(2, 1, 0));
  EXPECT_EQ(patch.weights[patch.index(1, 1)], 3);
}

TEST(ReadPatches, WhatIsWrongIsSaid) {
  const auto code = [](const char* text) {
    const auto read = read_bezier_json(text);
    return read.ok() ? Code{"none"} : read.error().code;
  };
  EXPECT_EQ(code(""), e_parse);
  EXPECT_EQ(code("[]"), e_parse);
  EXPECT_EQ(code("{}"), e_empty);
  EXPECT_EQ(code(R"({"a": [{}]})"), e_parse);
  EXPECT_EQ(code(R"({"a": [{"ctrl": [[]]}]})"), e_parse);
  EXPECT_EQ(code(R"({"a": [{"ctrl": [[[0,0,0]]]}]})"), e_patch_degree);
  EXPECT_EQ(code(R"({"a": [{"ctrl": [[[0,0,0],[1,0,0]],[[0,1,0]]]}]})"), e_parse);
  EXPECT_EQ(code(R"({"a": [{"ctrl": [[[0,0,0],[1,0,0]],[[0,1,0],[1,1,0]]], "weights": [[1,1],[1,-1]]}]})"),
            e_patch_weights);
  EXPECT_EQ(code(R"({"a": [{"ctrl": [[[0,0,0],[1,0,0]],[[0,1,0],[1,1,"x"]]]}]})"), e_parse);
  test::must_fail(read_bezier_text("1\n16 1\n"), e_patch_degree);
}

TEST(ReadPatches, NoiseNeverCrashes) {
  test::for_random(4200, 300, [](std::mt19937_64& rng) {
    const std::string alphabet = "0123456789 \n,.-eE{}[]\":ctrlweights";
    std::string text = test::chance(rng, 0.5) ? "{\"a\": [{\"ctrl\": [[" : "2\n3 3\n";
    const int length = test::uniform_int(rng, 0, 200);
    for (int i = 0; i < length; ++i)
      text += alphabet[std::size_t(test::uniform_int(rng, 0, int(alphabet.size()) - 1))];
    const auto a = read_bezier_text(text);
    const auto b = read_bezier_json(text);
    EXPECT_TRUE(a.ok() || !a.error().text.empty());
    EXPECT_TRUE(b.ok() || !b.error().text.empty());
  });
}

}  // namespace
}  // namespace hariko

#include "core/exchange/obj/read_obj.hpp"

#include <array>
#include <filesystem>

#include "core/exchange/mesh_file.hpp"
#include "core/exchange/obj/write_control_mesh.hpp"
#include "tests/exchange/fixture_files.hpp"
#include "tests/exchange/mesh_text.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {
namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ReadObj, EveryFormOfACorner) {
  const auto result = read_obj(triangle +
                               "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 "
                               "3/1/1\nf -3 -2 -1\nf 1/ 2/ 3/\n");
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  test::expect_sound(result->mesh);
  ASSERT_EQ(result->mesh.face_count(), 6U);
  for (std::size_t f = 0; f < 6; ++f) {
    const auto face = result->mesh.face(f);
    EXPECT_EQ(std::vector<Index>(face.begin(), face.end()), (std::vector<Index>{0, 1, 2}));
  }
  EXPECT_TRUE(result->warnings.empty());
}

TEST(ReadObj, NegativeIndicesCountFromWhereTheyStand) {
  const auto result = test::must(read_obj(triangle + "f -3 -2 -1\nv 0 0 1\nf -4 -1 -3\n"));
  EXPECT_EQ(result->mesh.face_vertices, (std::vector<Index>{0, 1, 2, 0, 3, 1}));
}

TEST(ReadObj, FacesMayComeBeforeTheirVertices) {
  const auto result = test::must(read_obj("f 1 2 3\n" + triangle));
  EXPECT_EQ(result->mesh.face_vertices, (std::vector<Index>{0, 1, 2}));
}

TEST(ReadObj, LineEndsContinuationCommentsAndByteOrderMark) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text = "\xEF\xBB\xBF# comment \\" + end + "v 0 0 0 # origin" + end + "v 1\t0 \\" + end +
                             " 0" + end + "v 0 1 0" + end + end + "  f 1 2\\" + end + "\\" + end + " 3" +
                             end + "bad";
    const auto result = test::must(read_obj(text));
    EXPECT_EQ(result->mesh.positions.size(), 3U);
    EXPECT_EQ(result->mesh.face_vertices, (std::vector<Index>{0, 1, 2}));
    ASSERT_EQ(result->warnings.size(), 1U);
    EXPECT_EQ(result->warnings[0].element, (Element{Element::Kind::line, 10}));
  }
}

TEST(ReadObj, WeightsColoursAndNumberForms) {
  const auto result =
      read_obj("v +1.5 -.5 2. 1\nv 1e-3 1E+2 0.1 0.2 0.3 0.4\nv 123456789012345678901 1e-400 -0\nf 1 2 3\n");
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->mesh.positions[0], Vector3(1.5, -0.5, 2));
  EXPECT_EQ(result->mesh.positions[1], Vector3(1e-3, 1e2, 0.1));
  EXPECT_EQ(result->mesh.positions[2], Vector3(123456789012345678901.0, 0, 0));
}

TEST(ReadObj, NameIsTheFirstObjectElseTheFirstGroup) {
  EXPECT_EQ(read_obj(triangle + "g side\no  Car body \no other\nf 1 2 3\n")->name, "Car body");
  EXPECT_EQ(read_obj(triangle + "g side\nf 1 2 3\n")->name, "side");
  EXPECT_EQ(read_obj(triangle + "f 1 2 3\n")->name, "");
  EXPECT_EQ(read_obj(triangle + "o a\x01z 張り子\nf 1 2 3\n")->name, "a?z 張り子");
}

TEST(ReadObj, NamesInOldEncodingsAreReadAndTold) {
  const auto western = test::must(read_obj(triangle + "o T\xfcr\nf 1 2 3\n"));
  EXPECT_EQ(western->name, "Tür");
  ASSERT_EQ(western->warnings.size(), 1U);
  EXPECT_EQ(western->warnings[0].code, w_name_letters);
  EXPECT_TRUE(western->warnings[0].text.starts_with("1 letters of the OBJ file"))
      << western->warnings[0].text;
  const auto japanese = read_obj(triangle + "g \x92\xa3\x82\xe8\x8e\x71\nf 1 2 3\n");  // Shift-JIS
  ASSERT_TRUE(japanese.ok());
  EXPECT_EQ(japanese->name, "張り子");
  EXPECT_TRUE(read_obj(triangle + "o Tür\nf 1 2 3\n")->warnings.empty());
}

TEST(ReadObj, IgnoredStatementsAreSilentAndUnknownOnesGiveOneWarning) {
  const auto result =
      test::must(read_obj("mtllib C:\\a\\b.mtl\n" + triangle +
                          "vt 0 0\nvn 0 0 1\nvp 0\ng a\ns off\nusemtl m\nf 1 2 3\nfoo 1\nbar 2\nfoo 3\n"));
  ASSERT_EQ(result->warnings.size(), 1U);
  EXPECT_EQ(result->warnings[0].code, w_unknown_statement);
  EXPECT_EQ(result->warnings[0].element, (Element{Element::Kind::line, 12}));
  EXPECT_NE(result->warnings[0].text.find("\"foo\" is not"), std::string::npos) << result->warnings[0].text;
  EXPECT_NE(result->warnings[0].text.find("2 more"), std::string::npos) << result->warnings[0].text;
}

TEST(ReadObj, ObjectsAreApartAndSoAreGroupsThatMeetNowhere) {
  const std::string far = "v 9 0 0\nv 10 0 0\nv 9 1 0\n";
  auto scene = read_obj_scene("o one\n" + triangle + "f 1 2 3\no two\n" + far + "f 6 5 4\nf 3 2 1\n");
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  ASSERT_EQ(scene->parts.size(), 2U);
  EXPECT_EQ(scene->parts[0].name, "one");
  EXPECT_EQ(scene->parts[0].mesh.positions.size(), 3U);
  EXPECT_EQ(scene->parts[1].name, "two");
  EXPECT_EQ(scene->parts[1].mesh.positions.size(), 6U);
  EXPECT_EQ(scene->parts[1].mesh.face_vertices, (std::vector<Index>{5, 4, 3, 2, 1, 0}));
  scene = read_obj_scene("g one\n" + triangle + "f 1 2 3\ng two\n" + far + "f 6 5 4\ng one\nf 1 3 2\n");
  ASSERT_EQ(scene->parts.size(), 2U);
  EXPECT_EQ(scene->parts[0].mesh.face_count(), 2U) << "a group goes on";
  EXPECT_EQ(scene->parts[1].name, "two");
  // Groups of one surface share corners, or have corners of their own at the same places.
  scene = read_obj_scene("g one\n" + triangle + "f 1 2 3\ng two\n" + triangle + "v 1 1 0\nf 5 7 6\n");
  ASSERT_EQ(scene->parts.size(), 1U);
  EXPECT_EQ(scene->parts[0].mesh.positions.size(), 7U);
  EXPECT_EQ(scene->parts[0].name, "one");
  EXPECT_EQ(read_obj("o a\n" + triangle + "f 1 2 3\no b\nf 3 2 1\n")->mesh.face_count(), 2U);
  // A camera without faces gives its name to nothing.
  scene = read_obj_scene("o camera\no cube\n" + triangle + "f 1 2 3\no light\n");
  ASSERT_EQ(scene->parts.size(), 1U);
  EXPECT_EQ(scene->parts[0].name, "cube");
}

TEST(ReadObj, MoreObjectsThanCanBeToldApartBecomeOneAndThatIsTold) {
  for (const std::size_t more : {0U, 1U}) {
    std::string text = triangle;
    for (std::size_t k = 0; k < ImportedScene::max_parts + more; ++k) text += "o part\nf 1 2 3\n";
    const auto scene = test::must(read_obj_scene(text));
    EXPECT_EQ(scene->parts.size(), more > 0 ? 1U : ImportedScene::max_parts);
    ASSERT_EQ(scene->warnings.size(), more);
    if (more == 0) continue;
    EXPECT_EQ(scene->warnings[0].code, w_objects_joined);
    EXPECT_EQ(scene->parts[0].mesh.face_count(), ImportedScene::max_parts + 1);
  }
}

TEST(ReadObj, CreaseTagsOfOurOwnControlMeshesComeBack) {
  ControlMesh first, second;
  first.mesh = test::octahedron();
  first.creases = {{0, 2, infinitely_sharp}, {2, 1, 0.5}};
  first.corners = {{4, infinitely_sharp}};
  second.mesh = test::torus(5, 4);
  const Index a = second.mesh.face(3)[0], b = second.mesh.face(3)[1];
  second.creases = {{a, b, infinitely_sharp}};
  const std::array<NamedControlMesh, 2> named{{{"first", &first}, {"second", &second}}};
  const auto scene = test::must(read_obj_scene(write_control_obj(named)));
  ASSERT_EQ(scene->parts.size(), 2U);
  using Creases = std::vector<std::array<Index, 2>>;
  EXPECT_EQ(scene->parts[0].creases, (Creases{{0, 2}, {1, 2}}));
  EXPECT_EQ(scene->parts[0].corners, (std::vector<Index>{4}));
  EXPECT_EQ(scene->parts[1].creases, (Creases{{std::min(a, b), std::max(a, b)}}));
  EXPECT_TRUE(scene->parts[1].corners.empty());
  ASSERT_EQ(scene->warnings.size(), 1U);
  EXPECT_EQ(scene->warnings[0].code, w_soft_creases);
  // Chains; tags that say nothing; and what cannot be read.
  const auto tags = read_obj_scene(triangle +
                                   "f 1 2 3\nt crease 3/1/0 0 1 2 10\nt crease 2/1/0 2 0 0\n"
                                   "t interpolateboundary 1/0/0 1\nt crease 2/1/0 0 9 10\nt corner x\n");
  ASSERT_TRUE(tags.ok());
  EXPECT_EQ(tags->parts[0].creases, (Creases{{0, 1}, {1, 2}}));
  ASSERT_EQ(tags->warnings.size(), 1U);
  EXPECT_EQ(tags->warnings[0].code, w_unknown_statement);
  EXPECT_TRUE(tags->warnings[0].text.starts_with("2 tags")) << tags->warnings[0].text;
}

TEST(ReadObj, Utf16IsRead) {
  const std::string text = "o 張り𝄞\n" + triangle + "f 1 2 3\n";
  const std::u16string wide = u"o 張り𝄞\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  ASSERT_EQ(triangle, "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  for (const bool big : {false, true})
    for (const bool mark : {true, false}) {
      std::string bytes = !mark ? "" : big ? "\xfe\xff" : "\xff\xfe";
      for (const char16_t unit : mark ? wide : wide.substr(7)) {
        const char low = char(unit & 0xff), high = char(unit >> 8);
        bytes += big ? std::string{high, low} : std::string{low, high};
      }
      const auto read = test::must(read_obj(bytes));
      if (mark) {
        EXPECT_EQ(read->name, read_obj(text)->name);
      }
      EXPECT_EQ(read->mesh.positions, read_obj(text)->mesh.positions);
    }
}

/// Points of a plane net of `columns` x `rows` control points, as statements.
std::string net(int columns, int rows) {
  std::string out;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      out += "v " + std::to_string(i) + " " + std::to_string(j) + " 0 " + (i == 1 ? "0.5\n" : "\n");
  return out;
}

TEST(ReadObj, BezierSurfacesAreObjectsOfPatches) {
  std::string numbers;
  for (int k = 1; k <= 28; ++k) numbers += " " + std::to_string(k);
  const std::string text = net(7, 4) + "o sheet\ncstype rat bezier\ndeg 3 3\nsurf 0 2 0 1" + numbers +
                           "\nparm u 0 1 2\nparm v 0 1\nend\n";
  const auto scene = test::must(read_obj_scene(text));
  EXPECT_TRUE(scene->parts.empty());
  ASSERT_EQ(scene->patches.size(), 1U);
  EXPECT_EQ(scene->patches[0].name, "sheet");
  ASSERT_EQ(scene->patches[0].patches.size(), 2U);
  const BezierPatch& second = scene->patches[0].patches[1];
  EXPECT_EQ(second.points[second.index(0, 0)], Vector3(3, 0, 0));
  EXPECT_EQ(second.points[second.index(3, 2)], Vector3(6, 2, 0));
  const BezierPatch& first = scene->patches[0].patches[0];
  EXPECT_EQ(first.weights[first.index(1, 3)], 0.5);
  EXPECT_EQ(first.weights[first.index(2, 3)], 1);
  EXPECT_TRUE(read_obj_scene(test::with(text, "rat ", ""))->patches[0].patches[0].weights.empty());
  // Both kinds in one file; and free forms of other kinds.
  const auto both = test::must(read_obj_scene(text + "f 1 2 3\ncstype bspline\nsurf 0 1 0 1 1 2 3\nend\n"));
  EXPECT_EQ(both->parts.size(), 1U);
  EXPECT_EQ(both->patches.size(), 1U);
  ASSERT_EQ(both->warnings.size(), 1U);
  EXPECT_EQ(both->warnings[0].code, w_left_out);
  const auto code = [](const std::string& changed) {
    const auto read = read_obj_scene(changed);
    return read.ok() ? std::string("ok") : std::string(read.error().code.name);
  };
  EXPECT_EQ(code(test::with(text, " 28\n", "\n")), "E_PARSE");
  EXPECT_EQ(code(test::with(text, " 28\n", " 29\n")), "E_INDEX_RANGE");
  EXPECT_EQ(code(test::with(text, " 28\n", " x\n")), "E_PARSE");
  EXPECT_EQ(code(test::with(text, "deg 3 3", "deg 16 3")), "E_PATCH_DEGREE");
  EXPECT_EQ(code(test::with(text, "0.5", "-1")), "E_PATCH_WEIGHTS");
  EXPECT_EQ(code(test::with(text, "parm u 0 1 2", "parm u 0 1")), "E_PARSE");
  EXPECT_EQ(code("cstype bspline\nv 0 0 0\nsurf 0 1 0 1 1\n"), "E_EMPTY");
}

TEST(ReadObj, ControlPointsOfSurfacesAreNoVerticesOfTheMesh) {
  const auto scene = test::must(
      read_obj_scene("v 0 0 0\nv 9 0 0\nv 0 9 0\nv 9 9 5\ncstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nend\n"
                     "o tip\nv 0 0 7\nv 1 0 7\nv 0 1 7\nf 5 6 7\n"));
  ASSERT_EQ(scene->parts.size(), 1U);
  EXPECT_EQ(scene->parts[0].name, "tip");
  EXPECT_EQ(scene->parts[0].mesh.positions, (std::vector<Vector3>{{0, 0, 7}, {1, 0, 7}, {0, 1, 7}}));
  EXPECT_EQ(scene->patches.size(), 1U);
}

/// One bicubic patch over 0 .. 3 by 0 .. 3, heights from a polynomial of its parameters, as statements.
std::string bicubic(const std::string& range, const std::string& body) {
  std::string out, numbers;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      out +=
          "v " + std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(i * i * (j + 1)) + "\n";
      numbers += " " + std::to_string(4 * j + i + 1);
    }
  return out + "cstype bezier\ndeg 3 3\nsurf " + range + numbers + "\n" + body + "end\n";
}

/// Point of a patch by the definition: Bernstein polynomials.
Vector3 bernstein_point(const BezierPatch& patch, double s, double t) {
  const auto value = [](int n, int i, double x) {
    double binomial = 1;
    for (int k = 0; k < i; ++k) binomial = binomial * (n - k) / (k + 1);
    return binomial * std::pow(x, i) * std::pow(1 - x, n - i);
  };
  Vector3 sum = Vector3::Zero();
  double weights = 0;
  for (int j = 0; j <= patch.degree_t; ++j)
    for (int i = 0; i <= patch.degree_s; ++i) {
      const std::size_t at = patch.index(i, j);
      const double w = value(patch.degree_s, i, s) * value(patch.degree_t, j, t) *
                       (patch.rational() ? patch.weights[at] : 1);
      sum += w * patch.points[at];
      weights += w;
    }
  return sum / weights;
}

TEST(ReadObj, SurfacesEndAtTheirParameterRange) {
  const std::string knots = "parm u 0 1\nparm v 0 2\n";
  for (const bool rational : {false, true}) {
    const auto read = [&](const std::string& range) {
      std::string text = bicubic(range, knots);
      if (rational) text = test::with(test::with(text, "bezier", "rat bezier"), "v 1 1 2\n", "v 1 1 2 3\n");
      auto scene = test::must(read_obj_scene(text));
      EXPECT_TRUE(scene->warnings.empty());
      return scene->patches.at(0).patches.at(0);
    };
    const BezierPatch whole = read("0 1 0 2"), part = read("0.25 0.75 0.5 2");
    for (const double s : {0.0, 0.3, 1.0})
      for (const double t : {0.0, 0.6, 1.0})
        EXPECT_LT(
            (bernstein_point(part, s, t) - bernstein_point(whole, 0.25 + s / 2, 0.25 + t * 0.75)).norm(),
            1e-12)
            << s << " " << t;
    EXPECT_EQ(read("0 9 -1 7"), whole) << "the knots end it";
    EXPECT_EQ(read("5 6 0 2"), whole) << "a range beside the knots says nothing";
  }
  // Pieces outside the range are gone.
  std::string numbers;
  for (int k = 1; k <= 28; ++k) numbers += " " + std::to_string(k);
  const auto second = test::must(read_obj_scene(net(7, 4) + "cstype bezier\ndeg 3 3\nsurf 1 2 0 1" + numbers +
                                                "\nparm u 0 1 2\nparm v 0 1\nend\n"));
  ASSERT_EQ(second->patches.at(0).patches.size(), 1U);
  EXPECT_EQ(second->patches[0].patches[0].points[0], Vector3(3, 0, 0));
}

TEST(ReadObj, FreeFormsThatAreLeftOutAreCounted) {
  const std::string knots = "parm u 0 1\nparm v 0 1\n";
  const auto texts = [](const std::string& text) {
    const auto scene = read_obj_scene(text);
    std::vector<std::string> out;
    if (!scene.ok()) return std::vector<std::string>{to_string(scene.error())};
    for (const Message& warning : scene->warnings) {
      EXPECT_EQ(warning.code, w_left_out);
      out.push_back(warning.text);
    }
    return out;
  };
  using Texts = std::vector<std::string>;
  const std::string patch = bicubic("0 1 0 1", knots), faces = triangle + "f 1 2 3\n";
  EXPECT_EQ(texts(patch), Texts{});
  EXPECT_EQ(texts(bicubic("0 1 0 1", knots + "trim 0 4 1\nhole 0 4 2\n")),
            Texts{"A surface is there as a whole: the curves that trim it were left out."});
  EXPECT_EQ(texts(faces + "cstype bezier\ndeg 3\ncurv 0 1 1 2 3 1\nparm u 0 1\nend\ncdc 1 2 3 1\n"),
            Texts{"2 free-form curves were left out."});
  EXPECT_EQ(texts(faces + "call more.obj\n"), Texts{"The file takes in \"more.obj\", which is not read."});
  EXPECT_EQ(texts(faces + "call a.obj\ncall b.obj\n"),
            Texts{"The file takes in 2 other files, first \"a.obj\", which are not read."});
  EXPECT_EQ(texts(faces + "t hole 1/0/0 0\n"), Texts{"A face that the file marks as a hole is closed here."});
  EXPECT_EQ(texts(faces + "t hole 2/0/0 0 1\nt hole 1/0/0 2\n"),
            Texts{"3 faces that the file marks as holes are closed here."});
  // The older statements: a Bezier patch is read, others are not.
  const std::string points = patch.substr(0, patch.find("cstype")),
                    sixteen = " 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\n";
  const auto old = read_obj_scene(points + "bzp" + sixteen), now = read_obj_scene(patch);
  ASSERT_TRUE(old.ok()) << to_string(old.error());
  EXPECT_EQ(old->patches.at(0).patches, now->patches.at(0).patches);
  EXPECT_EQ(texts(faces + "bsp 1 2 3\ncdp 1 2 3\n"),
            Texts{"2 free-form surfaces that are no Bezier surfaces were left out."});
  // Alone, they are the reason.
  for (const char* kind :
       {"cstype bspline\ndeg 3 3\nsurf 0 1 0 1", "cstype cardinal\ndeg 3 3\nsurf 0 1 0 1", "bsp"}) {
    const auto alone = read_obj_scene(points + kind + sixteen);
    test::must_fail(alone, e_empty);
    EXPECT_NE(alone.error().text.find("A free-form surface that is no Bezier surface"), std::string::npos)
        << alone.error().text;
  }
}

struct Bad {
  std::string text;
  std::string expected;
};

TEST(ReadObj, EveryMalformationHasItsCodeAndLine) {
  const std::vector<Bad> cases{
      {"", "E_EMPTY 1"},
      {"# only a comment\n", "E_EMPTY 2"},
      {triangle, "E_EMPTY 4"},
      {"\x7f"
       "ELF\x01\x02\nxyz\n",
       "E_FORMAT_UNKNOWN 1"},
      {"v 1 2\nf 1 1 1\n", "E_PARSE 1"},
      {"v 0 0 0\nv 1,5 0 0\n", "E_PARSE 2"},
      {"v 0 0 0\nv nan 0 0\n", "E_PARSE 2"},
      {"v 0 inf 0\n", "E_PARSE 1"},
      {"v 0 0 1e999\n", "E_PARSE 1"},
      {"v 0 0 0x10\n", "E_PARSE 1"},
      {"v 0 0 +-1\n", "E_PARSE 1"},
      {"v 0 0 1e\n", "E_PARSE 1"},
      {"v 0 0 0 red\n", "E_PARSE 1"},
      {"v 0 0\n0\n", "E_PARSE 1"},
      {"v 0 0", "E_TRUNCATED 1"},
      {triangle + "f\n", "E_PARSE 4"},
      {triangle + "f 1 2 x\n", "E_PARSE 4"},
      {triangle + "f 1 2 3/x\n", "E_PARSE 4"},
      {triangle + "f 1 2 3/1/1/1\n", "E_PARSE 4"},
      {triangle + "f 1 2 /3\n", "E_PARSE 4"},
      {triangle + "f 1 2 3.5\n", "E_PARSE 4"},
      {triangle + "\nf 1 2 0\n", "E_INDEX_RANGE 5"},
      {triangle + "f 1 2 3\nf 1 2 4\nf 1 2 3\n", "E_INDEX_RANGE 5"},
      {triangle + "f 1 2 4\nf 1 2 6\nv 0 0 0\n", "E_INDEX_RANGE 5"},
      {triangle + "f 1 2 -4\n", "E_INDEX_RANGE 4"},
      {triangle + "f 1 2 99999999999999999999\n", "E_INDEX_RANGE 4"},
      {triangle + "f 1 2 -99999999999999999999\n", "E_INDEX_RANGE 4"},
      {triangle + "f 1 2 -9223372036854775808\n", "E_INDEX_RANGE 4"},
      {triangle + "f 1 2 4294967297\n", "E_INDEX_RANGE 4"},
      {triangle + "f 1 \\\n 2 \\\n x\n", "E_PARSE 6"},
  };
  for (const Bad& bad : cases) EXPECT_EQ(outcome(read_obj(bad.text)), bad.expected) << bad.text;
}

TEST(ReadObj, MessagesSayColumnAndReason) {
  const auto result = read_obj("v 0 0 0\nv 0  1,5 0\n");
  EXPECT_EQ(result.error().text, "Line 2, column 6: The coordinate should be a number, but is \"1,5\".");
  EXPECT_NE(result.error().remedy.find("decimal point"), std::string::npos);
}

TEST(ReadObj, LimitsAreErrorsWithALine) {
  const std::string text = triangle + "f 1 2 3\nf 1 2 3\n";
  EXPECT_EQ(outcome(read_obj(text, {.vertices = 2, .corners = 100})), "E_LIMIT 3");
  EXPECT_EQ(outcome(read_obj(text, {.vertices = 3, .corners = 5})), "E_LIMIT 5");
  EXPECT_EQ(outcome(read_obj(text, {.vertices = 3, .corners = 6})), "ok");
}

TEST(ReadObj, TruncationAtEveryByteIsHandled) {
  const std::string text = "o n\\\nme\n" + triangle + "vt 0 0\nf 1/1/1 2//2 \\\r\n -1\nunknown\n";
  for (std::size_t size = 0; size <= text.size(); ++size) {
    const std::string copy = text.substr(0, size);
    const auto result = read_obj(std::string_view(copy.data(), copy.size()));
    if (result.ok()) test::expect_sound(result->mesh);
  }
}

TEST(ReadObj, LongContinuationsAndLongTokensTakeLinearTime) {
  std::string text = triangle + "f 1 2 ";
  for (int i = 0; i < 500'000; ++i) text += "\\\n";
  EXPECT_EQ(outcome(read_obj(text + "3\n")), "ok");
  EXPECT_EQ(outcome(read_obj("v 0 0 " + std::string(5'000'000, '9') + "\n")), "E_PARSE 1");
  EXPECT_EQ(outcome(read_obj("v 0 0 0." + std::string(5'000'000, '0') + "1\n")), "E_EMPTY 2");
}

TEST(ReadObj, GoldenModels) {
  struct Model {
    const char* name;
    std::size_t vertices, faces;
  };
  // Euler characteristics of the closed ones are checked too: a reader that lost a line would show.
  const std::filesystem::path folder = std::filesystem::path(test::source_folder()) / "tests" / "golden";
  for (const auto& [name, vertices, faces] : {Model{"cube.obj", 8, 6}, Model{"octahedron.obj", 6, 8},
                                              Model{"prism6.obj", 12, 8}, Model{"concave.obj", 16, 10}}) {
    const auto result = test::must(read_mesh_file(folder / name));
    EXPECT_EQ(result->mesh.positions.size(), vertices) << name;
    EXPECT_EQ(result->mesh.face_count(), faces) << name;
  }
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    ++count;
    const std::string text = test::slurp(entry.path());
    std::size_t vertices = 0, faces = 0;
    for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1) {
      vertices += text.compare(begin, 2, "v ") == 0;
      faces += text.compare(begin, 2, "f ") == 0;
      if (text.find('\n', begin) == std::string::npos) break;
    }
    const auto result = test::must(read_mesh_file(entry.path()));
    EXPECT_TRUE(result->warnings.empty()) << entry.path();
    EXPECT_EQ(result->mesh.positions.size(), vertices) << entry.path();
    EXPECT_EQ(result->mesh.face_count(), faces) << entry.path();
    EXPECT_TRUE(validate(result->mesh).empty() || validate(result->mesh)[0].severity == Severity::warning);
  }
  EXPECT_GE(count, 9U);
}

TEST(ReadObj, PointsAndLinesAreLeftOutWithACount) {
  const auto read = read_parts("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2 3\np 1\n", MeshFormat::obj);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_EQ(read->warnings[0].code, w_left_out);
  EXPECT_EQ(read->warnings[0].text, "2 sets of points or lines were left out.");
}

}  // namespace
}  // namespace hariko::test

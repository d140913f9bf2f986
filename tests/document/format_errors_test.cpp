// Files that are not documents: each gets its code, and nothing crashes, hangs or takes memory without bound.

#include "core/base/files/file_io.hpp"
#include "core/document/edits/edit_elements.hpp"
#include "core/document/format/format.hpp"
#include "core/network/network.hpp"
#include "core/polyhedron/validation.hpp"
#include "tests/document/random_documents.hpp"
#include "tests/support/places.hpp"

namespace hariko {
namespace {

struct Bad {
  const char* text;
  Code code;
  const char* part_of_message;
};

void expect_refused(const std::string& text, Code code, const std::string& part) {
  const Result<Document> result = read_document(text);
  ASSERT_FALSE(result) << text.substr(0, 500);
  EXPECT_EQ(result.error().code.name, code.name) << to_string(result.error()) << "\n" << text.substr(0, 500);
  EXPECT_NE(result.error().text.find(part), std::string::npos) << to_string(result.error());
  EXPECT_FALSE(result.error().remedy.empty());
}

TEST(FormatErrors, NotJson) {
  const std::vector<Bad> cases{
      {"", e_parse, "line 1, column 1 the text ends too early"},
      {"{", e_parse, "line 1, column 2 the text ends too early"},
      {"{\n  \"format\": \"hariko\"\n  \"version\": 1}", e_parse, "line 3, column 11"},
      {"{\"a\": nul}", e_parse, "line 1, column 10"},
      {"{\"a\": 1} x", e_parse, "line 1, column 10"},
      {"{\"a\": 1e400}", e_parse, "too large"},
      {"{\"a\": NaN}", e_parse, "line 1"},
      {"{\"a\": 01}", e_parse, "line 1"},
      {"{\"a\": \"\xff\"}", e_parse, "line 1"},
      {"{\"a\": \"\x01\"}", e_parse, "line 1"},
      {"\x89PNG", e_parse, "line 1"},
      {"v 0 0 0\n", e_parse, "line 1"},
  };
  for (const Bad& bad : cases) expect_refused(bad.text, bad.code, bad.part_of_message);
  EXPECT_EQ(read_document("{\n\n  1}").error().element, (Element{Element::Kind::line, 3}));
}

TEST(FormatErrors, ForeignNamesAreShownWithoutControlCharacters) {
  std::string text = read_file(test::source_folder() + "/assets/samples/solids_one.hariko").value();
  const std::string name = "\"type\": \"box\"";
  const std::size_t at = text.find(name);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, name.size(), R"("type": "b\u0001o\u0000x")");
  expect_refused(text, e_schema, "there is no solid \"b?o?x\"");
}

TEST(FormatErrors, Head) {
  expect_refused("[]", e_format, "not a Hariko document");
  expect_refused("{}", e_format, "not a Hariko document");
  expect_refused(R"({"format": 3})", e_format, "not a Hariko document");
  expect_refused(R"({"format": "other", "version": 1})", e_format, "not a Hariko document");
  expect_refused(R"({"format": "hariko"})", e_schema, "\"version\" is missing");
  expect_refused(R"({"format": "hariko", "version": "1"})", e_schema, "version: ");
  expect_refused(R"({"format": "hariko", "version": 0})", e_schema, "version: ");
  expect_refused(R"({"format": "hariko", "version": 1.5})", e_schema, "version: ");
  expect_refused(R"({"format": "hariko", "version": 1})", e_schema, "\"objects\" is missing");
  // A newer file is refused for being newer, whatever else is in it.
  const std::string newer = std::to_string(format_version + 1);
  expect_refused(R"({"objects": 5, "version": )" + newer + R"(, "format": "hariko"})", e_version_newer,
                 "format version " + newer);
}

/// A good document with `from` replaced by `to`, which must occur.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string tent_text() {
  return R"({"format": "hariko", "version": 1, "unit": "mm", "next_object_id": 5, "objects": [
    {"id": 4, "name": "Tent", "visible": true, "locked": false,
     "transform": {"rotation": [1, 0, 0, 0], "scale": 1, "translation": [0, 0, 0]},
     "display": {"surface": true, "map": "shaded", "density": 8, "colour": "#b9b4ac"},
     "source": {"kind": "polyhedron", "mode": "fair", "mirror": {"axis": "y", "weld_distance": 0.5},
       "origin": [0, 0, 0],
       "vertices": [[3, 0, 0, 0], [5, 1, 0, 0], [7, 0, 1, 0], [9, 0, 0, 1]],
       "faces": [[0, 3, 5, 9], [1, 5, 7, 9]],
       "alpha": [[3, 1], [5, 2]], "beta": [[3, 5, 2], [3, 9, 2]], "crease": [[5, 9]], "tag": [[3, "corner"]],
       "pin": [{"vertex": 3, "kind": "normal", "vectors": [[0, 0, 1]]}]}}]})";
}

TEST(FormatErrors, Schema) {
  const std::string good = tent_text();
  ASSERT_TRUE(read_document(good)) << to_string(read_document(good).error());
  struct Case {
    const char *from, *to, *path;
  };
  const std::vector<Case> cases{
      {R"("unit": "mm")", R"("unit": "furlong")", "unit: one of mm, cm, m, in"},
      {R"("unit": "mm")", R"("unit": "mm", "unit": "mm")", "\"unit\" appears twice"},
      {R"("next_object_id": 5)", R"("next_object_id": 4)", "next_object_id must be above"},
      {R"("next_object_id": 5)", R"("next_object_id": -1)", "next_object_id: a whole number"},
      {R"("id": 4, )", "", "objects[0]: the member \"id\" is missing"},
      {R"("id": 4)", R"("id": 4.5)", "objects[0].id: a whole number"},
      {R"("id": 4)", R"("id": 4294967295)", "objects[0].id: a whole number"},
      {R"("id": 4)", R"("id": 1e300)", "objects[0].id: a whole number"},
      {R"("name": "Tent", )", "", "objects[0]: the member \"name\" is missing"},
      {R"("name": "Tent")", R"("name": 5)", "objects[0].name: a text"},
      {R"("visible": true)", R"("visible": 1)", "objects[0].visible: true or false"},
      {R"("locked": false)", R"("locked": null)", "objects[0].locked: true or false"},
      {R"([1, 0, 0, 0], "scale")", R"([1, 0, 0], "scale")", "objects[0].transform.rotation: a list of 4"},
      {R"([1, 0, 0, 0], "scale")", R"([1, 0, 0, 1], "scale")",
       "objects[0].transform.rotation: a unit quaternion"},
      {R"("scale": 1)", R"("scale": 0)", "objects[0].transform.scale: "},
      {R"("scale": 1)", R"("scale": -1)", "objects[0].transform.scale: "},
      {R"("scale": 1)", R"("scale": 1e10)", "objects[0].transform.scale: "},
      {R"("scale": 1)", R"("skew": 1)", "objects[0].transform: the member \"skew\" is unknown"},
      {R"("translation": [0, 0, 0])", R"("translation": [0, 0, "0"])",
       "objects[0].transform.translation[2]: a number"},
      {R"("map": "shaded")", R"("map": "heat")", "objects[0].display.map: one of shaded"},
      {R"("density": 8)", R"("density": 0)", "objects[0].display.density: "},
      {R"("density": 8)", R"("density": 65)", "objects[0].display.density: "},
      {R"("density": 8)", R"("shine": 8)", "objects[0].display: the member \"shine\" is unknown"},
      {R"("#b9b4ac")", R"("#B9B4AC")", "objects[0].display.colour: a colour"},
      {R"("#b9b4ac")", R"("red")", "objects[0].display.colour: a colour"},
      {R"("kind": "polyhedron", )", "", "objects[0].source: the member \"kind\" is missing"},
      {R"("mode": "fair")", R"("mode": "best")", "objects[0].source.mode: one of paper"},
      {R"("origin": [0, 0, 0])", R"("origin": 0)", "objects[0].source.origin: a list"},
      {"[3, 0, 0, 0]", "[3, 0, 0]", "objects[0].source.vertices[0]: a list of 4"},
      {"[5, 1, 0, 0]", "[3, 1, 0, 0]", "objects[0].source.vertices[1]: entries must be in ascending order"},
      {"[5, 1, 0, 0]", "[5, 1, true, 0]", "objects[0].source.vertices[1][2]: a number"},
      {"[5, 1, 0, 0]", "[-5, 1, 0, 0]", "objects[0].source.vertices[1][0]: a whole number"},
      {"[1, 5, 7, 9]", "[0, 5, 7, 9]", "objects[0].source.faces[1]: entries must be in ascending order"},
      {"[1, 5, 7, 9]", "[1, 5, 6, 9]", "objects[0].source.faces[1][2]: there is no vertex"},
      {"[1, 5, 7, 9]", "[]", "objects[0].source.faces[1]: the list is too short"},
      {R"("faces")", R"("sides")", "objects[0].source: the member \"faces\" is missing"},
      {"[3, 1], [5, 2]", "[5, 1], [3, 2]", "objects[0].source.alpha[1]: entries must be in ascending order"},
      {"[3, 1], [5, 2]", "[3, 1], [4, 2]", "objects[0].source.alpha[1][0]: there is no vertex"},
      {"[3, 1], [5, 2]", "[3, 1], [5]", "objects[0].source.alpha[1]: a list of 2"},
      {"[3, 9, 2]", "[9, 3, 2]", "objects[0].source.beta[1]: there is no edge"},
      {"[3, 9, 2]", "[3, 7, 2]", "objects[0].source.beta[1]: there is no edge"},
      {"[3, 9, 2]", "[3, 5, 2]", "objects[0].source.beta[1]: entries must be in ascending order"},
      {R"("crease": [[5, 9]])", R"("crease": [[5, 8]])", "objects[0].source.crease[0]: there is no edge"},
      {R"([[3, "corner"]])", R"([[3, "round"]])", "objects[0].source.tag[0][1]: one of automatic"},
      {R"("axis": "y")", R"("axis": "w")", "objects[0].source.mirror.axis: one of x, y, z"},
      {R"("axis": "y")", R"("axis": "y", "x": 1)", "objects[0].source.mirror: the member \"x\" is unknown"},
      {R"("weld_distance")", R"("distance")", "objects[0].source.mirror: the member \"distance\" is unknown"},
      {R"({"axis": "y", "weld_distance": 0.5})", "true", "objects[0].source.mirror: an object"},
      {R"("vertex": 3)", R"("vertex": 4)", "objects[0].source.pin[0].vertex: there is no vertex"},
      {R"("kind": "normal")", R"("kind": "bend")", "objects[0].source.pin[0].kind: one of tangents"},
      {R"("kind": "normal")", R"("kind": "normal", "x": 1)",
       "objects[0].source.pin[0]: the member \"x\" is unknown"},
      {R"("vectors": [[0, 0, 1]])", R"("vectors": [[0, 1]])",
       "objects[0].source.pin[0].vectors[0]: a list of 3"},
  };
  for (const Case& c : cases) expect_refused(with(good, c.from, c.to), e_schema, c.path);
  const std::string twice = R"({"id": 1, "name": "a", "source": {"kind": "x"}})";
  expect_refused(R"({"format": "hariko", "version": 1, "objects": [)" + twice + "," + twice + "]}", e_schema,
                 "two objects have the id 1");
}

TEST(FormatErrors, AnUnknownMemberIsTheFirstErrorOfItsObject) {
  const std::string good = tent_text();
  expect_refused(with(good, R"("scale": 1)", R"("scale": 0, "skew": 1)"), e_schema,
                 "objects[0].transform: the member \"skew\" is unknown");
  const std::string two = with(good, R"("visible": true)", R"("visible": 1)");
  expect_refused(with(two, R"("scale": 1)", R"("skew": 1)"), e_schema, "objects[0].visible: true or false");
  // Members of another kind of anchor are none; those of no kind are.
  const auto dimension = [&](const std::string& anchor) {
    return with(good, R"("objects": [)",
                R"("dimensions": [{"id": 1, "kind": "distance", "anchors": [{"point": [1, 2, 3]}, )" +
                    anchor + R"(]}], "objects": [)");
  };
  EXPECT_TRUE(read_document(dimension(R"({"object": 4, "vertex": 3, "share": 0.5})")));
  expect_refused(dimension(R"({"object": 4, "vertex": "x", "part": 0.5})"), e_schema,
                 "dimensions[0].anchors[1]: the member \"part\" is unknown");
}

TEST(FormatErrors, ValuesThatEditsRefuseToo) {
  const std::string good = tent_text();
  expect_refused(with(good, "[3, 1], [5, 2]", "[3, -1]"), e_tension_negative, "objects[0].source.alpha[0]");
  expect_refused(with(good, "[3, 1], [5, 2]", "[3, 1001]"), e_tension_range, "objects[0].source.alpha[0]");
  expect_refused(with(good, "[3, 9, 2]", "[3, 9, 0]"), e_tension_range, "objects[0].source.beta[1]");
  expect_refused(with(good, "[3, 9, 2]", "[3, 9, -2]"), e_tension_negative, "objects[0].source.beta[1]");
  expect_refused(with(good, R"("weld_distance": 0.5)", R"("weld_distance": -0.5)"), e_mirror_invalid,
                 "objects[0].source.mirror");
  expect_refused(with(good, "[[0, 0, 1]]", "[[0, 0, 0]]"), e_pin_invalid, "objects[0].source.pin[0]");
  expect_refused(with(good, "[[0, 0, 1]]", "[]"), e_pin_invalid, "objects[0].source.pin[0]");
  expect_refused(with(good, "\"Tent\"", "\" \""), e_name_empty, "objects[0].name");
  expect_refused(with(good, "\"Tent\"", "\"a\\nb\""), e_name_invalid, "objects[0].name");
  expect_refused(with(good, "\"Tent\"", "\"" + std::string(300, 'x') + "\""), e_name_invalid,
                 "objects[0].name");
}

TEST(FormatErrors, PolygonsThatMakeNoPolyhedron) {
  const std::string good = tent_text();
  const std::string faces = "[[0, 3, 5, 9], [1, 5, 7, 9]]";
  expect_refused(with(good, faces, "[]"), e_no_faces, "objects[0].source");
  expect_refused(with(good, faces, "[[0, 3, 5]]"), e_face_too_small, "objects[0].source");
  expect_refused(with(good, faces, "[[0, 3, 5, 3]]"), e_face_repeated_vertex, "objects[0].source");
  const std::string flipped = with(good, faces, "[[0, 3, 5, 9], [6, 7, 5, 9]]");
  expect_refused(flipped, e_edge_nonmanifold_or_flipped, "objects[0].source");
  EXPECT_EQ(read_document(flipped).error().element, element_of(EdgeId{{5}, {9}}));
}

TEST(FormatErrors, Meshes) {
  const std::string good =
      R"({"format": "hariko", "version": 1, "objects": [{"id": 4, "name": "M", "source": {"kind": "mesh",
      "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "faces": [[0, 1, 2]]}}]})";
  ASSERT_TRUE(read_document(good));
  expect_refused(with(good, "[[0, 1, 2]]", "[]"), e_schema, "source.faces: the list is too short");
  expect_refused(with(good, "[0, 1, 2]", "[0, 1]"), e_schema, "source.faces[0]: the list is too short");
  expect_refused(with(good, "[0, 1, 2]", "[0, 1, 3]"), e_schema, "source.faces[0][2]: there are not so many");
  expect_refused(with(good, "[1, 0, 0]", "[1, 0]"), e_schema, "source.vertices[1]: a list of 3");
}

TEST(FormatErrors, Bombs) {
  for (const char* open : {"[", "{\"a\":"}) {
    std::string deep = R"({"format": "hariko", "version": 1, "objects": )";
    for (int i = 0; i < 1'000'000; ++i) deep += open;
    expect_refused(deep, e_limit, "nested too deeply at line 1");
  }
  std::string many = R"({"format": "hariko", "version": 1, "x": [)";
  for (std::size_t i = 0; i <= max_document_values; ++i) many += "0,";
  expect_refused(many, e_limit, "more values");
  many.resize(max_document_bytes + 1, ' ');
  expect_refused(many, e_limit, "larger");
  std::string objects = R"({"format": "hariko", "version": 1, "objects": [)";
  for (std::size_t i = 0; i <= Document::max_objects; ++i) objects += i ? ",0" : "0";
  expect_refused(objects + "]}", e_schema, "objects: the list is too long");
}

TEST(FormatErrors, ManySettingsAtOneVertexTakeLittleTime) {
  // A fan of 60,000 triangles: looking each edge up at the hub would take minutes.
  const int n = 60000;
  std::string vertices = "[0, 0, 0, 0]", faces, beta;
  for (int i = 1; i <= n; ++i) {
    const std::string id = std::to_string(i), next = std::to_string(i % n + 1);
    vertices += ",[" + id + ", 1, 0, 0]";
    faces += (i > 1 ? "," : "") + std::string("[") + id + ", 0, " + id + ", " + next + "]";
    beta += (i > 1 ? "," : "") + std::string("[0, ") + id + ", 2]";
  }
  const Result<Document> read = read_document(
      R"({"format": "hariko", "version": 1, "objects": [{"id": 1, "name": "Fan", "source": {"kind": "polyhedron", "vertices": [)" +
      vertices + R"(], "faces": [)" + faces + R"(], "beta": [)" + beta + "]}}]}");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(test::polyhedron_of(*read).shaping->beta.size(), static_cast<std::size_t>(n));
}

TEST(FormatErrors, DamagedFilesNeverCrash) {
  test::for_random(7, 3000, [](std::mt19937_64& rng) {
    static const std::string good = tent_text();
    std::string text = good;
    const int count = test::uniform_int(rng, 1, 4);
    for (int i = 0; i < count; ++i) {
      const std::size_t at = rng() % text.size();
      static constexpr std::string_view bytes = "[]{}\",:0123456789eE+-. \n\\untf\xff";
      switch (test::uniform_int(rng, 0, 3)) {
        case 0:
          text[at] = bytes[rng() % bytes.size()];
          break;
        case 1:
          text.erase(at, 1 + rng() % 10);
          break;
        case 2:
          text.insert(at, 1, bytes[rng() % bytes.size()]);
          break;
        default:
          text.resize(at + 1);
          break;
      }
      if (text.empty()) text = " ";
    }
    const Result<Document> read = read_document(text);
    if (read) {  // an accepted text is a good document
      const Result<Document> again = read_document(write_document(*read));
      ASSERT_TRUE(again) << text;
      ASSERT_TRUE(*again == *read) << text;
    } else {
      ASSERT_FALSE(read.error().text.empty());
    }
  });
}

}  // namespace
}  // namespace hariko

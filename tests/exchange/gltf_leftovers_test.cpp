#include "core/exchange/gltf/read_gltf.hpp"
#include "tests/exchange/gltf_text.hpp"
#include "tests/exchange/mesh_text.hpp"

// Contents of glTF files that the default scene does not show, and data that are written in unusual ways.

namespace hariko::test {
namespace {

std::string leftovers_code(const Result<ImportedScene>& result) {
  return result.ok() ? "ok" : std::string(result.error().code.name);
}

TEST(GltfLeftovers, ObjectsOfOtherScenesAreCounted) {
  GltfLayout layout = gltf_tetrahedron();
  layout.nodes = R"([{"mesh": 0}, {"children": [0, 2, 3]}, {"mesh": 0}, {"mesh": 0}, {}])";
  layout.scene = R"("scenes": [{"nodes": [0]}, {"nodes": [1, 4, 99]}, 7, {"nodes": [3]}],)";
  const auto read = test::must(read_gltf(layout.text()));
  EXPECT_EQ(read->parts.size(), 1U);
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_EQ(read->warnings[0].text, "2 objects of other scenes of the file were left out.");
}

TEST(GltfLeftovers, AnotherSceneStandsInForAnEmptyDefaultScene) {
  struct Case {
    const char* scene;
    std::size_t parts;
    std::vector<std::string> warnings;
  };
  GltfLayout layout = gltf_tetrahedron();
  layout.nodes = R"([{"mesh": 0}, {}, {"children": [3, 4]}, {"mesh": 0}, {"mesh": 0}])";
  const std::string instead = "No object belongs to the default scene of the file; scene ";
  for (const Case& c :
       {Case{R"("scene": 1, "scenes": [{"nodes": [0]}, {"name": "empty"}],)",
             1,
             {instead + "1 was opened instead.",
              "2 objects that belong to no scene of the file were left out."}},
        Case{R"("scenes": [{"nodes": [1]}, {}, {"name": "Parts", "nodes": [2]}, {"nodes": [0]}],)",
             2,
             {instead + "\"Parts\" was opened instead.",
              "An object of another scene of the file was left out."}},
        Case{R"("scene": 0, "scenes": [{}, 7, {"nodes": [1]}],)",
             3,
             {"No object belongs to a scene of the file; all objects were opened."}},
        Case{R"("scene": 0, "scenes": [{"nodes": [2, 1]}],)",
             2,
             {"1 object that belongs to no scene of the file was left out."}}}) {
    layout.scene = c.scene;
    const auto read = read_gltf(layout.text());
    ASSERT_TRUE(read.ok()) << c.scene << to_string(read.error());
    EXPECT_EQ(read->parts.size(), c.parts) << c.scene;
    std::vector<std::string> texts;
    for (const Message& warning : read->warnings) texts.push_back(warning.text);
    EXPECT_EQ(texts, c.warnings) << c.scene;
  }
  layout.nodes = "[{}, {}]";
  layout.scene = R"("scene": 0, "scenes": [{"nodes": [0]}, {"nodes": [1]}],)";
  EXPECT_EQ(leftovers_code(read_gltf(layout.text())), "E_EMPTY");
}

TEST(GltfLeftovers, MeshesOfAFileWithoutNodesAreTaken) {
  GltfLayout layout = gltf_tetrahedron();
  layout.scene.clear();
  layout.nodes = "[]";
  const auto read = test::must(read_gltf(layout.text()));
  ASSERT_EQ(read->parts.size(), 1U);
  EXPECT_EQ(read->parts[0].name, "mesh");
  EXPECT_NEAR(test::volume_of(read->parts[0].mesh), 1e9 / 6, 1);
}

TEST(GltfLeftovers, AccessorsWithoutRowsAreZeros) {
  GltfLayout layout = gltf_tetrahedron();
  // A shape key of zeros changes nothing; positions of zeros are one place.
  const std::string keyed = with(
      with(with(layout.text(), "\"indices\": 1", "\"indices\": 1, \"targets\": [{\"POSITION\": 2}]"),
           "{\"name\": \"mesh\"", "{\"weights\": [0.5], \"name\": \"mesh\""),
      "\"accessors\": [{", "\"accessors\": [{\"type\": \"VEC3\", \"count\": 4, \"componentType\": 5126}, {");
  const std::string moved = with(
      with(with(keyed, "{\"POSITION\": 2}", "{\"POSITION\": 9}"), "{\"POSITION\": 0}", "{\"POSITION\": 1}"),
      "\"indices\": 1", "\"indices\": 2");
  const auto read = test::must(read_gltf(with(moved, "{\"POSITION\": 9}", "{\"POSITION\": 0}")));
  EXPECT_NEAR(test::volume_of(read->parts.at(0).mesh), 1e9 / 6, 1);
  EXPECT_EQ(leftovers_code(read_gltf(with(layout.text(), "{\"bufferView\": 0, ", "{"))), "E_EMPTY");
  EXPECT_EQ(leftovers_code(read_gltf(with(with(layout.text(), "{\"bufferView\": 0, ", "{"), "\"count\": 4",
                                          "\"count\": 18446744073709551615"))),
            "E_LIMIT");
}

TEST(GltfLeftovers, DataInsideMayBeEscaped) {
  const GltfLayout layout = gltf_tetrahedron();
  std::string data;
  for (const char c : test::base64(layout.binary()))
    data += c == '/' ? "%2F" : c == '+' ? "%2B" : c == '=' ? "%3D" : std::string(1, c);
  ASSERT_NE(data.find('%'), std::string::npos);
  const auto read = read_gltf(layout.json("data:application/octet-stream;base64," + data));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->parts.at(0).mesh.face_count(), 4U);
}

}  // namespace
}  // namespace hariko::test

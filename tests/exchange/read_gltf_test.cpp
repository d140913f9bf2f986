#include "core/exchange/gltf/read_gltf.hpp"

#include "core/exchange/mesh_file.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "tests/exchange/fixture_files.hpp"
#include "tests/exchange/gltf_text.hpp"
#include "tests/exchange/mesh_text.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {
namespace {

/// The document's vector in millimetres for one of the file.
Vector3 from_file(const Vector3& v) {
  return 1000 * Vector3(v.x(), -v.z(), v.y());
}

std::string gltf_code_of(const Result<ImportedScene>& result) {
  if (result.ok()) return "ok";
  EXPECT_FALSE(result.error().text.empty());
  EXPECT_FALSE(result.error().remedy.empty());
  return std::string(result.error().code.name);
}

/// Corners of triangles, one after the other.
std::vector<Vector3> corner_points(const PolygonMesh& mesh) {
  std::vector<Vector3> out;
  for (const Index v : mesh.face_vertices) out.push_back(mesh.positions[v]);
  return out;
}

TEST(ReadGltf, OurOwnFilesComeBackWhereverTheyAreAndHoweverLarge) {
  for_random(71, 12, [](std::mt19937_64& rng) {
    const double size = std::pow(10, test::uniform(rng, -3, 6));
    const auto form = test::chance(rng, 0.5) ? GltfForm::binary : GltfForm::text;
    std::array<TriangleMesh, 2> meshes;
    for (TriangleMesh& mesh : meshes) {
      PolygonMesh polygons = test::torus(test::uniform_int(rng, 3, 9), 5);
      for (Vector3& p : polygons.positions) p *= size;
      mesh = test::faceted(polygons, test::random_vector(rng, 1e6 * size));
    }
    const std::vector<NamedTriangles> named{{"張り子", &meshes[0]}, {"b", &meshes[1]}};
    const auto read = test::must(read_gltf(*write_gltf(named, 0.001, form)));
    EXPECT_EQ(read->metres_per_unit, 0.001);
    EXPECT_TRUE(read->warnings.empty());
    ASSERT_EQ(read->parts.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
      const PolygonMesh& mesh = read->parts[k].mesh;
      EXPECT_EQ(read->parts[k].name, named[k].name);
      // Vertices with several normals are one again: the surface is closed.
      ASSERT_EQ(mesh.positions.size(), meshes[k].positions.size());
      ASSERT_EQ(mesh.face_count(), meshes[k].triangles.size());
      const auto built = Polyhedron::build(mesh);
      ASSERT_TRUE(built.ok()) << to_string(built.error());
      for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t c = 0; c < 3; ++c) {
          const Vector3 p = meshes[k].origin + meshes[k].positions[meshes[k].triangles[f][c]];
          EXPECT_LT((mesh.positions[mesh.face(f)[c]] - p).norm(), 1e-6 * size + 1e-15 * p.norm());
        }
    }
  });
}

TEST(ReadGltf, LayoutsOfOtherProgramsAreTheSame) {
  for_random(72, 60, [](std::mt19937_64& rng) {
    GltfLayout layout;
    const int count = test::uniform_int(rng, 3, 80);
    layout.quantized = test::chance(rng, 0.3);
    for (int v = 0; v < count; ++v) {
      Vector3 p = test::random_vector(rng);
      for (double& x : p) x = layout.quantized ? std::lround(x * 32767) / 32767.0 : double(float(x));
      layout.positions.push_back(p);
    }
    const bool indexed = test::chance(rng, 0.7);
    std::vector<Index> order;
    for (int k = 0; k + 2 < (indexed ? 90 : count); ++k) {
      const auto first = Index(indexed ? test::uniform_int(rng, 0, count - 3) : k);
      if (!indexed && k % 3 != 0) continue;
      for (Index c = 0; c < 3; ++c) order.push_back(first + c);
    }
    if (indexed) layout.corners = order;
    constexpr std::array components{5121, 5123, 5125};
    layout.index_component = components[std::size_t(test::uniform_int(rng, 0, 2))];
    layout.lead = std::size_t(4 * test::uniform_int(rng, 0, 3));
    layout.gap = std::size_t(2 * test::uniform_int(rng, 0, 10));
    const auto read = test::must(read_gltf(test::chance(rng, 0.5) ? layout.text() : layout.binary_file()));
    ASSERT_EQ(read->parts.size(), 1U);
    EXPECT_EQ(read->parts[0].name, "part");
    const auto found = corner_points(read->parts[0].mesh);
    ASSERT_EQ(found.size(), order.size());
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_LT((found[k] - from_file(layout.positions[order[k]])).norm(), 1e-9);
  });
}

TEST(ReadGltf, StripsAndFansAreTriangles) {
  GltfLayout layout;
  // Two rows of points that run along x: all triangles look along +z of the file.
  for (int k = 0; k < 9; ++k) layout.positions.emplace_back(k / 2, k % 2 == 0 ? 1 : 0, 0);
  layout.mode = 5;
  const auto area = [&](const Result<ImportedScene>& read) {
    Vector3 sum = Vector3::Zero();
    const auto found = corner_points(read->parts[0].mesh);
    for (std::size_t k = 0; k + 2 < found.size(); k += 3) {
      const Vector3 one = (found[k + 1] - found[k]).cross(found[k + 2] - found[k]) / 2;
      EXPECT_LT(one.x() * one.x() + one.z() * one.z(), 1e-12);
      EXPECT_LT(one.y(), 0);  // the file's +z is the document's -y
      sum += one;
    }
    return sum.norm() / 1e6;
  };
  auto read = test::must(read_gltf(layout.text()));
  EXPECT_EQ(read->parts[0].mesh.face_count(), 7U);
  EXPECT_NEAR(area(read), 3.5, 1e-6);
  // A strip with a repeated corner, as programs join strips: no warning.
  layout.corners = {0, 1, 2, 2, 2, 3, 4};
  read = test::must(read_gltf(layout.text()));
  EXPECT_TRUE(read->warnings.empty());
  EXPECT_EQ(read->parts[0].mesh.face_count(), 2U);

  layout.mode = 6;
  layout.corners.clear();
  layout.positions = {{0, 0, 0}};
  for (int k = 0; k <= 6; ++k) layout.positions.emplace_back(std::cos(k * 0.5), std::sin(k * 0.5), 0);
  read = test::must(read_gltf(layout.text()));
  EXPECT_EQ(read->parts[0].mesh.face_count(), 6U);
  EXPECT_NEAR(area(read), 3 * std::sin(0.5), 1e-6);
}

TEST(ReadGltf, NodesPlaceMeshesAndMirrorsKeepTheirOutside) {
  GltfLayout layout = gltf_tetrahedron();
  layout.scene = R"("scene": 1, "scenes": [{"nodes": [3]}, {"nodes": [0]}],)";
  // Node 1 turns by 90 degrees about z, 2 mirrors and stretches, 4 is a matrix with a shear.
  layout.nodes = R"([{"children": [1, 2, 4], "translation": [10, 0, 0], "scale": [2, 2, 2]},
    {"name": "turned", "mesh": 0, "rotation": [0, 0, 0.70710678118654752, 0.70710678118654752]},
    {"mesh": 0, "scale": [-1, 1, 3], "translation": [0, 1, 0]},
    {"name": "of another scene", "mesh": 0},
    {"name": "sheared", "mesh": 0, "matrix": [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1]}])";
  const auto read = test::must(read_gltf(layout.text()));
  ASSERT_EQ(read->parts.size(), 3U);
  const auto holds = [&](std::size_t part, const Vector3& corner) {
    const auto& found = read->parts[part].mesh.positions;
    return std::any_of(found.begin(), found.end(),
                       [&](const Vector3& p) { return (p - from_file(corner)).norm() < 1e-9; });
  };
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_EQ(read->warnings[0].code, w_left_out);
  EXPECT_EQ(read->warnings[0].text, "An object of another scene of the file was left out.");
  EXPECT_EQ(read->parts[0].name, "turned");
  EXPECT_EQ(read->parts[1].name, "mesh");
  EXPECT_EQ(read->parts[2].name, "sheared");
  EXPECT_TRUE(holds(0, {10, 2, 0}) && holds(0, {8, 0, 0}) && holds(0, {10, 0, 2}));
  EXPECT_TRUE(holds(1, {8, 2, 0}) && holds(1, {10, 4, 0}) && holds(1, {10, 2, 6}));
  EXPECT_TRUE(holds(2, {11, 2, 10}) && holds(2, {12, 0, 10}));
  const double one = 8 * 1e9 / 6;  // cubic millimetres, under the scale of 2
  EXPECT_NEAR(test::volume_of(read->parts[0].mesh), one, 1e-6 * one);
  EXPECT_NEAR(test::volume_of(read->parts[1].mesh), 3 * one, 1e-6 * one);
  EXPECT_NEAR(test::volume_of(read->parts[2].mesh), one, 1e-6 * one);
  for (const auto& part : read->parts) EXPECT_TRUE(Polyhedron::build(part.mesh).ok());
}

TEST(ReadGltf, WhatHasNoTrianglesIsLeftOutWithAWarning) {
  GltfLayout layout = gltf_tetrahedron();
  layout.nodes = R"([{"children": [1, 2]}, {"mesh": 0}, {"mesh": 0, "scale": [1, 0, 1]}])";
  layout.extra = R"("animations": [{}], )";
  auto read = test::must(read_gltf(layout.text()));
  EXPECT_EQ(read->parts.size(), 1U);
  ASSERT_EQ(read->warnings.size(), 2U);
  EXPECT_EQ(read->warnings[0].code, w_left_out);
  EXPECT_EQ(read->warnings[1].code, w_flat_part);
  layout = gltf_tetrahedron();
  layout.mode = 1;
  EXPECT_EQ(gltf_code_of(read_gltf(layout.text())), "E_EMPTY");
  layout.mode = 4;
  layout.corners = {0, 0, 1, 0, 1, 2};
  read = test::must(read_gltf(layout.text()));
  EXPECT_EQ(read->parts[0].mesh.face_count(), 1U);
  EXPECT_EQ(read->warnings.at(0).code, w_degenerate_triangles);
}

TEST(ReadGltf, ScenesAreNotNeededAndNamesFallBack) {
  GltfLayout layout = gltf_tetrahedron();
  layout.scene.clear();
  layout.nodes = R"([{"children": [1]}, {"mesh": 0}, {"mesh": 0, "name": "\u5f35\u308a"}])";
  const auto read = test::must(read_gltf(layout.text()));
  ASSERT_EQ(read->parts.size(), 2U);
  EXPECT_EQ(read->parts[0].name, "mesh");
  EXPECT_EQ(read->parts[1].name, "張り");
}

TEST(ReadGltf, EachRefusalHasItsReason) {
  const std::string good = gltf_tetrahedron().text();
  ASSERT_EQ(gltf_code_of(read_gltf(good)), "ok");
  struct Case {
    const char *old, *now, *code;
  };
  for (const Case& c : {
           Case{"\"2.0\"", "\"1.0\"", "E_FORMAT_UNKNOWN"},
           Case{"{\"version\": \"2.0\"}", "{}", "E_FORMAT_UNKNOWN"},
           Case{"{\"version\": \"2.0\"}", "{\"version\": \"2.1\", \"minVersion\": \"2.1\"}",
                "E_FORMAT_UNKNOWN"},
           Case{"\"scene\": 0,", "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"],",
                "E_FORMAT_UNKNOWN"},
           Case{"\"scene\": 0,", "\"extensionsRequired\": [7],", "E_FORMAT_UNKNOWN"},
           Case{"\"scene\": 0,", "\"extensionsRequired\": [\"KHR_materials_unlit\"],", "ok"},
           Case{"\"scene\": 0,", "\"extensionsRequired\": [\"KHR_techniques_webgl\"],", "ok"},
           Case{"\"byteOffset\": 0}", "\"byteOffset\": 0, \"sparse\": {}}", "E_PARSE"},
           Case{"\"mesh\": 0", "\"mesh\": 0, \"skin\": 0", "E_PARSE"},
           Case{"\"name\": \"part\"", "\"extensions\": {\"EXT_mesh_gpu_instancing\": {}}", "E_PARSE"},
           Case{"\"name\": \"part\"", "\"extensions\": {\"EXT_mesh_gpu_instancing\": {\"attributes\": {}}}",
                "E_PARSE"},
           Case{"\"name\": \"part\"",
                "\"extensions\": {\"EXT_mesh_gpu_instancing\": {\"attributes\": {\"SCALE\": 1}}}", "E_PARSE"},
           Case{"\"scene\": 0,", "\"scene\": 5,", "E_PARSE"},
           Case{"\"scene\": 0,", "\"scene\": -1,", "E_PARSE"},
           Case{"\"nodes\": [0]", "\"nodes\": [1]", "E_PARSE"},
           Case{"\"nodes\": [0]", "\"nodes\": [0, 0]", "E_PARSE"},
           Case{"\"nodes\": [0]", "\"nodes\": 0", "E_PARSE"},
           Case{"\"nodes\": [0]", "\"nodes\": []", "ok"},  // all nodes stand in for an empty scene
           Case{"\"name\": \"part\"", "\"children\": [0]", "E_PARSE"},
           Case{"\"name\": \"part\"", "\"rotation\": [0, 0, 0, 0]", "E_PARSE"},
           Case{"\"name\": \"part\"", "\"rotation\": [0, 0, 1]", "E_PARSE"},
           Case{"\"name\": \"part\"", "\"scale\": [1e307, 1e307, 1e307]", "E_PARSE"},
           Case{"\"name\": \"part\"", "\"scale\": [1e999, 1, 1]", "E_PARSE"},
           Case{"\"name\": \"part\"", "\"scale\": [0, 0, 0]", "E_EMPTY"},
           Case{"\"mesh\": 0", "\"mesh\": 1", "E_PARSE"},
           Case{"\"mesh\": 0, ", "", "E_EMPTY"},
           Case{"\"indices\": 1", "\"indices\": 2", "E_PARSE"},
           Case{"\"indices\": 1", "\"indices\": 1, \"mode\": 7", "E_PARSE"},
           Case{"\"indices\": 1", "\"indices\": 0", "E_PARSE"},
           Case{"\"POSITION\": 0", "\"NORMAL\": 0", "E_EMPTY"},
           Case{"\"count\": 4", "\"count\": 5", "E_TRUNCATED"},
           Case{"\"count\": 4", "\"count\": 18446744073709551615", "E_TRUNCATED"},
           Case{"\"count\": 4", "\"count\": 3", "E_INDEX_RANGE"},
           Case{"\"count\": 4", "\"count\": -4", "E_PARSE"},
           Case{"\"count\": 12", "\"count\": 13", "E_TRUNCATED"},
           Case{"\"componentType\": 5126", "\"componentType\": 5124", "E_PARSE"},
           Case{"\"componentType\": 5126", "\"componentType\": 5125", "E_PARSE"},
           Case{"\"componentType\": 5125", "\"componentType\": 5126", "E_PARSE"},
           Case{"\"componentType\": 5125", "\"componentType\": 5122", "E_PARSE"},
           Case{"\"VEC3\"", "\"VEC4\"", "E_PARSE"},
           Case{"\"byteOffset\": 0}", "\"byteOffset\": 18446744073709551615}", "E_TRUNCATED"},
           Case{"\"buffer\": 0", "\"buffer\": 1", "E_PARSE"},
           Case{"\"byteLength\": 48}", "\"byteLength\": 48, \"byteStride\": 4}", "E_PARSE"},
           Case{"\"byteLength\": 48}", "\"byteLength\": 48, \"byteStride\": 99999999999}", "E_PARSE"},
           Case{"\"byteLength\": 48}", "\"byteLength\": 18446744073709551615}", "E_TRUNCATED"},
           Case{"\"byteLength\": 48}", "\"byteLength\": 48, \"byteOffset\": 60}", "E_TRUNCATED"},
           Case{"\"byteLength\": 96", "\"byteLength\": 97", "E_TRUNCATED"},
           Case{"base64,", "base64,!", "E_PARSE"},
           Case{"data:application/octet-stream;base64,", "data:,", "E_PARSE"},
           Case{"data:application/octet-stream;base64,", "/etc/passwd#", "E_FILE_OPEN"},
           Case{"data:application/octet-stream;base64,", "https://a.example/", "E_FILE_OPEN"},
       }) {
    const auto read = read_gltf(with(good, c.old, c.now));
    EXPECT_EQ(gltf_code_of(read), c.code) << c.old << " -> " << c.now;
  }
  EXPECT_EQ(gltf_code_of(read_gltf("")), "E_EMPTY");
  EXPECT_EQ(gltf_code_of(read_gltf("[]")), "E_PARSE");
  EXPECT_EQ(gltf_code_of(read_gltf("no")), "E_PARSE");
  EXPECT_EQ(gltf_code_of(read_gltf(std::string(1'000'000, '['))), "E_PARSE");
  EXPECT_EQ(gltf_code_of(read_gltf("{\"a\": " + std::string(1000, '[') + std::string(1000, ']') + "}")),
            "E_LIMIT");
}

TEST(ReadGltf, FilesThatAreCutOffOrChangedAreRefusedOrSound) {
  const std::string whole = gltf_tetrahedron().binary_file();
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(gltf_code_of(read_gltf(whole.substr(0, size))), "ok") << size;
  for_random(73, 400, [&](std::mt19937_64& rng) {
    std::string changed = whole;
    for (int k = test::uniform_int(rng, 1, 4); k > 0; --k)
      changed[std::size_t(rng() % changed.size())] = char(rng());
    const auto read = read_gltf(changed);
    if (!read.ok()) return;
    for (const auto& part : read->parts) test::expect_sound(part.mesh);
  });
}

/// Nodes that place mesh 0, all in the scene.
GltfLayout many_times(GltfLayout layout, std::size_t count) {
  layout.nodes = "[{\"children\": [";
  for (std::size_t n = 1; n <= count; ++n) layout.nodes += (n > 1 ? "," : "") + std::to_string(n);
  layout.nodes += "]}";
  for (std::size_t n = 1; n <= count; ++n) layout.nodes += ",{\"mesh\":0}";
  layout.nodes += "]";
  return layout;
}

TEST(ReadGltf, ManyCopiesAndDeepNodesStayInBounds) {
  EXPECT_EQ(read_gltf(many_times(gltf_tetrahedron(), 500).text())->parts.size(), 500U);
  const auto joined = read_gltf(many_times(gltf_tetrahedron(), ImportedScene::max_parts + 1).text());
  ASSERT_EQ(joined->parts.size(), 1U);
  EXPECT_EQ(joined->parts[0].mesh.face_count(), 4 * (ImportedScene::max_parts + 1));
  EXPECT_NEAR(test::volume_of(joined->parts[0].mesh), 1e9 / 6 * (ImportedScene::max_parts + 1), 1e6);
  EXPECT_TRUE(joined->warnings.at(0).text.starts_with("10001 objects")) << joined->warnings[0].text;
  ReadLimits limits{.vertices = 1000};
  EXPECT_EQ(gltf_code_of(read_gltf(many_times(gltf_tetrahedron(), 251).text(), limits)), "E_LIMIT");
  // Copies are 20 million vertices and corners at most, beside what is in proportion to the file.
  GltfLayout large;
  for (int v = 0; v < 20'000; ++v) large.positions.emplace_back(v, v % 2, v % 3 == 0);
  for (Index v = 0; v + 2 < 20'000; ++v) large.corners.insert(large.corners.end(), {v, v + 1, v + 2});
  EXPECT_EQ(gltf_code_of(read_gltf(many_times(large, 400).binary_file())), "E_LIMIT");

  GltfLayout chain = gltf_tetrahedron();
  chain.nodes = "[";
  for (int n = 0; n < 20'000; ++n) chain.nodes += "{\"children\":[" + std::to_string(n + 1) + "]},";
  chain.nodes += "{\"mesh\":0}]";
  EXPECT_EQ(gltf_code_of(read_gltf(chain.text())), "ok");
  chain.nodes.replace(chain.nodes.size() - 11, 11, "{\"children\":[19999]}]");
  EXPECT_EQ(gltf_code_of(read_gltf(chain.text())), "E_PARSE");
}

TEST(ReadGltf, BuffersBesideAreReadFromTheFolder) {
  const GltfLayout layout = gltf_tetrahedron();
  const test::TemporaryFolder folder;
  test::spill(folder.path() / "a b.bin", layout.binary());
  std::filesystem::create_directory(folder.path() / "in");
  test::spill(folder.path() / "in" / "c.bin", layout.binary());
  const auto read = [&](const std::string& uri) {
    test::spill(folder.path() / "in" / "a.gltf", layout.json(uri));
    test::spill(folder.path() / "a.gltf", layout.json(uri));
    return read_scene_file(folder.path() / "a.gltf");
  };
  test::spill(folder.path() / "10%.bin", layout.binary());
  test::spill(folder.path() / "c%41d.bin", layout.binary());
  for (const char* uri : {"a%20b.bin", "a b.bin", "./in/../a%20b.bin", "in/c.bin", "10%.bin", "c%41d.bin",
                          "in\\\\c.bin", ".\\\\in%5Cc.bin"}) {
    const auto scene = test::must(read(uri));
    EXPECT_EQ(scene->parts[0].mesh.face_count(), 4U);
  }
  for (const char* uri :
       {"none.bin", "in", ".", "%2e%2e/a%20b.bin", "file:a%20b.bin", "a%2", "%00", "..\\\\a b.bin"}) {
    const auto scene = read(uri);
    EXPECT_EQ(gltf_code_of(scene), "E_FILE_OPEN") << uri;
    EXPECT_NE(scene.error().text.find("a.gltf"), std::string::npos);
  }
  EXPECT_EQ(gltf_code_of(read("../a%20b.bin")), "E_FILE_OPEN");
  EXPECT_EQ(gltf_code_of(read_scene_file(folder.path() / "in" / "a.gltf")), "E_FILE_OPEN");
  const auto size = std::filesystem::file_size(folder.path() / "a.gltf");
  EXPECT_EQ(gltf_code_of(read("a%20b.bin")), "ok");
  EXPECT_EQ(gltf_code_of(read_scene_file(folder.path() / "a.gltf", {}, size + 50)), "E_LIMIT");
  EXPECT_EQ(gltf_code_of(read_gltf(layout.json("a%20b.bin"))), "E_FILE_OPEN");
}

TEST(ReadGltf, JointsPlaceAMeshWithASkinAndItsNodeDoesNot) {
  const auto read = test::must(read_scene_file(test::case_file("gltf_skin_below_armature.glb")));
  EXPECT_TRUE(read->warnings.empty());
  ASSERT_EQ(read->parts.size(), 1U);
  const auto box = test::box_of(read->parts[0].mesh);
  EXPECT_NEAR((box.min() - Vector3(0, 0, 0)).norm(), 0, 1e-3);
  EXPECT_NEAR((box.max() - Vector3(1000, 1000, 1000)).norm(), 0, 1e-3);
  EXPECT_NEAR(test::volume_of(read->parts[0].mesh), 1e9, 1e3);
}

TEST(ReadGltf, JointsBendByTheirWeights) {
  // A triangle whose three corners hang on joints in three places, the last on two of them, half and half.
  std::string binary;
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F})
    test::put(binary, std::bit_cast<std::uint32_t>(x), 4);
  for (const std::uint32_t joint : {0U, 0U, 0U, 0U, 1U, 0U, 0U, 0U, 0U, 1U, 0U, 0U})
    test::put(binary, joint, 1);
  for (const std::uint32_t weight : {255U, 0U, 0U, 0U, 255U, 0U, 0U, 0U, 100U, 100U, 0U, 0U})
    test::put(binary, weight, 1);
  const std::string json = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
    "nodes": [{"mesh": 0, "skin": 0, "translation": [50, 0, 0]}, {"translation": [0, 0, 2]},
              {"scale": [-1, -1, -1]}],
    "skins": [{"joints": [1, 2]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2}}]}],
    "accessors": [{"bufferView": 0, "type": "VEC3", "count": 3, "componentType": 5126},
                  {"bufferView": 1, "type": "VEC4", "count": 3, "componentType": 5121},
                  {"bufferView": 2, "type": "VEC4", "count": 3, "componentType": 5121, "normalized": true}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 12},
                    {"buffer": 0, "byteOffset": 48, "byteLength": 12}], "buffers": [{"byteLength": 60}]})";
  const auto read = test::must(read_gltf(test::glb(json, binary)));
  const auto points = corner_points(read->parts.at(0).mesh);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_NEAR((points[0] - from_file({0, 0, 2})).norm(), 0, 1e-9);
  EXPECT_NEAR((points[1] - from_file({-1, 0, 0})).norm(), 0, 1e-9);
  EXPECT_NEAR((points[2] - from_file({0, 0, 1})).norm(), 0, 1e-9) << "weights are shares of their sum";
  for (const auto& [old, now] : {std::pair{"\"joints\": [1, 2]", "\"joints\": [1]"},
                                 {"\"joints\": [1, 2]", "\"joints\": [1, 7]"},
                                 {"\"nodes\": [0, 1, 2]", "\"nodes\": [0, 1]"},
                                 {"\"JOINTS_0\": 1, ", ""},
                                 {", \"WEIGHTS_0\": 2", ""}})
    EXPECT_EQ(gltf_code_of(read_gltf(test::glb(with(json, old, now), binary))), "E_PARSE") << now;
}

TEST(ReadGltf, InstancesAreObjectsInTheirPlaces) {
  const auto read = test::must(read_scene_file(test::case_file("gltf_gpu_instancing.glb")));
  EXPECT_TRUE(read->warnings.empty());
  ASSERT_EQ(read->parts.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto box = test::box_of(read->parts[k].mesh);
    EXPECT_NEAR((box.min() - Vector3(2000 * double(k), 0, 0)).norm(), 0, 1e-3);
    EXPECT_NEAR((box.max() - Vector3(2000 * double(k) + 1000, 1000, 1000)).norm(), 0, 1e-3);
    EXPECT_EQ(read->parts[k].name, "cube");
  }
}

TEST(ReadGltf, SparseAccessorsAreFilledIn) {
  const auto read = test::must(read_scene_file(test::case_file("gltf_sparse_positions.glb")));
  const auto box = test::box_of(read->parts.at(0).mesh);
  EXPECT_NEAR((box.sizes() - Vector3(1000, 1000, 2000)).norm(), 0, 1e-3);
  EXPECT_NEAR(test::volume_of(read->parts[0].mesh), 2e9, 1e3);
  // Without a base all rows are zero but those that are given.
  GltfLayout layout = gltf_tetrahedron();
  const std::string whole = layout.text();
  const std::string sparse =
      with(whole, R"({"bufferView": 0, "type": "VEC3", "count": 4, "componentType": 5126, "byteOffset": 0})",
           R"({"type": "VEC3", "count": 4, "componentType": 5126, "sparse": {"count": 3, )"
           R"("indices": {"bufferView": 1, "byteOffset": 16, "componentType": 5125}, )"
           R"("values": {"bufferView": 0, "byteOffset": 12}}})");
  const auto filled = read_gltf(sparse);  // corners 4 to 6 of the file are 1, 3, 0
  ASSERT_TRUE(filled.ok()) << to_string(filled.error());
  const auto expect = [&](std::size_t corner, const Vector3& at) {
    EXPECT_EQ(corner_points(filled->parts[0].mesh)[corner], from_file(at)) << corner;
  };
  // Rows 1, 3, 0 are now X, Y and Z; row 2 is zero.
  expect(0, Vector3::UnitZ());
  expect(1, Vector3::Zero());
  expect(2, Vector3::UnitX());
  EXPECT_EQ(gltf_code_of(read_gltf(with(sparse, "\"count\": 3,", "\"count\": 30,"))), "E_TRUNCATED");
  EXPECT_EQ(gltf_code_of(read_gltf(with(sparse, "\"count\": 4,", "\"count\": 3,"))), "E_INDEX_RANGE");
}

TEST(ReadGltf, ACompressionWithoutPlainTrianglesIsNamed) {
  GltfLayout layout = gltf_tetrahedron();
  layout.extra = R"("extensionsUsed": ["KHR_draco_mesh_compression"],)";
  const std::string beside =
      with(layout.text(), "\"indices\": 1",
           R"("indices": 1, "extensions": {"KHR_draco_mesh_compression": {"bufferView": 0}})");
  EXPECT_EQ(gltf_code_of(read_gltf(beside)), "ok") << "plain triangles are there, too";
  const auto alone = read_gltf(with(beside, R"("bufferView": 0, "type": "VEC3")", R"("type": "VEC3")"));
  ASSERT_EQ(gltf_code_of(alone), "E_FORMAT_UNKNOWN");
  EXPECT_NE(alone.error().text.find("KHR_draco_mesh_compression"), std::string::npos) << alone.error().text;
}

TEST(ReadGltf, ShapeKeysCountWithTheirWeightsAtRest) {
  GltfLayout layout = gltf_tetrahedron();
  const std::string keyed =
      with(with(layout.text(), "\"indices\": 1", "\"indices\": 1, \"targets\": [{\"POSITION\": 0}]"),
           "{\"name\": \"mesh\"", "{\"weights\": [0.5], \"name\": \"mesh\"");
  const auto read = test::must(read_gltf(keyed));
  EXPECT_NEAR(test::volume_of(read->parts.at(0).mesh), 1e9 / 6 * 1.5 * 1.5 * 1.5, 1);
  const auto own = test::must(read_gltf(with(keyed, "\"mesh\": 0", "\"mesh\": 0, \"weights\": [1]")));
  EXPECT_NEAR(test::volume_of(own->parts.at(0).mesh), 1e9 / 6 * 8, 1) << "the node's own";
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_EQ(read->warnings[0].code, w_left_out);
}

TEST(ReadGltf, NamesWithPercentSignsAreFound) {
  const auto read = test::must(read_scene_file(test::case_file("percent in name/example 10%.gltf")));
  EXPECT_EQ(read->parts.at(0).mesh.face_count(), 12U);
}

TEST(ReadGltf, ExtensionsThatAreNotReadAreTold) {
  GltfLayout layout = gltf_tetrahedron();
  layout.extra =
      R"("extensionsUsed": ["KHR_materials_unlit", "KHR_draco_mesh_compression", "KHR_node_visibility",
      "ACME_a_name_that_is_so_long_that_messages_would_like_to_cut_it_off_before_what_matters"],)";
  const auto read = test::must(read_gltf(layout.text()));
  ASSERT_EQ(read->warnings.size(), 1U);
  const std::string& text = read->warnings[0].text;
  EXPECT_EQ(read->warnings[0].code, w_left_out);
  EXPECT_NE(text.find("KHR_node_visibility"), std::string::npos) << text;
  EXPECT_NE(text.find("before_what_matters\""), std::string::npos) << text;
  EXPECT_EQ(text.find("unlit"), std::string::npos) << text;
  EXPECT_EQ(text.find("draco"), std::string::npos) << "plain triangles are there, too";
}

}  // namespace
}  // namespace hariko::test

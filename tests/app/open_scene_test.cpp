// Files with several objects, as the window and the command line open them.

#include <array>
#include <cmath>

#include "app/files/model_facets.hpp"
#include "app/files/open_file.hpp"
#include "core/base/files/file_io.hpp"
#include "core/exchange/mesh_file.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

/// Two triangles that share an edge and are turned against each other: no polyhedron.
PolygonMesh twisted() {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.add_face({0, 1, 2});
  mesh.add_face({1, 2, 3});
  return mesh;
}

double size_of(const Document& document, std::size_t object) {
  const Polyhedron& polyhedron = document.objects[object]->polyhedron()->polyhedron;
  double size = 0;
  for (const Vector3& p : polyhedron.positions())
    for (const Vector3& q : polyhedron.positions()) size = std::max(size, (p - q).norm());
  return millimetres_per(document.unit) * size;
}

TEST(OpenScene, ObjectsKeepNamesAndSizes) {
  const test::TemporaryFolder folder;
  const PolygonMesh first = test::octahedron(), second = test::torus(5, 4);
  const std::array<NamedPolygons, 2> named{{{"one", &first}, {"two", &second}}};
  for (const Unit unit : {Unit::millimetre, Unit::centimetre, Unit::metre, Unit::inch}) {
    for (const char* name : {"a.glb", "a.gltf", "a.3mf"}) {
      SCOPED_TRACE(name);
      const auto file = folder.path() / name;
      ASSERT_TRUE(write_mesh_file(file, named, {.metres_per_unit = millimetres_per(unit) / 1000}).ok());
      const OpenedFile opened = open_file(file);
      ASSERT_TRUE(opened.document);
      EXPECT_TRUE(opened.messages.empty());
      EXPECT_TRUE(opened.says_unit);
      EXPECT_EQ(opened.document->unit, name == std::string("a.3mf") ? unit : Unit::millimetre);
      ASSERT_EQ(opened.document->objects.size(), 2U);
      EXPECT_EQ(opened.document->objects[0]->name, "one");
      EXPECT_EQ(opened.document->objects[1]->name, "two");
      // Both the document and what is unfolded have the size of the model.
      const Document model = document_from_mesh(first, "one").value();
      EXPECT_NEAR(size_of(*opened.document, 0), millimetres_per(unit) * size_of(model, 0),
                  1e-6 * millimetres_per(unit));
      const auto facets = test::must(model_facets(file, {}));
      EXPECT_NEAR(facets->mesh.positions[0].norm(), millimetres_per(unit) * first.positions[0].norm(),
                  1e-6 * millimetres_per(unit));
    }
  }
}

TEST(OpenScene, BrokenMeshesAreRepairedOrKeptBesideTheOthers) {
  const test::TemporaryFolder folder;
  const PolygonMesh good = test::octahedron(), broken = twisted();
  const std::array<NamedPolygons, 3> named{{{"good", &good}, {"broken", &broken}, {"also good", &good}}};
  ASSERT_TRUE(write_mesh_file(folder.path() / "a.3mf", named).ok());
  const OpenedFile opened = open_file(folder.path() / "a.3mf");
  EXPECT_FALSE(opened.document);
  EXPECT_EQ(opened.name, "broken");
  ASSERT_TRUE(opened.broken_mesh);
  EXPECT_EQ(opened.broken_mesh->face_count(), 2U);
  ASSERT_TRUE(opened.error());
  EXPECT_TRUE(opened.error()->text.starts_with("\"broken\": ")) << opened.error()->text;
  ASSERT_TRUE(opened.repaired && opened.reference);
  for (const auto* document : {&*opened.repaired, &*opened.reference}) {
    ASSERT_EQ(document->objects.size(), 3U);
    EXPECT_EQ(document->objects[1]->name, "broken");
    EXPECT_TRUE(document->objects[0]->polyhedron() && document->objects[2]->polyhedron());
  }
  EXPECT_TRUE(opened.repaired->objects[1]->polyhedron());
  EXPECT_TRUE(opened.reference->objects[1]->mesh());
  EXPECT_EQ(opened.repair.turned_faces, 1U);
}

TEST(OpenScene, OneBrokenMeshIsSaidAsInOtherFormats) {
  const test::TemporaryFolder folder;
  const PolygonMesh broken = twisted();
  const std::array<NamedPolygons, 1> named{{{"broken", &broken}}};
  std::array<std::vector<std::string>, 2> texts;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto file = folder.path() / (k == 0 ? "a.obj" : "a.3mf");
    ASSERT_TRUE(write_mesh_file(file, named).ok());
    for (const Message& message : open_file(file).messages) texts[k].push_back(to_string(message));
  }
  EXPECT_FALSE(texts[0].empty());
  EXPECT_EQ(texts[0], texts[1]);
}

TEST(OpenScene, FilesOfOtherProgramsAreRefusedWithAWord) {
  const test::TemporaryFolder folder;
  const std::pair<const char*, const char*> cases[] = {{"a.usdz", "USD"},
                                                       {"b.FBX", "FBX"},
                                                       {"c.sldprt", "CAD program"},
                                                       {"d.dwg", "drawing"},
                                                       {"e.xyz", "can be read"}};
  for (const auto& [name, word] : cases) {
    test::spill(folder.path() / name, "PK\x03\x04 whatever");
    if (std::string(name) == "e.xyz") test::spill(folder.path() / name, "1 2 3\n4 5 6\n");
    const OpenedFile opened = open_file(folder.path() / name);
    ASSERT_TRUE(opened.error()) << name;
    EXPECT_EQ(opened.error()->code, e_format_unknown);
    EXPECT_NE(opened.error()->text.find(word), std::string::npos) << opened.error()->text;
    EXPECT_FALSE(opened.error()->remedy.empty());
  }
  EXPECT_EQ(open_file(folder.path() / "gone.usdz").error()->code, e_file_open);
}

TEST(OpenScene, AnUnknownEndingIsNoReasonToRefuseAMesh) {
  const test::TemporaryFolder folder;
  test::spill(folder.path() / "scan.txt", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  test::spill(folder.path() / "part",
              "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
              "vertex 0 1 0\nendloop\nendfacet\nendsolid x\n");
  for (const char* name : {"scan.txt", "part"}) {
    const OpenedFile opened = open_file(folder.path() / name);
    ASSERT_TRUE(opened.document) << name;
    EXPECT_EQ(opened.document->objects.size(), 1U);
  }
}

TEST(OpenScene, LayoutsFarFromZeroGetAPlace) {
  const test::TemporaryFolder folder;
  const auto opened = [&](const std::string& name, const std::string& text) {
    EXPECT_TRUE(write_file_atomic(folder.path() / name, text).ok());
    OpenedFile file = open_file(folder.path() / name);
    EXPECT_TRUE(file.document.has_value()) << (file.error() ? to_string(*file.error()) : "");
    return file.document ? file.document->objects.at(0) : std::shared_ptr<const Object>();
  };
  const auto scene = opened("scene.json", R"({"primitives": [
    {"type": "box", "position": [1000000.125, 3, 0]}, {"type": "sphere", "position": [1000001.25, 3, 0]}]})");
  ASSERT_TRUE(scene);
  EXPECT_NEAR(scene->transform.translation.x(), 1e6, 10);
  EXPECT_EQ(scene->transform.translation.tail<2>(), Vector2::Zero());
  ASSERT_TRUE(scene->solids());
  for (const std::size_t k : {0U, 1U}) {
    const Vector3 position = scene->solids()->input->solids.at(k).position;
    EXPECT_LT(std::abs(position.x()), 10);
    EXPECT_EQ(scene->transform.apply(position), Vector3(k == 0 ? 1000000.125 : 1000001.25, 3, 0));
  }
  const auto near = opened("near.json", R"({"primitives": [{"type": "box", "position": [100, 3, 0]}]})");
  ASSERT_TRUE(near);
  EXPECT_EQ(near->transform, Similarity());
  const auto skin =
      opened("skin.json", R"({"origin": [10, 20, 30], "path": {"points": [[0, 0, 0], [0, 0, 2]]},
    "sections": [{"v": 0, "closed": true, "points": [[1, 0, 0], [0, 1, 0], [-1, -1, 0]]},
                 {"v": 1, "closed": true, "points": [[1, 0, 2], [0, 1, 2], [-1, -1, 2]]}]})");
  ASSERT_TRUE(skin);
  EXPECT_EQ(skin->transform.translation, Vector3(10, 20, 30));
  const auto outline = opened("outline.json", R"({"origin": [0, 0, 1000000000], "loops": [
    {"points": [[1000000001, 0, 0], [1000000000, 1, 0], [999999999, 0, 0]],
     "normals": [[1, 0, 1], [0, 1, 1], [-1, 0, 1]]}]})");
  ASSERT_TRUE(outline);
  EXPECT_EQ(outline->transform.translation, Vector3(1e9, 0, 1e9));
  ASSERT_TRUE(outline->outline());
  EXPECT_EQ(outline->outline()->outline->loops[0].points[2], Vector3(-1, 0, 0));
}

}  // namespace
}  // namespace hariko

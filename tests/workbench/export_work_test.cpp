// Triangles that are exported by hand: unit, scale, up axis and text, remembered for each format; closed
// files; and what comes back by an import.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/exchange/mesh_file.hpp"
#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

using StlCorner = std::array<float, 3>;

/// Triangles of a binary STL file; none where its size is not the one that its count says.
std::vector<std::array<StlCorner, 3>> triangles_of_stl(const std::string& bytes) {
  std::vector<std::array<StlCorner, 3>> out;
  constexpr std::size_t header = 84, row = 50, normal = 12;
  std::uint32_t count = 0;
  if (bytes.size() < header) return out;
  std::memcpy(&count, bytes.data() + header - sizeof count, sizeof count);
  if (bytes.size() != header + row * count) return out;
  out.resize(count);
  for (std::size_t t = 0; t < count; ++t)
    std::memcpy(out[t].data(), bytes.data() + header + row * t + normal, sizeof out[t]);
  return out;
}

/// Every directed edge is there once, and so is its opposite.
template <class Corner>
bool every_edge_is_met(const std::vector<std::array<Corner, 3>>& triangles) {
  std::map<std::pair<Corner, Corner>, int> edges;
  for (const auto& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::pair(triangle[i], triangle[(i + 1) % 3])];
  return !edges.empty() && std::all_of(edges.begin(), edges.end(), [&edges](const auto& edge) {
    const auto opposite = edges.find(std::pair(edge.first.second, edge.first.first));
    return edge.second == 1 && opposite != edges.end();
  });
}

class ExportWork : public ::testing::Test, protected ProgramHands {
 protected:
  void SetUp() override { open_sample("fig2"); }
  bool shows(const std::string& mark) { return marks().contains(mark); }
  /// Opens the dialog and names the file: the dialog stays open.
  void begin(const std::string& name) {
    press({"Ctrl+E"});
    frames(4);
    ASSERT_TRUE(shows("export.by"));
    type((folder() / name).string());
    frames(2);
  }
  void fill_in(const std::string& field, const char* text) {
    click(field);
    type(text);
    click("dialog.name");
  }
  /// Few triangles: each import makes a polyhedron of them.
  void coarsely() { fill_in("export.distance", "0.05 mm"); }
  void choose_unit(const std::string& unit) {
    click("export.unit");
    click("export.unit." + unit);
  }
  void accept(const std::string& name) {
    click("dialog.accept");
    wait();
    ASSERT_TRUE(std::filesystem::exists(folder() / name)) << notice();
  }
  void export_coarsely(const std::string& name) {
    begin(name);
    coarsely();
    accept(name);
  }
  /// Extents of a file of STL, in its numbers.
  Vector3 size_of(const std::string& name) {
    const auto mesh = read_mesh_file(folder() / name);
    EXPECT_TRUE(mesh.ok()) << name;
    return mesh.ok() ? extents(mesh->mesh.positions) : Vector3(Vector3::Zero());
  }
  static Vector3 extents(const std::vector<Vector3>& positions) {
    Box3 box;
    for (const Vector3& p : positions) box.extend(p);
    return box.sizes();
  }
  static void expect_size(const Vector3& found, const Vector3& expected) {
    EXPECT_LT((found - expected).norm(), 1e-5 * expected.norm())
        << found.transpose() << " instead of " << expected.transpose();
  }
};

TEST_F(ExportWork, EachFormatHasTheSettingsThatItHadLast) {
  export_coarsely("plain.stl");
  const Vector3 plain = size_of("plain.stl");
  begin("other.stl");
  choose_unit("cm");
  fill_in("export.scale", "3");
  click("export.up.y");
  accept("other.stl");
  const Vector3 other = size_of("other.stl");
  expect_size(other, 0.3 * Vector3(plain.x(), plain.z(), plain.y()));

  // glTF leaves no choice of unit and axis; its settings are its own.
  begin("a.glb");
  EXPECT_FALSE(shows("export.unit"));
  EXPECT_FALSE(shows("export.up.y"));
  coarsely();
  accept("a.glb");
  EXPECT_TRUE(slurp(folder() / "a.glb").starts_with("glTF"));
  begin("again.stl");
  accept("again.stl");
  EXPECT_TRUE(slurp(folder() / "again.stl") == slurp(folder() / "other.stl")) << "the settings are others";

  begin("text.stl");
  click("export.ascii");
  accept("text.stl");
  EXPECT_TRUE(slurp(folder() / "text.stl").starts_with("solid"));
  expect_size(size_of("text.stl"), other);
}

TEST_F(ExportWork, WhatIsImportedHasTheNamesAndSizesThatItsFormatKeeps) {
  export_coarsely("plain.stl");
  const Vector3 plain = size_of("plain.stl");
  begin("other.stl");
  choose_unit("cm");
  accept("other.stl");
  export_coarsely("a.glb");
  export_coarsely("a.3mf");
  EXPECT_TRUE(slurp(folder() / "a.3mf").starts_with("PK"));

  // STL gives numbers alone; the others tell their unit.
  const std::array<std::pair<const char*, Vector3>, 3> files{
      {{"other.stl", Vector3(0.1 * plain)}, {"a.glb", plain}, {"a.3mf", plain}}};
  std::vector<std::string> names{"Vase"};
  for (const auto& [file, size] : files) {
    press({"Ctrl+I"});
    name_file(file);
    wait();
    names.emplace_back(std::string(file) == "other.stl" ? "other" : "Vase");
    const auto& objects = editor().document().objects;
    ASSERT_EQ(objects.size(), names.size()) << notice();
    EXPECT_EQ(objects.back()->name, names.back());
    ASSERT_TRUE(objects.back()->polyhedron());
    expect_size(extents(objects.back()->polyhedron()->polyhedron.positions()), size);
  }
}

/// Losses of the 32-bit numbers of STL are taken from the tolerance: it may need a few triangles more.
TEST_F(ExportWork, ObjAndStlAreClosedAndOfTheSameTriangles) {
  begin("a.obj");
  accept("a.obj");
  begin("a.stl");
  accept("a.stl");
  const auto obj = read_mesh_file(folder() / "a.obj");
  ASSERT_TRUE(obj.ok());
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t f = 0; f < obj->mesh.face_count(); ++f) {
    const auto face = obj->mesh.face(f);
    ASSERT_EQ(face.size(), 3U);
    triangles.push_back({face[0], face[1], face[2]});
  }
  EXPECT_TRUE(every_edge_is_met(triangles)) << "OBJ";
  const auto stl = triangles_of_stl(slurp(folder() / "a.stl"));
  EXPECT_TRUE(every_edge_is_met(stl)) << "STL";
  EXPECT_GE(stl.size(), triangles.size());
  EXPECT_LE(double(stl.size()), 1.01 * double(triangles.size()));
}

}  // namespace
}  // namespace hariko::test

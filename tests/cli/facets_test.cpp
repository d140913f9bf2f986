// Reference facets, and the digits of files, on the command line: cases of complaints (tests/cases).

#include <Eigen/Geometry>
#include <map>

#include "core/cad/kernel/cad_file.hpp"
#include "core/exchange/mesh_file.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {
namespace {

class Facets : public ProgramTest {};

std::string case_file(const std::string& name) {
  return source_folder() + "/tests/cases/" + name;
}

/// Triangles of a file, counted and measured; corners are joined where they are equal bit for bit.
struct Known {
  std::size_t triangles = 0, bad = 0;
  double volume = 0, area = 0;
  Eigen::AlignedBox3d box;
};
Known known(const std::string& path) {
  Known out;
  const auto file = read_mesh_file(path);
  EXPECT_TRUE(file.ok()) << file.error().text;
  if (!file.ok()) return out;
  const PolygonMesh& mesh = file->mesh;
  std::map<std::array<double, 3>, Index> numbers;
  const auto number = [&](Index v) {
    const Vector3& p = mesh.positions[v];
    return numbers.try_emplace({p.x(), p.y(), p.z()}, Index(numbers.size())).first->second;
  };
  std::map<std::pair<Index, Index>, int> uses;
  for (const Vector3& p : mesh.positions) out.box.extend(p);
  const Vector3 middle = out.box.isEmpty() ? Vector3(Vector3::Zero()) : Vector3(out.box.center());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Vector3 a = mesh.positions[face[0]] - middle, b = mesh.positions[face[1]] - middle,
                  c = mesh.positions[face[2]] - middle;
    out.volume += a.dot(b.cross(c)) / 6;
    out.area += (b - a).cross(c - a).norm() / 2;
    for (std::size_t k = 0; k < 3; ++k) ++uses[{number(face[k]), number(face[(k + 1) % 3])}];
  }
  out.triangles = mesh.face_count();
  for (const auto& [edge, count] : uses) {
    const auto opposite = uses.find({edge.second, edge.first});
    out.bad += count != 1 || opposite == uses.end() || opposite->second != 1 ? 1 : 0;
  }
  return out;
}

TEST_F(Facets, BoxesOfCadProgramsAreExportedClosed) {
  if (why_no_cad_files()) GTEST_SKIP() << "built without OpenCASCADE";
  for (const char* model : {"step_box_planes.step", "step_box_mixed.step"})
    for (const char* ending : {"stl", "obj", "3mf", "glb", "ply", "off"}) {
      SCOPED_TRACE(std::string(model) + " to " + ending);
      const std::string out = path(std::string("o.") + ending);
      succeed("export " + case_file(model) + " " + out);
      const Known is = known(out);
      if (std::string(model) == "step_box_planes.step") EXPECT_EQ(is.triangles, 12U);
      EXPECT_EQ(is.bad, 0U);
      EXPECT_NEAR(is.volume, 6000, 1e-3);
      EXPECT_NEAR(is.area, 2200, 1e-3);
    }
}

TEST_F(Facets, BoxesOfCadProgramsAreMeasuredMeshedUnfoldedAndDrawn) {
  if (why_no_cad_files()) GTEST_SKIP() << "built without OpenCASCADE";
  for (const char* model : {"step_box_planes.step", "step_box_mixed.step"}) {
    SCOPED_TRACE(model);
    const Outcome info = succeed("info " + case_file(model) + " --json");
    const Json json = info.json();
    ASSERT_TRUE(json.is_object()) << info.out;
    const Json& box = json["objects"].at(0);
    EXPECT_EQ(box["kind"], "mesh");
    EXPECT_NEAR(box["volume"].get<double>(), 6000, 1e-6);
    EXPECT_NEAR(box["area"].get<double>(), 2200, 1e-6);
    succeed("mesh " + case_file(model) + " " + path("m.stl") + " --distance 0.1");
    EXPECT_EQ(known(path("m.stl")).bad, 0U);
    const Outcome unfolded = succeed("unfold " + case_file(model) + " " + path("p.pdf") + " --json");
    EXPECT_EQ(unfolded.json()["components"], 1);
    const Outcome drawn = run("render " + case_file(model) + " " + path("p.png") + " --size 80x60");
    EXPECT_TRUE(drawn.exit_code == 0 || drawn.error.find("E_GL") != std::string::npos) << drawn.error;
    EXPECT_EQ(drawn.error.find("E_NOTHING_TO_SHOW"), std::string::npos);
    succeed("render " + case_file(model) + " " + path("p.svg"));
  }
}

TEST_F(Facets, CadFilesSayWhyTheyCannotHoldFacets) {
  if (why_no_cad_files()) GTEST_SKIP() << "built without OpenCASCADE";
  const Outcome result = run("export " + case_file("step_box_planes.step") + " " + path("o.step"));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.error.find("E_NO_SURFACE"), std::string::npos) << result.error;
  EXPECT_NE(result.error.find("reference facets"), std::string::npos) << result.error;
}

TEST_F(Facets, CoordinatesThatStlCannotHoldAreRefusedWithTheWayOut) {
  const std::string cube = case_file("cube_at_utm_place.obj");
  for (const char* command : {"mesh", "export"})
    for (const char* ascii : {"", " --ascii"}) {
      SCOPED_TRACE(std::string(command) + ascii);
      const std::string start = std::string(command) + " " + cube + " " + path("o.stl") + ascii +
                                (std::string(command) == "mesh" ? " --distance 0.01" : "");
      const Outcome refused = run(start);
      EXPECT_EQ(refused.exit_code, 1);
      EXPECT_NE(refused.error.find("E_FILE_DIGITS"), std::string::npos) << refused.error;
      EXPECT_NE(refused.error.find("--origin zero"), std::string::npos) << refused.error;
      EXPECT_FALSE(std::filesystem::exists(path("o.stl")));
      const Outcome moved = succeed(start + " --origin zero");
      EXPECT_NE(moved.out.find("moved to zero by"), std::string::npos) << moved.out;
      const Known is = known(path("o.stl"));
      EXPECT_EQ(is.bad, 0U);
      EXPECT_NEAR(is.box.center().norm(), 0, 1e-5);
      std::filesystem::remove(path("o.stl"));
    }
  for (const char* ending : {"obj", "ply", "3mf", "glb"}) {
    const Outcome result =
        succeed("mesh " + cube + " " + path(std::string("o.") + ending) + " --distance 0.01 --json");
    EXPECT_LE(result.json()["objects"].at(0)["distance"]["bound"].get<double>(), 0.01);
    EXPECT_EQ(known(path(std::string("o.") + ending)).bad, 0U) << ending;
  }
}

}  // namespace
}  // namespace hariko::test

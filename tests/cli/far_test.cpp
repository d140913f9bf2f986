// Skins, solids and outlines far from zero and of any size: what is made of them is what it is at zero.

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <map>

#include "core/exchange/mesh_file.hpp"
#include "tests/cli/program.hpp"

namespace hariko::test {
namespace {

/// A layout, how all lengths in it grow, and where its places go.
struct Layout {
  Json at_zero;
  std::function<Json(Json, double scale, double shift)> moved;
};

void move_points(Json& points, double scale, double shift) {
  for (Json& point : points)
    for (Json& x : point) x = scale * x.get<double>() + shift;
}

Json moved_skin(Json skin, double scale, double shift) {
  move_points(skin["path"]["points"], scale, shift);
  for (Json& section : skin["sections"]) move_points(section["points"], scale, shift);
  return skin;
}

Json moved_solids(Json scene, double scale, double shift) {
  for (Json& solid : scene["primitives"]) {
    if (solid.contains("size"))
      for (Json& x : solid["size"]) x = scale * x.get<double>();
    Json place = solid.value("position", Json::array({0.0, 0.0, 0.0}));
    for (Json& x : place) x = scale * x.get<double>() + shift;
    solid["position"] = place;
  }
  return scene;
}

Json moved_outline(Json outline, double scale, double shift) {
  for (Json& loop : outline["loops"]) {
    move_points(loop["points"], scale, shift);
    if (loop.contains("K"))
      for (Json& k : loop["K"]) k = k.get<double>() / (scale * scale);
  }
  return outline;
}

double area_of(const PolygonMesh& mesh) {
  double out = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const auto at = [&](std::size_t k) -> const Vector3& { return mesh.positions[face[k]]; };
    out += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
  }
  return out;
}

class FarFromZero : public ProgramTest {
 protected:
  static std::map<std::string, Layout> layouts() {
    const auto parsed = [](const std::string& file) { return Json::parse(read_text(file)); };
    return {{"skin",
             {moved_skin(parsed(test::source_folder() + "/tests/cases/skin_far_from_origin.json"), 1, -1e6),
              moved_skin}},
            {"solids", {parsed(golden("envelope/ell.json")), moved_solids}},
            {"outline", {parsed(golden("gaussmap/ellipsoid_cap.json")), moved_outline}}};
  }
  Json measured(const Json& layout) {
    write_text(path("a.json"), layout.dump());
    const Outcome result = succeed("info --json " + path("a.json"));
    return result.object();
  }
};

TEST_F(FarFromZero, LayoutsOfAllSizesMeasureAsAtZero) {
  for (const auto& [name, layout] : layouts()) {
    const Json here = measured(layout.at_zero);
    for (const double scale : {1e-3, 1.0, 1e3, 1e6}) {
      SCOPED_TRACE(name + " times " + std::to_string(scale));
      const Json there = measured(layout.moved(layout.at_zero, scale, 1e6));
      // The cells of solids lie on the object's grid: a move by no whole number of cells cuts them elsewhere.
      const bool cells = name == "solids";
      const double digits = cells ? 1e-3 : 1e-6;
      if (!cells) {
        EXPECT_EQ(there["patches"], here["patches"]);
      }
      EXPECT_EQ(there["messages"].size(), here["messages"].size());
      EXPECT_EQ(there["degenerate_samples"], here["degenerate_samples"]);
      EXPECT_EQ(there["folded_samples"], here["folded_samples"]);
      EXPECT_NEAR(there["area"].get<double>() / (scale * scale) / here["area"].get<double>(), 1, digits);
      ASSERT_EQ(there["volume"].is_null(), here["volume"].is_null());
      EXPECT_EQ(here["volume"].is_null(), name == "outline") << "a cap is open";
      if (!here["volume"].is_null()) {
        EXPECT_NEAR(there["volume"].get<double>() / std::pow(scale, 3) / here["volume"].get<double>(), 1,
                    digits);
      }
    }
  }
}

TEST_F(FarFromZero, FilesOfFewDigitsGetThemAtZero) {
  for (const auto& [name, layout] : layouts()) {
    SCOPED_TRACE(name);
    write_text(path("far.json"), layout.moved(layout.at_zero, 1e-3, 1e6).dump());
    write_text(path("near.json"), layout.moved(layout.at_zero, 1e-3, 0).dump());
    const Outcome refused = run("export " + path("far.json") + " " + path("far.stl"));
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.error.find("E_FILE_DIGITS"), std::string::npos) << refused.error;
    ASSERT_EQ(run("export " + path("far.json") + " " + path("far.stl") + " --origin zero").exit_code, 0);
    ASSERT_EQ(run("export " + path("near.json") + " " + path("near.stl") + " --origin zero").exit_code, 0);
    const auto far = read_mesh_file(path("far.stl")), near = read_mesh_file(path("near.stl"));
    ASSERT_TRUE(far.ok() && near.ok());
    if (name != "solids") {
      EXPECT_EQ(far->mesh.face_count(), near->mesh.face_count());
    }
    EXPECT_NEAR(area_of(far->mesh) / area_of(near->mesh), 1, name == "solids" ? 1e-3 : 1e-5);
  }
}

}  // namespace
}  // namespace hariko::test

#include <Eigen/Geometry>
#include <map>

#include "core/exchange/mesh_file.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/must.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {
namespace {

class ExportRender : public ProgramTest {};

/// Directed edges without their opposite; a directed edge used twice counts too.
std::size_t open_edges(const PolygonMesh& mesh) {
  std::map<std::pair<Index, Index>, int> count;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) ++count[{face[k], face[(k + 1) % face.size()]}];
  }
  std::size_t open = 0;
  for (const auto& [edge, uses] : count)
    open += uses != 1 || count.find({edge.second, edge.first}) == count.end() ? 1 : 0;
  return open;
}

TEST_F(ExportRender, MeshesAreWholeInEveryFormat) {
  for (const std::string extension : {"obj", "ply", "stl"})
    for (const int density : {1, 5}) {
      const std::string out = path("cube." + extension);
      succeed("export " + golden("cube.obj") + " " + out + " --density " + std::to_string(density));
      const auto mesh = must(read_mesh_file(out));
      EXPECT_EQ(mesh->mesh.face_count(), static_cast<std::size_t>(24 * density * density)) << extension;
      EXPECT_EQ(open_edges(mesh->mesh), 0U) << extension << " " << density;
    }
}

TEST_F(ExportRender, DensityIsEightAndEdgesOfOpenSurfacesStayOpen) {
  const std::string out = path("grid.obj");
  ASSERT_EQ(run("export " + golden("grid3.obj") + " " + out).exit_code, 0);
  const auto mesh = must(read_mesh_file(out));
  EXPECT_EQ(mesh->mesh.face_count(), 36U * 64U);
  EXPECT_EQ(open_edges(mesh->mesh), 12U * 8U);
}

TEST_F(ExportRender, UnitScaleUpAxisAndObjectsCanBeChosen) {
  const auto size = [&](const std::string& options) {
    const std::string out = path("a.obj");
    succeed("export " + golden("cube.obj") + " " + out + " --density 2 " + options);
    Eigen::AlignedBox3d box;
    const auto mesh = must(read_mesh_file(out));
    for (const Vector3& p : mesh->mesh.positions) box.extend(p);
    return Vector3(box.sizes());
  };
  const Vector3 usual = size("");
  EXPECT_LT((size("--unit in --scale 3") - usual * 3 / 25.4).norm(), 1e-12 * usual.norm());
  EXPECT_LT((size("--unit m") - usual / 1000).norm(), 1e-12 * usual.norm());
  EXPECT_LT((size("--only cube --up y") - Vector3(usual.x(), usual.z(), usual.y())).norm(),
            1e-12 * usual.norm());
  const Outcome missing = run("export " + golden("cube.obj") + " " + path("b.obj") + " --only ball");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_NE(missing.error.find("E_NO_SUCH_OBJECT"), std::string::npos) << missing.error;
  for (const char* wrong : {"c.glb --unit mm", "c.3mf --up y", "c.obj --scale 0", "c.obj --scale nan",
                            "c.obj --unit ft", "c.obj --ascii", "c.glb --ascii", "c.step --ascii"})
    EXPECT_EQ(run("export " + golden("cube.obj") + " " + path(wrong)).exit_code, 2) << wrong;
  for (const char* name : {"d.3mf", "d.gltf", "d.glb"})
    EXPECT_EQ(run("export " + golden("cube.obj") + " " + path(name) + " --scale 2").exit_code, 0) << name;
}

TEST_F(ExportRender, StlAndPlyAreWrittenAsTextToo) {
  const auto written = [&](const std::string& command, const std::string& name, const std::string& options) {
    succeed(command + " " + golden("cube.obj") + " " + path(name) + " " + options);
    return read_text(path(name));
  };
  for (const std::string command : {"export", "mesh --distance 0.1"})
    for (const std::string ending : {".stl", ".ply"}) {
      SCOPED_TRACE(command + ending);
      const std::string binary = written(command, "binary" + ending, ""),
                        text = written(command, "text" + ending, "--ascii");
      EXPECT_NE(binary.find('\0'), std::string::npos);
      EXPECT_EQ(text.find('\0'), std::string::npos);
      EXPECT_GT(text.size(), binary.size());
      const auto a = read_mesh_file(path("binary" + ending)), b = read_mesh_file(path("text" + ending));
      ASSERT_TRUE(a.ok() && b.ok());
      ASSERT_EQ(a->mesh.positions.size(), b->mesh.positions.size());
      for (std::size_t i = 0; i < a->mesh.positions.size(); ++i)
        EXPECT_EQ(a->mesh.positions[i].cast<float>(), b->mesh.positions[i].cast<float>());
      EXPECT_EQ(a->mesh.face_vertices, b->mesh.face_vertices);
    }
}

TEST_F(ExportRender, OldFileStaysWhenTheInputFails) {
  write_text(path("out.obj"), "old");
  EXPECT_EQ(run("export " + path("missing.obj") + " " + path("out.obj")).exit_code, 1);
  EXPECT_EQ(read_text(path("out.obj")), "old");
  EXPECT_EQ(run("export " + golden("cube.obj") + " " + path("no/such/folder/out.obj")).exit_code, 1);
}

TEST_F(ExportRender, TooManyTrianglesAreRefused) {
  // A grid of 20 x 20 quads has 1,600 patches: 105 million triangles at density 256.
  std::string obj;
  for (int j = 0; j <= 20; ++j)
    for (int i = 0; i <= 20; ++i) obj += "v " + std::to_string(i) + " " + std::to_string(j) + " 0\n";
  for (int j = 0; j < 20; ++j)
    for (int i = 1; i <= 20; ++i) {
      const int a = j * 21 + i;
      obj += "f " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(a + 22) + " " +
             std::to_string(a + 21) + "\n";
    }
  write_text(path("grid.obj"), obj);
  const Outcome result = run("export " + path("grid.obj") + " " + path("huge.ply") + " --density 256");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.error.find("E_TOO_MANY_TRIANGLES"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path("huge.ply")));
}

std::pair<int, int> png_size(const std::string& bytes) {
  if (bytes.size() < 24 || bytes.compare(1, 3, "PNG") != 0) return {0, 0};
  const auto number = [&](std::size_t at) {
    int out = 0;
    for (std::size_t k = 0; k < 4; ++k) out = out * 256 + static_cast<unsigned char>(bytes[at + k]);
    return out;
  };
  return {number(16), number(20)};
}

TEST_F(ExportRender, PicturesOfEveryMapAndView) {
  const std::string out = path("picture.png");
  std::map<std::string, std::string> pictures;
  for (const std::string map : {"shaded", "patches", "zebra", "gauss", "mean", "k1", "k2", "continuity"}) {
    const Outcome result = run("render " + golden("fig2.obj") + " " + out + " --size 160x120 --map " + map);
    ASSERT_EQ(result.exit_code, 0) << result.error;
    EXPECT_EQ(png_size(read_text(out)), (std::pair<int, int>{160, 120}));
    EXPECT_TRUE(pictures.emplace(read_text(out), map).second) << map << " looks like another map";
  }
  for (const std::string view : {"front", "left", "top"}) {
    ASSERT_EQ(run("render " + golden("car.obj") + " " + out + " --size 160x120 --view " + view).exit_code, 0);
    EXPECT_TRUE(pictures.emplace(read_text(out), view).second) << view << " looks like another view";
  }
  ASSERT_EQ(
      run("render " + golden("fig2.obj") + " " + out + " --size 160x120 --show polyhedron,network").exit_code,
      0);
  EXPECT_TRUE(pictures.emplace(read_text(out), "lines").second) << "polyhedron and network do not show";
}

TEST_F(ExportRender, EnvironmentsAreReflectedTurnedAndExposed) {
  const std::string out = path("picture.png");
  const std::string command = "render " + golden("fig2.obj") + " " + out + " --size 160x120";
  const auto picture = [&](const std::string& options) {
    succeed(command + options);
    return read_text(out);
  };
  std::map<std::string, std::string> pictures;
  EXPECT_TRUE(pictures.emplace(picture(""), "none").second);
  std::string panorama = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
  panorama += std::string("\x80\x20\x20\x80", 4) + std::string("\x20\x20\x80\x80", 4);
  write_text(path("hall.hdr"), panorama);
  for (const std::string& name : {std::string("studio"), std::string("tubes"), std::string("horizon"),
                                  std::string("overcast"), path("hall.hdr")})
    EXPECT_TRUE(pictures.emplace(picture(" --environment " + name), name).second) << name;
  EXPECT_TRUE(pictures.emplace(picture(" --environment studio --environment-turn 90"), "turned by 90 degrees")
                  .second);
  EXPECT_TRUE(pictures.emplace(picture(" --environment studio --exposure -1.5"), "darker").second);
  EXPECT_EQ(picture(" --environment studio --environment-turn 360"), picture(" --environment studio"));
  write_text(path("text.hdr"), "no picture");
  for (const auto& [name, code] : {std::pair{"gone.hdr", "E_FILE"}, {"text.hdr", "E_PICTURE_KIND"}}) {
    const Outcome refused = run(command + " --environment " + path(name));
    EXPECT_EQ(refused.exit_code, 1) << name;
    EXPECT_NE(refused.error.find(code), std::string::npos) << refused.error;
  }
  for (const char* wrong : {" --environment studio --map zebra", " --environment-turn 10", " --exposure 1",
                            " --environment studio --exposure 9"})
    EXPECT_EQ(run(command + wrong).exit_code, 2) << wrong;
}

TEST_F(ExportRender, WhateverObjectsAreMadeFromIsDrawn) {
  std::string patch = "1\n3 3\n";
  for (int i = 0; i < 16; ++i) {
    const int x = i % 4, y = i / 4;
    const bool inside = x % 3 != 0 && y % 3 != 0;
    patch += std::to_string(x) + " " + std::to_string(y) + (inside ? " 2\n" : " 0\n");
  }
  write_text(path("patch.bpt"), patch);
  const std::string out = path("picture.png");
  for (const std::string& file :
       {path("patch.bpt"), test::source_folder() + "/assets/samples/saddle.hariko"}) {
    const auto picture = [&](const std::string& options) {
      succeed("render " + file + " " + out + " --size 160x120" + options);
      return read_text(out);
    };
    EXPECT_NE(picture(""), picture(" --show polyhedron")) << file;
  }
}

/// As file managers ask for thumbnails.
TEST_F(ExportRender, AFormatStandsForTheEndingOfTheName) {
  const std::string picture = path("thumbnail.XYZ"), lines = path("lines");
  Outcome result = succeed("render " + golden("cube.obj") + " " + picture + " --format png --size 64x64");
  EXPECT_EQ(read_text(picture).substr(0, 4), "\x89PNG");
  result = succeed("render " + golden("cube.obj") + " " + lines + " --format svg --hidden");
  EXPECT_NE(read_text(lines).find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace hariko::test

// Meshes of other programs, and files that stand in pipes.

#include <cstdlib>
#include <filesystem>
#include <set>

#include "tests/cli/program.hpp"

namespace hariko::test {
namespace {

std::string import_case(const std::string& name) {
  return "'" + source_folder() + "/tests/cases/" + name + "'";
}

std::set<std::string> codes_of(const Json& object) {
  std::set<std::string> out;
  for (const Json& message : object["messages"]) out.insert(message["code"].get<std::string>());
  return out;
}

/// A cube of triangles, each with corners of its own, which are moved by `noise` at random places.
std::string loose_cube(double noise) {
  const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::string out;
  int corner = 0;
  for (const auto& quad : quads)
    for (const int k : {0, 1, 2, 0, 2, 3}) {
      const int v = quad[k];
      const double away = noise * ((corner * 7) % 5 - 2);
      for (int axis = 0; axis < 3; ++axis)
        out += (axis == 0 ? "v " : " ") + std::to_string(10.0 * (v >> axis & 1) + away);
      out += "\n";
      if (++corner % 3 == 0) out += "f -3 -2 -1\n";
    }
  return out;
}

using ImportTest = ProgramTest;

TEST_F(ImportTest, CornersAtTheSamePlaceAreJoinedAndItIsSaid) {
  write_text(path("loose.obj"), loose_cube(0));
  const Json cube = run("info --json " + path("loose.obj")).object();
  EXPECT_EQ(cube["vertices"], 8);
  EXPECT_EQ(cube["boundary_loops"], 0);
  EXPECT_EQ(codes_of(cube), std::set<std::string>{"W_CORNERS_JOINED"});
  EXPECT_EQ(cube["messages"][0]["text"], "28 corners at the same places as others were joined with them.");
}

TEST_F(ImportTest, NearCornersAreJoinedWhereItIsAskedFor) {
  write_text(path("near.obj"), loose_cube(1e-6));  // the digits of the file are 1e-6
  const Json apart = run("info --json " + path("near.obj")).object();
  EXPECT_TRUE(codes_of(apart).count("W_NEAR_CORNERS")) << apart;
  EXPECT_GT(apart["boundary_loops"].get<int>(), 0);
  for (const char* weld : {" --weld", " --weld 1e-5", " --weld=0.01"}) {
    const Json joined = run("info --json " + path("near.obj") + weld).object();
    EXPECT_EQ(joined["vertices"], 8) << weld;
    EXPECT_EQ(joined["boundary_loops"], 0) << weld;
    EXPECT_EQ(codes_of(joined), std::set<std::string>{"W_CORNERS_JOINED"}) << joined;
  }
  EXPECT_GT(run("info --json " + path("near.obj") + " --weld 1e-9").object()["boundary_loops"].get<int>(), 0);
  EXPECT_EQ(run("info --json " + path("near.obj") + " --weld -1").exit_code, 2);
}

TEST_F(ImportTest, TrianglesWithoutAreaAlongAnEdgeAreDroppedWithACount) {
  const std::string stl = import_case("stl_one_flat_triangle.stl");
  const Outcome done = succeed("export " + stl + " " + path("o.stl"));
  EXPECT_NE(done.error.find("W_FLAT_TRIANGLES: 1 flat triangle along an edge"), std::string::npos)
      << done.error;
  const Json cube = run("info --json " + stl).object();
  EXPECT_EQ(cube["faces"], 12);
  EXPECT_EQ(cube["vertices"], 8);
  EXPECT_EQ(cube["boundary_loops"], 0);
}

TEST_F(ImportTest, BrokenMeshesAreRepairedOrKeptAsFacetsWhereItIsAskedFor) {
  // A cube of which one face looks inward, and three sheets at one edge.
  std::string cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n";
  cube += "f 1 2 4 3\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  write_text(path("turned.obj"), cube);
  const Outcome refused = run("export " + path("turned.obj") + " " + path("o.stl"));
  EXPECT_EQ(refused.exit_code, 1);
  // One message for the four edges, and what can be done.
  std::size_t lines = 0;
  for (const char c : refused.error) lines += c == '\n';
  EXPECT_EQ(lines, 2U) << refused.error;
  EXPECT_NE(refused.error.find("(4 like this: edge 0-1, edge 0-2"), std::string::npos) << refused.error;
  EXPECT_NE(refused.error.find("--repair"), std::string::npos);
  const Json repaired = run("info --json --repair " + path("turned.obj")).object();
  EXPECT_EQ(repaired["kind"], "polyhedron");
  EXPECT_EQ(repaired["boundary_loops"], 0);
  EXPECT_GT(repaired["volume"].get<double>(), 0);
  EXPECT_TRUE(codes_of(repaired).count("W_REPAIRED"));
  EXPECT_EQ(run("export --repair " + path("turned.obj") + " " + path("o.stl")).exit_code, 0);
  const Json facets = run("info --json --reference " + path("turned.obj")).object();
  EXPECT_EQ(facets["kind"], "mesh");
  EXPECT_EQ(facets["faces"], 6);
  EXPECT_TRUE(codes_of(facets).count("W_KEPT_AS_FACETS"));
  // A sound mesh stays as it is.
  EXPECT_EQ(run("info --json --repair --reference " + golden("cube.obj")).object()["messages"].size(), 0U);
}

TEST_F(ImportTest, CreaseTagsOfObjAreCreases) {
  const Json creased = run("info --json " + import_case("obj_crease_tags.obj")).object();
  std::string plain = read_text(source_folder() + "/tests/cases/obj_crease_tags.obj");
  plain.resize(plain.find("t crease"));
  write_text(path("plain.obj"), plain);
  const Json round = run("info --json " + path("plain.obj")).object();
  EXPECT_TRUE(codes_of(creased).empty()) << creased;
  EXPECT_GT(std::abs(creased["area"].get<double>() - round["area"].get<double>()), 1);
  // The sharp upper rim is flat and no farther out than its corners.
  EXPECT_EQ(run("export " + import_case("obj_crease_tags.obj") + " " + path("o.obj")).exit_code, 0);
}

TEST_F(ImportTest, CreasesStayOnARepairedMesh) {
  const Json whole = run("info --json " + import_case("obj_crease_tags.obj")).object();
  std::string text = read_text(source_folder() + "/tests/cases/obj_crease_tags.obj");
  const std::size_t at = text.find("f 1 3 4 2");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 9, "f 2 4 3 1");
  write_text(path("turned.obj"), text);
  const Json repaired = run("info --json --repair " + path("turned.obj")).object();
  EXPECT_EQ(codes_of(repaired), std::set<std::string>{"W_REPAIRED"}) << repaired;
  EXPECT_NEAR(repaired["area"].get<double>(), whole["area"].get<double>(), 1e-9);
  EXPECT_NEAR(repaired["volume"].get<double>(), whole["volume"].get<double>(), 1e-9);
}

TEST_F(ImportTest, CornerTagsWithoutCreasesAreNoReasonToRefuseAMesh) {
  std::string cube = read_text(source_folder() + "/tests/cases/obj_crease_tags.obj");
  cube.resize(cube.find("t crease"));
  write_text(path("alone.obj"), cube + "t corner 1/1/0 4 10\nt crease 2/1/0 4 5 10\n");
  const Json alone = run("info --json " + path("alone.obj")).object();
  EXPECT_EQ(codes_of(alone), std::set<std::string>{"W_CORNER_LEFT_OUT"}) << alone;
  EXPECT_GT(alone["volume"].get<double>(), 0);
  write_text(path("met.obj"), cube + "t corner 1/1/0 4 10\nt crease 2/1/0 4 5 10\nt crease 2/1/0 6 4 10\n");
  EXPECT_TRUE(codes_of(run("info --json " + path("met.obj")).object()).empty());
}

TEST_F(ImportTest, ObjBezierSurfacesAreSurfaces) {
  std::string text = "o sheet\n";
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      text += "v " + std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(i * j % 3) + "\n";
  text +=
      "cstype bezier\ndeg 3 3\nsurf 0 1 0 1 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\nparm u 0 1\nparm v 0 "
      "1\nend\n";
  write_text(path("sheet.obj"), text);
  const Json sheet = run("info --json " + path("sheet.obj")).object();
  EXPECT_EQ(sheet["name"], "sheet");
  EXPECT_EQ(sheet["patches"], 1);
  EXPECT_GT(sheet["area"].get<double>(), 9);
}

TEST_F(ImportTest, StandardInputAndOutputStandForFiles) {
  const std::string cube = path("input.obj");  // as objects of pipes are called
  write_text(cube, read_text(golden("cube.obj")));
  const Json named = run("info --json " + cube).object();
  for (const char* from : {"", " --from obj"}) {
    const Outcome read = succeed(std::string("info --json -") + from, cube);
    EXPECT_EQ(read.object()["vertices"], named["vertices"]);
  }
  for (const char* format : {"stl", "obj", "ply", "glb"}) {
    const std::string file = path(std::string("o.") + format);
    ASSERT_EQ(run("export --density 3 " + cube + " " + file).exit_code, 0);
    const Outcome piped = succeed(std::string("export --density 3 - - --to ") + format, cube);
    EXPECT_EQ(piped.out.size(), read_text(file).size()) << format;
    if (format == std::string("stl")) {
      EXPECT_EQ(piped.out.substr(80), read_text(file).substr(80));
    }
  }
  // Reports go to the error stream while a file goes to the output.
  const Outcome mesh = succeed("mesh " + cube + " - --to ply --distance 0.1");
  EXPECT_TRUE(mesh.out.starts_with("ply\n"));
  EXPECT_NE(mesh.error.find("facets"), std::string::npos) << mesh.error;
  // Nothing is written where the job fails.
  write_text(path("bad.obj"), "v 0 0\n");
  const Outcome failed = run("export - - --from obj --to stl", path("bad.obj"));
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_EQ(failed.out, "");
  write_text(path("words.txt"), "what is this\n");
  EXPECT_EQ(run("info -", path("words.txt")).exit_code, 2) << "the format is not told";
  EXPECT_EQ(run("export " + cube + " -").exit_code, 2) << "nor here";
  EXPECT_EQ(run("export " + cube + " - --to xyz").exit_code, 2);
  EXPECT_EQ(run("info --from obj " + cube).exit_code, 2) << "only for -";
}

TEST_F(ImportTest, PipesLeaveNothingBehind) {
  const std::filesystem::path kept = path("kept");
  std::filesystem::create_directory(kept);
  const char* before = std::getenv("TMPDIR");
  const std::string usual = before ? before : "";
  ::setenv("TMPDIR", kept.c_str(), 1);
  // More than a pipe holds, for a reader that ends at once.
  run("export " + golden("cube.obj") + " - --to obj --density 40 | head -c 2 >'" + path("two") + "'; true");
  const bool empty = std::filesystem::is_empty(kept);
  ::setenv("TMPDIR", path("nothere").c_str(), 1);
  const Outcome nowhere = run("info -", golden("cube.obj"));
  if (before)
    ::setenv("TMPDIR", usual.c_str(), 1);
  else
    ::unsetenv("TMPDIR");
  EXPECT_EQ(read_text(path("two")), "o ");
  EXPECT_TRUE(empty);
  EXPECT_EQ(nowhere.exit_code, 2) << nowhere.error;
  EXPECT_NE(nowhere.error.find("FILE: no temporary file can be made"), std::string::npos) << nowhere.error;
}

TEST_F(ImportTest, TextOfInfoNamesAKindOfFaultOnce) {
  std::string text;
  const int count = 500;
  for (int k = 0; k < count + 2; ++k) text += "v " + std::to_string(k) + " " + std::to_string(k % 2) + " 0\n";
  for (int k = 1; k <= count; ++k)
    text += "f " + std::to_string(k) + " " + std::to_string(k + 1) + " " + std::to_string(k + 2) + "\n";
  write_text(path("strip.obj"), text);
  const Outcome told = run("info " + path("strip.obj"));
  EXPECT_EQ(told.exit_code, 1);
  std::size_t times = 0;
  for (std::size_t at = 0; (at = told.out.find("E_EDGE_NONMANIFOLD_OR_FLIPPED", at)) != std::string::npos;
       ++at)
    ++times;
  EXPECT_EQ(times, 1U) << told.out;
  EXPECT_NE(told.out.find("499 like this: edge 1-2, edge 2-3"), std::string::npos) << told.out;
}

/// Box of triangles as facets of an STL text, from its lowest corner, inside out where it is asked for.
std::string stl_box(const std::string& name, double x, double y, bool inside_out = false) {
  const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::string out = "solid " + name + "\n";
  for (const auto& quad : quads)
    for (const int first : {1, 2}) {
      const int corners[3] = {quad[0], quad[inside_out ? first + 1 : first],
                              quad[inside_out ? first : first + 1]};
      out += "facet normal 0 0 0 outer loop\n";
      for (const int v : corners)
        out += "vertex " + std::to_string(x + 10 * (v & 1)) + " " + std::to_string(y + 10 * (v >> 1 & 1)) +
               " " + std::to_string(10 * (v >> 2)) + "\n";
      out += "endloop endfacet\n";
    }
  return out + "endsolid " + name + "\n";
}

TEST_F(ImportTest, SolidsOfAnStlAreObjectsThoughTheyTouch) {
  write_text(path("two.stl"), stl_box("left", 0, 0) + stl_box("right", 10, 10));
  const Outcome told = succeed("info --json " + path("two.stl"));
  const Json objects = told.json()["objects"];
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0]["name"], "left");
  EXPECT_EQ(objects[1]["name"], "right");
  for (const Json& object : objects) EXPECT_EQ(object["boundary_loops"], 0);
  // One solid with both boxes: they stay two closed parts.
  std::string one = stl_box("one", 0, 0);
  const std::string other = stl_box("one", 10, 10);
  one.erase(one.find("endsolid"));
  write_text(path("one.stl"), one + other.substr(other.find('\n') + 1));
  const Json both = run("info --json " + path("one.stl")).object();
  EXPECT_EQ(both["boundary_loops"], 0) << both;
  EXPECT_EQ(codes_of(both).count("W_BODIES_APART"), 1U) << both;
}

TEST_F(ImportTest, ABodyThatIsInsideOutIsTurnedByTheRepair) {
  write_text(path("turned.stl"), stl_box("box", 0, 0, true));
  const Json given = run("info --json " + path("turned.stl")).object();
  EXPECT_EQ(codes_of(given).count("W_INSIDE_OUT"), 1U) << given;
  const Json repaired = run("info --json " + path("turned.stl") + " --repair").object();
  EXPECT_EQ(codes_of(repaired).count("W_INSIDE_OUT"), 0U) << repaired;
  EXPECT_EQ(codes_of(repaired).count("W_TURNED_OUTWARDS"), 1U) << repaired;
  // Commands that write a file say so as well.
  for (const std::string& job : {"export " + path("turned.stl") + " " + path("o.stl"),
                                 "unfold " + path("turned.stl") + " " + path("o.pdf")}) {
    EXPECT_NE(succeed(job).error.find("W_INSIDE_OUT"), std::string::npos) << job;
    EXPECT_EQ(succeed(job + " --repair").error.find("W_INSIDE_OUT"), std::string::npos) << job;
  }
}

/// A box with a cavity as OBJ, inside out where it is asked for.
std::string hollow_box(bool inside_out) {
  const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::string vertices, faces;
  for (const bool cavity : {false, true}) {
    for (int k = 0; k < 8; ++k)
      for (int axis = 0; axis < 3; ++axis)
        vertices += (axis == 0 ? "\nv " : " ") +
                    std::to_string((cavity ? 10 : 0) + (cavity ? 10 : 30) * (k >> axis & 1));
    for (const auto& quad : quads) {
      faces += "\nf";
      for (int k = 0; k < 4; ++k)
        faces += " " + std::to_string((cavity ? 9 : 1) + quad[cavity != inside_out ? 3 - k : k]);
    }
  }
  return vertices + faces + "\n";
}

TEST_F(ImportTest, ACavityTurnsWithItsBody) {
  write_text(path("whole.obj"), hollow_box(false));
  write_text(path("turned.obj"), hollow_box(true));
  const double volume = run("info --json " + path("whole.obj")).object()["volume"].get<double>();
  EXPECT_GT(volume, 0);
  EXPECT_LT(run("info --json " + path("turned.obj")).object()["volume"].get<double>(), 0);
  const Json repaired = run("info --json --repair " + path("turned.obj")).object();
  EXPECT_NEAR(repaired["volume"].get<double>(), volume, 1e-9 * volume);
  EXPECT_EQ(codes_of(repaired), std::set<std::string>{"W_TURNED_OUTWARDS"}) << repaired;
}

TEST_F(ImportTest, ABodyBesideABrokenOneIsTurnedByTheRepairToo) {
  std::string broken = stl_box("broken", 30, 0);
  broken.insert(broken.find("endsolid"),
                "facet normal 0 0 0 outer loop\nvertex 30 0 0\nvertex 40 0 0\nvertex 35 -10 -10\nendloop "
                "endfacet\n");  // a third face at an edge
  write_text(path("two.stl"), stl_box("turned", 0, 0, true) + broken);
  EXPECT_EQ(run("info " + path("two.stl")).exit_code, 1);
  const Outcome told = succeed("info --json --repair " + path("two.stl"));
  EXPECT_NE(told.error.find("faces turned: 12"), std::string::npos) << told.error;
  const Json objects = told.json()["objects"];
  ASSERT_EQ(objects.size(), 2U);
  for (const Json& object : objects) EXPECT_EQ(codes_of(object).count("W_INSIDE_OUT"), 0U) << object;
  EXPECT_GT(objects[0]["volume"].get<double>(), 0);
}

TEST_F(ImportTest, AFileOfAnotherFormatIsNamed) {
  write_text(path("mesh.stl"), loose_cube(0));
  const Outcome told = run("info " + path("mesh.stl"));
  EXPECT_EQ(told.exit_code, 1);
  EXPECT_NE((told.out + told.error).find("The file holds OBJ"), std::string::npos) << told.out << told.error;
}

}  // namespace
}  // namespace hariko::test

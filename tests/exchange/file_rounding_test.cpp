// Digits of files: a promised distance holds for the numbers as they are written.

#include "core/exchange/file_rounding.hpp"

#include "core/exchange/mesh_file.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

/// A tetrahedron with legs of this length at a place that is no float.
TriangleMesh corner(const Vector3& origin, double leg) {
  TriangleMesh out;
  out.origin = origin;
  out.positions = {{0, 0, 0}, {leg, 0, 0}, {0, leg, 0}, {0, 0, leg}};
  out.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return out;
}

/// The farthest that a corner of the file lies from where it should.
double farthest(const ImportedMesh& file, const TriangleMesh& mesh, const Vector3& moved) {
  double out = 0;
  for (const Vector3& p : file.mesh.positions) {
    double nearest = 1e300;
    for (const Vector3& q : mesh.positions) nearest = std::min(nearest, (mesh.origin - moved + q - p).norm());
    out = std::max(out, nearest);
  }
  return out;
}

TEST(FileRounding, WhatIsReportedIsTrueOfTheFile) {
  const test::TemporaryFolder folder;
  for (const double scale : {1e-3, 1.0, 1e6})
    for (const double away : {0.0, 3.3, 321.1})
      for (const MeshEncoding encoding : {MeshEncoding::binary, MeshEncoding::ascii})
        for (const char* name : {"a.stl", "a.obj", "a.glb", "a.ply"}) {
          SCOPED_TRACE(std::string(name) + " " + std::to_string(scale) + " " + std::to_string(away));
          const TriangleMesh mesh = corner(scale * away * Vector3(1, -1, 0.3), scale * 0.7);
          const NamedTriangles named{"a", &mesh};
          const auto written =
              test::must(write_mesh_file(folder.path() / name, std::span(&named, 1), {.encoding = encoding}));
          const double said = written->rounding.at(0).distance;
          auto file = test::must(read_mesh_file(folder.path() / name));
          const double is = farthest(*file, mesh, Vector3::Zero());
          // Text is read as doubles, which may be nearer than the floats that it stands for.
          EXPECT_LE(is, said * 1.001 + 1e-15 * scale * (1 + away));
          if (encoding == MeshEncoding::binary) EXPECT_GE(is, said * 0.999 - 1e-15 * scale * (1 + away));
          if (std::string(name) == "a.obj" || std::string(name) == "a.ply") EXPECT_EQ(said, 0);
          const Eigen::AlignedBox3d box(mesh.origin, Vector3(mesh.origin + Vector3::Constant(0.7 * scale)));
          EXPECT_LE(said, largest_rounding(box, file_numbers(folder.path() / name, {})));
        }
}

TEST(FileRounding, WhatRuinsAShapeIsAnErrorWithTheWayOut) {
  const test::TemporaryFolder folder;
  for (const Vector3& place : {Vector3(500000.123, 5123456.789, 0), Vector3(1e9, -1e9, 1e9)}) {
    const TriangleMesh mesh = corner(place, 10);
    const NamedTriangles named{"cube", &mesh};
    const auto file = folder.path() / "a.stl";
    test::spill(file, "old");
    const auto refused = write_mesh_file(file, std::span(&named, 1));
    test::must_fail(refused, e_file_digits);
    EXPECT_NE(refused.error().text.find("cube"), std::string::npos);
    EXPECT_NE(refused.error().remedy.find("--origin zero"), std::string::npos);
    EXPECT_EQ(test::slurp(file), "old");
    // Other formats hold it, and so does STL at zero.
    for (const char* name : {"a.obj", "a.ply", "a.off", "a.glb", "a.3mf"})
      EXPECT_TRUE(write_mesh_file(folder.path() / name, std::span(&named, 1)).ok()) << name;
    const auto moved = test::must(write_mesh_file(file, std::span(&named, 1), {.to_zero = true}));
    EXPECT_TRUE(moved->moved.isApprox(place + Vector3::Constant(5), 1e-15));
    const auto read = test::must(read_mesh_file(file));
    EXPECT_LT(farthest(*read, mesh, moved->moved), 1e-6);
  }
}

TEST(FileRounding, NumbersBeyondAllDoublesAreRefused) {
  const test::TemporaryFolder folder;
  const TriangleMesh mesh = corner(Vector3::Zero(), 10);
  const NamedTriangles named{"cube", &mesh};
  for (const char* name : {"a.obj", "a.ply", "a.off", "a.3mf"}) {
    const auto file = folder.path() / name;
    EXPECT_TRUE(write_mesh_file(file, std::span(&named, 1), {.factor = 1e300}).ok()) << name;
    std::filesystem::remove(file);
    test::must_fail(write_mesh_file(file, std::span(&named, 1), {.factor = 1e308}), e_limit);
    EXPECT_FALSE(std::filesystem::exists(file)) << name;
  }
}

TEST(FileRounding, APromisedDistanceDecides) {
  const test::TemporaryFolder folder;
  const TriangleMesh mesh = corner({4000.3, 0, 0}, 10);  // floats are 2.4e-4 apart there
  NamedTriangles named{"a", &mesh, usual_mesh_colour, 1e-3};
  EXPECT_TRUE(write_mesh_file(folder.path() / "a.stl", std::span(&named, 1)).ok());
  named.most_rounding = 1e-7;
  test::must_fail(write_mesh_file(folder.path() / "a.stl", std::span(&named, 1)), e_file_digits);
  EXPECT_TRUE(write_mesh_file(folder.path() / "a.obj", std::span(&named, 1)).ok());
  // Without a promise, coarse coordinates are told.
  named.most_rounding.reset();
  const auto told = test::must(write_mesh_file(folder.path() / "a.stl", std::span(&named, 1)));
  ASSERT_EQ(told->warnings.size(), 1U);
  EXPECT_EQ(told->warnings[0].code, w_file_digits);
}

TEST(FileRounding, APromisedAngleDecides) {
  const test::TemporaryFolder folder;
  // Facets of 10 whose corners move by 1e-4: they turn by about 1e-5.
  TriangleMesh mesh = corner({4000.3, 4000.7, 4000.1}, 10);
  mesh.positions = {{0, 0, 0}, {10.123, 0.37, 0.51}, {0.21, 9.87, 0.33}, {0.77, 0.11, 10.3}};
  const double turn = rounding_of(mesh, {FileNumbers::Kind::floats, 1}).turn;
  ASSERT_GT(turn, 1e-7);
  ASSERT_LT(turn, 1e-3);
  NamedTriangles named{"a", &mesh, usual_mesh_colour, 1e-2, 2 * turn};
  EXPECT_TRUE(write_mesh_file(folder.path() / "a.stl", std::span(&named, 1)).ok());
  named.most_turn = 0.5 * turn;
  const auto refused = write_mesh_file(folder.path() / "b.stl", std::span(&named, 1));
  test::must_fail(refused, e_file_digits);
  EXPECT_NE(refused.error().text.find("degrees"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "b.stl"));
  EXPECT_TRUE(write_mesh_file(folder.path() / "b.obj", std::span(&named, 1)).ok());
  EXPECT_TRUE(write_mesh_file(folder.path() / "b.stl", std::span(&named, 1), {.to_zero = true}).ok());
}

TEST(FileRounding, FacetsThatAreTooSmallAreLeftOutWithACountAndNoHole) {
  const test::TemporaryFolder folder;
  // Round an edge of 1e-8 in one of the sides, whose ends become the same float.
  TriangleMesh mesh = corner(Vector3::Zero(), 1);
  mesh.positions.push_back({0.25, 0.25, 0});
  mesh.positions.push_back({0.25 + 1e-8, 0.25, 0});
  mesh.triangles = {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 2, 4}, {2, 1, 5}, {1, 0, 4}, {2, 5, 4}, {1, 4, 5}};
  const NamedTriangles named{"a", &mesh};
  const auto written = test::must(write_mesh_file(folder.path() / "a.stl", std::span(&named, 1)));
  EXPECT_EQ(written->rounding[0].collapsed, 2U);
  EXPECT_EQ(written->rounding[0].left_out, 2U);
  ASSERT_EQ(written->warnings.size(), 1U);
  EXPECT_NE(written->warnings[0].text.find("2 facets"), std::string::npos) << written->warnings[0].text;
  const auto read = test::must(read_mesh_file(folder.path() / "a.stl"));
  EXPECT_EQ(read->mesh.face_count(), 6U);
  EXPECT_TRUE(validate(read->mesh).empty());
}

}  // namespace
}  // namespace hariko

// 3MF files, as lib3mf reads them: an independent reader, and a strict one.

#include "core/exchange/write_mesh.hpp"
#include "tests/exchange/lib3mf_reader.hpp"
#include "tests/exchange/mesh_text.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

using test::for_random;

using namespace test::lib3mf;

FoundFile read_by_lib3mf(const std::string& bytes) {
  const test::TemporaryFolder folder;
  test::spill(folder.path() / "a.3mf", bytes);
  return test::lib3mf::read_file(folder.path() / "a.3mf");
}

TriangleMesh triangles_of(const PolygonMesh& polygons, const Vector3& origin) {
  TriangleMesh mesh;
  mesh.origin = origin;
  mesh.positions = polygons.positions;
  for (std::size_t f = 0; f < polygons.face_count(); ++f) {
    const auto face = polygons.face(f);
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      mesh.triangles.push_back({face[0], face[k], face[k + 1]});
  }
  return mesh;
}

TEST(Write3mf, AnotherReaderFindsTheSame) {
  for_random(51, 10, [](std::mt19937_64& rng) {
    const auto torus = [&] {
      return triangles_of(test::torus(test::uniform_int(rng, 3, 8), test::uniform_int(rng, 3, 8)),
                          100 * test::random_vector(rng));
    };
    const TriangleMesh first = torus();
    TriangleMesh second = torus();
    second.triangles.pop_back();  // a hole
    const std::vector<NamedTriangles> named{{"張り子 <\"a\" & b>", &first, {255, 0, 128}}, {"b", &second}};
    const auto bytes = test::must(write_3mf(named, 0.0254));
    EXPECT_EQ(*write_3mf(named, 0.0254), *bytes);
    const FoundFile found = read_by_lib3mf(*bytes);
    EXPECT_EQ(found.unit, DWORD(NMR::MODELUNIT_INCH));
    ASSERT_EQ(found.objects.size(), 2u);
    EXPECT_EQ(found.objects[0].name, named[0].name);
    EXPECT_TRUE(found.objects[0].model && found.objects[0].valid && found.objects[0].closed);
    EXPECT_FALSE(found.objects[1].model || found.objects[1].closed);
    for (std::size_t k = 0; k < 2; ++k) {
      const TriangleMesh& mesh = *named[k].mesh;
      EXPECT_EQ(found.objects[k].triangles, mesh.triangles);
      ASSERT_EQ(found.objects[k].positions.size(), mesh.positions.size());
      for (std::size_t v = 0; v < mesh.positions.size(); ++v)  // the reader keeps floats
        EXPECT_LT((found.objects[k].positions[v] - mesh.origin - mesh.positions[v]).norm(),
                  1e-6 * (1 + mesh.origin.norm()));
    }
  });
}

TEST(Write3mf, UnitsOfTheFormatAreKeptAndOthersAreMillimetres) {
  const TriangleMesh mesh = triangles_of(test::torus(5, 4), Vector3::Zero());
  const NamedTriangles named[] = {{"a", &mesh}};
  const double size = mesh.positions.front().norm();
  const auto found = [&](double metres) {
    const FoundFile file = read_by_lib3mf(*write_3mf(named, metres));
    return std::pair(file.unit, file.objects.front().positions.front().norm() / size);
  };
  EXPECT_EQ(found(1e-3).first, DWORD(NMR::MODELUNIT_MILLIMETER));
  EXPECT_EQ(found(1e-2).first, DWORD(NMR::MODELUNIT_CENTIMETER));
  EXPECT_EQ(found(1).first, DWORD(NMR::MODELUNIT_METER));
  EXPECT_NEAR(found(1).second, 1, 1e-6);
  EXPECT_EQ(found(0.5).first, DWORD(NMR::MODELUNIT_MILLIMETER));
  EXPECT_NEAR(found(0.5).second, 500, 1e-3);
}

TEST(Write3mf, TrianglesWithoutAreaAndEmptyMeshesAreLeftOut) {
  TriangleMesh mesh = triangles_of(test::torus(5, 4), Vector3::Zero());
  const std::size_t count = mesh.triangles.size();
  mesh.triangles.push_back({1, 1, 2});
  const TriangleMesh empty;
  const NamedTriangles named[] = {{"a", &mesh}, {"b", &empty}};
  const FoundFile found = read_by_lib3mf(*write_3mf(named, 1e-3));
  ASSERT_EQ(found.objects.size(), 1u);
  EXPECT_EQ(found.objects[0].triangles.size(), count);
  EXPECT_TRUE(found.objects[0].closed);
}

}  // namespace
}  // namespace hariko

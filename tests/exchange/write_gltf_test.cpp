// glTF files, as assimp reads them: an independent reader.

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <cstring>
#include <functional>

#include "core/exchange/triangles/read_off.hpp"
#include "core/exchange/write_mesh.hpp"
#include "tests/exchange/gltf_text.hpp"
#include "tests/exchange/mesh_text.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

using test::for_random;

/// Contents of a file: absolute positions in metres, y up.
struct Found {
  std::string name;
  std::vector<Vector3> positions, normals;
  std::vector<std::array<Index, 3>> triangles;
  Vector3 colour;
};

std::vector<Found> read_by_assimp(const std::string& bytes, const char* form = "glb") {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, form);
  std::vector<Found> out;
  EXPECT_TRUE(scene) << importer.GetErrorString();
  if (!scene) return out;
  const std::function<void(const aiNode&, const aiMatrix4x4&)> visit = [&](const aiNode& node,
                                                                           const aiMatrix4x4& above) {
    const aiMatrix4x4 place = above * node.mTransformation;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
      const aiMesh& mesh = *scene->mMeshes[node.mMeshes[m]];
      Found found;
      found.name = node.mName.C_Str();
      for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const aiVector3D p = place * mesh.mVertices[v];
        found.positions.emplace_back(p.x, p.y, p.z);
        if (mesh.HasNormals())
          found.normals.emplace_back(mesh.mNormals[v].x, mesh.mNormals[v].y, mesh.mNormals[v].z);
      }
      for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        EXPECT_EQ(mesh.mFaces[f].mNumIndices, 3u);
        const unsigned* i = mesh.mFaces[f].mIndices;
        found.triangles.push_back({i[0], i[1], i[2]});
      }
      aiColor4D colour;
      scene->mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_COLOR_DIFFUSE, colour);
      found.colour = {colour.r, colour.g, colour.b};
      out.push_back(std::move(found));
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c) visit(*node.mChildren[c], place);
  };
  visit(*scene->mRootNode, {});
  return out;
}

void expect_same(const std::vector<Found>& a, const std::vector<Found>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].name, b[k].name);
    EXPECT_EQ(a[k].positions, b[k].positions);
    EXPECT_EQ(a[k].normals, b[k].normals);
    EXPECT_EQ(a[k].triangles, b[k].triangles);
    EXPECT_EQ(a[k].colour, b[k].colour);
  }
}

double area_of(const std::vector<Vector3>& positions, const std::vector<std::array<Index, 3>>& triangles) {
  double area = 0;
  for (const auto& t : triangles)
    area += 0.5 * (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).norm();
  return area;
}

/// Triangles over a random polyhedron, with a normal a facet.
TriangleMesh faceted(std::mt19937_64& rng) {
  return test::faceted(test::torus(test::uniform_int(rng, 3, 8), test::uniform_int(rng, 3, 8)),
                       1e3 * test::random_vector(rng));
}

TEST(WriteGltf, TextHoldsTheSameAsTheBinaryForm) {
  for_random(37, 6, [](std::mt19937_64& rng) {
    const TriangleMesh first = faceted(rng), second = faceted(rng);
    const std::vector<NamedTriangles> named{{"a", &first}, {"b", &second}};
    for (const std::size_t count : {1U, 2U}) {
      const std::span<const NamedTriangles> some(named.data(), count);
      expect_same(read_by_assimp(*write_gltf(some, 0.001, GltfForm::text), "gltf"),
                  read_by_assimp(*write_gltf(some, 0.001)));
    }
  });
}

TEST(WriteGltf, AnotherReaderFindsTheSameInMetresAndYUp) {
  for_random(31, 20, [](std::mt19937_64& rng) {
    const TriangleMesh first = faceted(rng), second = faceted(rng);
    const std::vector<NamedTriangles> named{{"張り子 \"a\"", &first, {255, 0, 128}}, {"b", &second}};
    const auto bytes = test::must(write_gltf(named, 0.0254));
    const auto found = read_by_assimp(*bytes);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].name, named[0].name);
    EXPECT_NEAR(found[0].colour.x(), 1, 1e-6);
    EXPECT_NEAR(found[0].colour.y(), 0, 1e-6);
    EXPECT_NEAR(found[0].colour.z(), 0.21586, 1e-4);
    for (std::size_t k = 0; k < 2; ++k) {
      const TriangleMesh& mesh = *named[k].mesh;
      ASSERT_EQ(found[k].triangles.size(), mesh.triangles.size());
      ASSERT_EQ(found[k].normals.size(), found[k].positions.size());
      const double size = 0.0254 * mesh.origin.norm();
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c) {
          const Vector3 p = 0.0254 * (mesh.origin + mesh.positions[mesh.triangles[t][c]]);
          const Vector3 n = mesh.normals[mesh.normal_triangles[t][c]];
          const Index v = found[k].triangles[t][c];
          EXPECT_LT((found[k].positions[v] - Vector3(p.x(), p.z(), -p.y())).norm(), 1e-6 * size);
          EXPECT_LT((found[k].normals[v] - Vector3(n.x(), n.z(), -n.y())).norm(), 1e-6);
        }
    }
  });
}

TEST(WriteGltf, PolygonsAreTriangulated) {
  const PolygonMesh cube = test::cube();
  const std::vector<NamedPolygons> named{{"cube", &cube}};
  const auto bytes = test::must(write_gltf(named, 1));
  const auto found = read_by_assimp(*bytes);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].triangles.size(), 12u);
  const double edge = (cube.positions[cube.face(0)[1]] - cube.positions[cube.face(0)[0]]).norm();
  EXPECT_NEAR(area_of(found[0].positions, found[0].triangles), 6 * edge * edge, 1e-5 * edge * edge);
}

TEST(WriteGltf, ChunksAreWholeAndLimitsAreSaid) {
  std::mt19937_64 rng(5);
  const TriangleMesh mesh = faceted(rng);
  const std::vector<NamedTriangles> named{{"a", &mesh}};
  const std::string bytes = *write_gltf(named, 1);
  const auto word = [&](std::size_t at) {
    std::uint32_t out = 0;
    std::memcpy(&out, bytes.data() + at, 4);
    return out;
  };
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(8), bytes.size());
  EXPECT_EQ(word(12) % 4, 0u);
  EXPECT_EQ(20 + word(12) + 8 + word(20 + word(12)), bytes.size());

  EXPECT_TRUE(write_gltf(std::span<const NamedTriangles>(), 1).ok());
  TriangleMesh huge = mesh;
  for (Vector3& p : huge.positions) p *= 1e200;
  const std::vector<NamedTriangles> large{{"a", &huge}};
  EXPECT_EQ(write_gltf(large, 1).error().code, e_limit);
}

TEST(WriteOff, ComesBackExactly) {
  for_random(32, 20, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = test::torus(test::uniform_int(rng, 3, 8), test::uniform_int(rng, 3, 8));
    const std::vector<NamedPolygons> named{{"a", &mesh}};
    const auto back = test::must(read_off(write_off(named)));
    test::expect_same(back->mesh, mesh);
  });
}

}  // namespace
}  // namespace hariko

// Surfaces of every producer in every format of triangles, and back through readers of others: assimp, and
// lib3mf for 3MF. All samples in all modes in long runs, which print a table. (For STEP and IGES see
// tests/cad.)

#include <assimp/scene.h>
#include <Eigen/Geometry>
#include <assimp/Importer.hpp>
#include <cstdio>
#include <functional>
#include <map>
#include <string_view>
#include <utility>

#include "core/exchange/mesh_file.hpp"
#include "core/surface/tessellation.hpp"
#include "tests/cad/producers.hpp"
#include "tests/exchange/lib3mf_reader.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko::test {
namespace {

namespace fs = std::filesystem;
using Triangle = std::array<Vector3, 3>;
using Soup = std::vector<Triangle>;

Soup soup_of(const TriangleMesh& mesh) {
  Soup out;
  for (const auto& t : mesh.triangles)
    out.push_back({mesh.origin + mesh.positions[t[0]], mesh.origin + mesh.positions[t[1]],
                   mesh.origin + mesh.positions[t[2]]});
  return out;
}

Soup by_assimp(const fs::path& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  Soup out;
  EXPECT_TRUE(scene) << importer.GetErrorString();
  if (!scene) return out;
  const std::function<void(const aiNode&, const aiMatrix4x4&)> visit = [&](const aiNode& node,
                                                                           const aiMatrix4x4& above) {
    const aiMatrix4x4 place = above * node.mTransformation;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
      const aiMesh& mesh = *scene->mMeshes[node.mMeshes[m]];
      for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        if (mesh.mFaces[f].mNumIndices != 3) {
          ADD_FAILURE() << "a face of " << mesh.mFaces[f].mNumIndices << " corners";
          return;
        }
        Triangle triangle;
        for (unsigned k = 0; k < 3; ++k) {
          const aiVector3D p = place * mesh.mVertices[mesh.mFaces[f].mIndices[k]];
          triangle[k] = {p.x, p.y, p.z};
        }
        out.push_back(triangle);
      }
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c) visit(*node.mChildren[c], place);
  };
  visit(*scene->mRootNode, {});
  return out;
}

Soup by_lib3mf(const fs::path& path) {
  Soup out;
  for (const lib3mf::Found& object : lib3mf::read_file(path).objects)
    for (const auto& t : object.triangles)
      out.push_back({object.positions[t[0]], object.positions[t[1]], object.positions[t[2]]});
  return out;
}

/// In millimetres with z up.
Soup read_by_others(const fs::path& path) {
  if (path.extension() == ".3mf") return by_lib3mf(path);
  Soup out = by_assimp(path);
  if (path.extension() == ".glb" || path.extension() == ".gltf")
    for (Triangle& triangle : out)
      for (Vector3& p : triangle) p = 1000 * Vector3(p.x(), -p.z(), p.y());
  return out;
}

struct SoupMeasures {
  Eigen::AlignedBox3d box;
  double area = 0, volume = 0;
  std::size_t open_edges = 0;
};

SoupMeasures measures_of(const Soup& soup) {
  SoupMeasures out;
  for (const Triangle& t : soup)
    for (const Vector3& p : t) out.box.extend(p);
  const Vector3 centre = out.box.center();
  std::map<std::array<double, 3>, int> numbers;
  std::map<std::pair<int, int>, int> balance;
  const auto number = [&](const Vector3& p) {
    return numbers.try_emplace({p.x(), p.y(), p.z()}, int(numbers.size())).first->second;
  };
  for (const Triangle& t : soup) {
    const Vector3 a = t[0] - centre, b = t[1] - centre, c = t[2] - centre;
    out.area += 0.5 * (b - a).cross(c - a).norm();
    out.volume += a.dot(b.cross(c)) / 6;
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = number(t[k]), to = number(t[(k + 1) % 3]);
      balance[std::minmax(from, to)] += from < to ? 1 : from > to ? -1 : 0;
    }
  }
  for (const auto& [edge, count] : balance) out.open_edges += count != 0;
  return out;
}

struct Form {
  const char* name;
  const char* ending;
  MeshEncoding encoding = MeshEncoding::binary;
};
constexpr Form forms[] = {{"obj", ".obj"},  {"off", ".off"},
                          {"ply", ".ply"},  {"ply, text", ".ply", MeshEncoding::ascii},
                          {"stl", ".stl"},  {"stl, text", ".stl", MeshEncoding::ascii},
                          {"3mf", ".3mf"},  {"glb", ".glb"},
                          {"gltf", ".gltf"}};

/// Whether the data of a binary PLY file begin with a line break. assimp 5.2 takes such a byte for part of
/// the header's end and reads all numbers a byte too late.
bool begins_with_line_break(const fs::path& path) {
  if (path.extension() != ".ply") return false;
  const std::string text = slurp(path);
  const std::string end = "end_header\n";
  const std::size_t data = text.find(end) + end.size();
  return text.find("binary") < data && data < text.size() && (text[data] == '\n' || text[data] == '\r');
}

void check(const Surface& surface, const std::string& name) {
  const TriangleMesh mesh = tessellate(surface, 5);
  const SoupMeasures want = measures_of(soup_of(mesh));
  const bool closed = surface.boundary_sides().empty();
  EXPECT_EQ(want.open_edges == 0, closed);
  // Other readers keep floats.
  const double size = want.box.diagonal().norm(), reach = size + want.box.center().norm();
  const double rounding = 1e-6 * reach, relative = 20 * rounding / size;
  const NamedTriangles named[] = {{"part", &mesh}};
  const TemporaryFolder folder;
  for (const auto& [form, ending, encoding] : forms) {
    SCOPED_TRACE(form);
    const fs::path path = folder.path() / (std::string("a") + ending);
    WriteOptions options;
    options.encoding = encoding;
    ASSERT_TRUE(write_mesh_file(path, named, options).ok());
    if (begins_with_line_break(path)) continue;
    const Soup soup = read_by_others(path);
    if (std::string_view(ending) != ".3mf") {  // 3MF has no triangles without area
      EXPECT_EQ(soup.size(), mesh.triangles.size());
    }
    const SoupMeasures found = measures_of(soup);
    EXPECT_LT((found.box.min() - want.box.min()).norm(), rounding);
    EXPECT_LT((found.box.max() - want.box.max()).norm(), rounding);
    EXPECT_NEAR(found.area, want.area, relative * want.area);
    if (closed) {
      EXPECT_EQ(found.open_edges, 0U);
      EXPECT_NEAR(found.volume, want.volume, relative * want.area * size);
    }
    if (repetitions(1) < 2) continue;
    std::printf("| %s | %s | %zu | %ju | %.1e | %.1e | %zu |\n", name.c_str(), form, soup.size(),
                std::uintmax_t(fs::file_size(path)), std::abs(found.area / want.area - 1),
                closed ? std::abs(found.volume / want.volume - 1) : 0.0, found.open_edges);
  }
}

TEST(MeshFormats, OthersReadTheSameSurface) {
  if (repetitions(1) > 1)
    std::printf(
        "| object | format | triangles | bytes | area off | volume off | open edges |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n");
  for_named([](const std::string& name, const Surface& surface) { check(surface, name); });
}

}  // namespace
}  // namespace hariko::test

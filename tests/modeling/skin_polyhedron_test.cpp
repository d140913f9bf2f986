#include "core/modeling/surfacing/skin_polyhedron.hpp"

#include <algorithm>
#include <cstdio>

#include "core/base/files/file_io.hpp"
#include "core/document/format/read_skin.hpp"
#include "core/modeling/surfacing/surface_input.hpp"
#include "core/skinning/evaluate_skin.hpp"
#include "tests/support/must.hpp"
#include "tests/support/places.hpp"

namespace hariko {
namespace {

Skin input(const std::string& name) {
  const auto text = read_file(test::source_folder() + "/tests/skinning/data/" + name + ".json", 1 << 24);
  EXPECT_TRUE(text.ok());
  return read_skin_layout(*text).value();
}

TEST(SkinPolyhedron, GoesThroughTheSurfaceWithItsTangentPlanes) {
  // Larger ones only by name: their surfaces take longer.
  for (const char* name : {"fig9_interior", "tube", "sharp3"}) {
    SCOPED_TRACE(name);
    const Skin skin = input(name);
    const auto made = test::must(skin_polyhedron(skin));
    const auto surface = test::must(SkinSurfacer().surface(skin, Vector3::Zero()));
    const SubdivisionPatchSet& patches = *subdivision_patches(surface->surface);
    const ControlMesh& control = surface->result.mesh.control;
    const Polyhedron& polyhedron = made->source.polyhedron;
    ASSERT_EQ(polyhedron.vertex_count(), control.mesh.positions.size());
    EXPECT_EQ(polyhedron.face_count(), control.mesh.face_count());
    double size = 0;
    for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
      const Vector3 p = made->source.origin + polyhedron.position(polyhedron.find(VertexId{v}));
      EXPECT_LT((p - patches.limit_position(v)).norm(), 1e-12);
      size = std::max(size, p.norm());
    }
    const auto sharp = std::count_if(control.creases.begin(), control.creases.end(),
                                     [](const auto& crease) { return crease.sharpness >= infinitely_sharp; });
    EXPECT_EQ(made->source.shaping->crease.size(), std::size_t(sharp));
    EXPECT_GT(made->source.shaping->pin.size(), polyhedron.vertex_count() / 3);
    // The surface of the polyhedron keeps the planes, and the distance that is told is small and not zero.
    const auto built = test::must(PolyhedronSurfacer().rebuild(*surface_input(made->source)));
    // Corner 1 of the patch of a half-edge is its vertex.
    const HalfEdgeMesh& mesh = polyhedron.topology();
    for (Index h = 0; h < mesh.half_edge_count(); ++h) {
      const Pin* pin = made->source.shaping->pin.find(polyhedron.vertex_id(mesh.origin(h)));
      if (!pin) continue;
      const Vector3 n = built->surface.normal(h, corner_parameter(Domain::triangle, 1));
      EXPECT_GT(n.dot(pin->vectors.at(0)), 1 - 1e-9);
    }
    EXPECT_GT(made->distance, 0);
    EXPECT_LT(made->distance, 0.03 * size);
    std::printf("%s: %.2e of %.2g\n", name, made->distance, size);
  }
}

TEST(SkinPolyhedron, ABrokenSkinSaysWhy) {
  Skin skin = input("fig6a");
  skin.sections.pop_back();
  const auto made = skin_polyhedron(skin);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(std::string(made.error().code.name), "E_FEW_SECTIONS");
}

}  // namespace
}  // namespace hariko

// Milliseconds a frame of 1280 x 800 pixels, by look. With a software driver this is its fill rate, above
// all.

#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <string>
#include <vector>

#include "bench/models.hpp"
#include "core/analysis/combs.hpp"
#include "core/analysis/continuity.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "render/offscreen.hpp"
#include "render/renderer.hpp"
#include "render/surface_maps.hpp"

namespace hariko {
namespace {

struct Look {
  const char* name;
  SurfaceMap map = SurfaceMap::shaded;
  Material material = Material::clay;
  PatchWire wire = PatchWire::none;
  bool section = false, marks = false, combs = false, network = false;
};

void draw(benchmark::State& state, const Look& look) {
  auto context = OffscreenContext::create();
  auto made = Renderer::create();
  if (!context || !made) return state.SkipWithError("no OpenGL");
  Renderer renderer = std::move(made).value();
  const auto built = PolyhedronSurfacer().rebuild({bench_torus(1000), {}});
  const Surface& surface = built->surface;
  SceneObject object;
  object.mesh = DisplayMesh::build(surface, map_options(look.map, display_density(surface.patch_count())));
  object.map = look.map;
  object.range = {-1, 1};
  object.material = look.material;
  object.wire = look.wire;
  object.show_network = look.network;
  if (look.combs) object.combs = comb_lines(curvature_combs(surface, 24), surface.origin());
  if (look.marks) object.marks = edge_marks(*object.mesh, classify(surface, continuity(surface), {}));
  Scene scene;
  scene.objects.push_back(object);
  if (look.section) scene.section = SectionPlane{Vector3::UnitX(), 0.1};
  const PixelSize size{1280, 800};
  const Camera camera = framed(Camera::standard(StandardView::iso), scene, size);
  // A section that moves: its curve is cut anew in each frame.
  double step = 0;
  for (auto _ : state) {
    if (scene.section) scene.section->offset = 0.1 + 1e-4 * ++step;
    if (!renderer.draw(scene, camera, {size, 1})) return state.SkipWithError("not drawn");
    glFinish();
  }
}

const bool registered = [] {
  static const std::vector<Look> looks{
      {"clay"},
      {"porcelain", SurfaceMap::shaded, Material::porcelain},
      {"metal", SurfaceMap::shaded, Material::metal},
      {"wax", SurfaceMap::shaded, Material::wax},
      {"rubber", SurfaceMap::shaded, Material::rubber},
      {"plastic", SurfaceMap::shaded, Material::plastic},
      {"zebra", SurfaceMap::zebra},
      {"isophotes", SurfaceMap::isophotes},
      {"gauss", SurfaceMap::gaussian},
      {"clay+mesh_lines", SurfaceMap::shaded, Material::clay, PatchWire::mesh},
      {"clay+borders", SurfaceMap::shaded, Material::clay, PatchWire::borders},
      {"clay+network", SurfaceMap::shaded, Material::clay, PatchWire::none, false, false, false, true},
      {"clay+moving_section", SurfaceMap::shaded, Material::clay, PatchWire::none, true},
      {"clay+marks", SurfaceMap::shaded, Material::clay, PatchWire::none, false, true},
      {"clay+combs", SurfaceMap::shaded, Material::clay, PatchWire::none, false, false, true},
  };
  for (const Look& look : looks)
    benchmark::RegisterBenchmark((std::string("frame/") + look.name).c_str(), [&look](
                                                                                  benchmark::State& state) {
      draw(state, look);
    })->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace hariko

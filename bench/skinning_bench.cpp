// Skins: what one dragged point costs, on one core.

#include <benchmark/benchmark.h>

#include <cmath>

#include "core/base/files/file_io.hpp"
#include "core/base/parallel.hpp"
#include "core/document/format/read_skin.hpp"
#include "core/skinning/columns/column_parameters.hpp"
#include "core/skinning/evaluate_skin.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {
namespace {

Skin input(const std::string& name) {
  return *read_skin_layout(
      *read_file(std::string(HARIKO_SOURCE_DIR) + "/tests/skinning/data/" + name + ".json"));
}

/// Fifty sections of forty points each, with a few points fewer on every other one.
Skin large() {
  Skin skin;
  for (int i = 0; i < 100; ++i) skin.path.points.push_back(Vector3(i, 0, 0));
  std::uint32_t id = 0;
  for (int k = 0; k < 50; ++k) {
    SkinSection section;
    section.id = std::uint32_t(k);
    section.v = k / 49.0;
    const int n = 40 - 2 * (k % 2);
    for (int i = 0; i < n; ++i) {
      const double angle = 3.14159265 * i / (n - 1), r = 20 + 0.1 * k;
      section.points.push_back(
          {id++, Vector3(99.0 * section.v, r * std::cos(angle), r * std::sin(angle)), false});
    }
    skin.sections.push_back(section);
  }
  return skin;
}

/// The whole way from a moved point to preview triangles: 2 subdivisions a face. The first rebuilding, which
/// makes the topology, is not counted. `moving`: in the middle of a drag, as the window asks for it.
void drag(benchmark::State& state, Skin skin, bool moving = true) {
  const ParallelLimit one(1);
  SkinSurfacer surfacer;
  SkinWork work;
  benchmark::DoNotOptimize(surfacer.surface(skin, Vector3::Zero(), work));
  work.moving = moving;
  std::size_t triangles = 0;
  for (auto _ : state) {
    skin.sections[skin.sections.size() / 2].points[2].position.z() += 1e-4;
    const auto made = surfacer.surface(skin, Vector3::Zero(), work);
    const bool cut = subdivision_patches(made->surface)->topology().cut();
    triangles = tessellate(made->surface, cut ? 2 : 4).triangles.size();
    benchmark::DoNotOptimize(triangles);
  }
  state.counters["triangles"] = double(triangles);
}

void skin_drag_car_pleat(benchmark::State& state) {
  drag(state, input("car_edited"));
}
Skin smooth(Skin skin, ColumnParameters parameters) {
  skin.method = SkinMethod::smooth;
  skin.smooth.parameters = parameters;
  return skin;
}
void skin_drag_car_smooth(benchmark::State& state) {
  drag(state, smooth(input("car_edited"), ColumnParameters::uniform));
}
/// Columns were placed; in the drag they stay.
void skin_drag_car_placed_columns(benchmark::State& state) {
  drag(state, smooth(input("car_edited"), ColumnParameters::per_section));
}
/// The end of the drag: those of the section that moved are placed anew.
void skin_release_car_placed_columns(benchmark::State& state) {
  drag(state, smooth(input("car_edited"), ColumnParameters::per_section), false);
}
void skin_drag_fifty_sections(benchmark::State& state) {
  drag(state, large());
}
void skin_drag_fifty_sections_smooth(benchmark::State& state) {
  drag(state, smooth(large(), ColumnParameters::uniform));
}
void skin_drag_fifty_sections_placed_columns(benchmark::State& state) {
  drag(state, smooth(large(), ColumnParameters::per_section));
}
void skin_new_topology_car(benchmark::State& state) {
  const ParallelLimit one(1);
  const Skin skin = input("car_edited");
  for (auto _ : state) benchmark::DoNotOptimize(SkinSurfacer().surface(skin, Vector3::Zero()));
}
void skin_optimise_parameters(benchmark::State& state) {
  const Skin skin = input("fig5");
  for (auto _ : state)
    benchmark::DoNotOptimize(optimised_parameters({skin.sections[0].curve()}, int(state.range(0))));
}

BENCHMARK(skin_drag_car_pleat)->Unit(benchmark::kMillisecond);
BENCHMARK(skin_drag_car_smooth)->Unit(benchmark::kMillisecond);
BENCHMARK(skin_drag_car_placed_columns)->Unit(benchmark::kMillisecond);
BENCHMARK(skin_release_car_placed_columns)->Unit(benchmark::kMillisecond);
BENCHMARK(skin_drag_fifty_sections)->Unit(benchmark::kMillisecond);
BENCHMARK(skin_drag_fifty_sections_smooth)->Unit(benchmark::kMillisecond);
BENCHMARK(skin_drag_fifty_sections_placed_columns)->Unit(benchmark::kMillisecond);
BENCHMARK(skin_new_topology_car)->Unit(benchmark::kMillisecond);
BENCHMARK(skin_optimise_parameters)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hariko

// Meshes under a tolerance: time by the number of facets, from ten thousand to a million.

#include <benchmark/benchmark.h>

#include "core/approximation/approximate.hpp"
#include "core/surface/weld_patches.hpp"

namespace {

using namespace hariko;

/// One bicubic patch like a car's fender, and one with inflections.
Surface patch_surface(bool inflected) {
  BezierPatch patch;
  const double height[2][4][4] = {
      {{0, 0.9, 1, 0.2}, {1.4, 2.4, 2.3, 1.2}, {1.6, 2.6, 2.4, 1.3}, {0.2, 1, 1.1, 0.1}},
      {{0, 0.4, 0.4, 0}, {2.2, 2.6, 2.6, 2.2}, {-1.6, -1.2, -1.2, -1.6}, {0, 0.4, 0.4, 0}}};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) patch.points.emplace_back(i, j, height[inflected][i][j]);
  return weld_patches(Vector3::Zero(), {patch}).value();
}

void bisection(benchmark::State& state) {
  const Surface surface = patch_surface(state.range(0) != 0);
  MeshOptions options;
  // The number of facets is inversely proportional to the tolerance.
  options.criteria.distance = 6.0 / double(state.range(1));
  std::size_t facets = 0;
  for (auto _ : state) {
    const auto made = approximate(surface, options);
    facets = made->mesh.triangles.size();
  }
  state.counters["facets"] = double(facets);
  state.counters["facets_per_second"] =
      benchmark::Counter(double(facets), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(bisection)->ArgsProduct({{0, 1}, {10'000, 100'000, 1'000'000}})->Unit(benchmark::kMillisecond);

void optimiser(benchmark::State& state) {
  const Surface surface = patch_surface(state.range(0) != 0);
  MeshOptions options;
  options.criteria.distance = 0.01;
  options.optimise = true;
  std::size_t facets = 0;
  for (auto _ : state) facets = approximate(surface, options)->mesh.triangles.size();
  state.counters["facets"] = double(facets);
}
BENCHMARK(optimiser)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace

// Surfaces round solids: cold, while dragging, and with the check of a final result.

#include <benchmark/benchmark.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "core/document/read_solids.hpp"
#include "core/envelope/envelope.hpp"

namespace hariko {
namespace {

/// The paper's figure 4 has four solids and 61 patches.
EnvelopeInput four_solids() {
  return read_scene(R"({"primitives": [
    {"type": "box", "size": [2, 1.2, 0.8]},
    {"type": "sphere", "radius": 0.55, "position": [1.9, 0.1, 0.35]},
    {"type": "cylinder", "radius": 0.4, "height": 1.1, "position": [-1.1, 0.2, 0.75], "rotation": [0, 20, 0]},
    {"type": "prism", "sides": 4, "radius": 0.6, "height": 0.8, "position": [0.4, -1.2, 0.1],
     "rotation": [0, 0, 20]}]})")
      .value();
}

EnvelopeInput ten_solids() {
  EnvelopeInput out = four_solids();
  for (std::uint32_t k = 0; k < 6; ++k) {
    Solid solid;
    solid.kind = k % 2 == 0 ? SolidKind::box : SolidKind::sphere;
    solid.size = {0.8, 0.6, 0.5};
    solid.radius = 0.35;
    solid.position = {std::cos(double(k)) * 1.4, std::sin(double(k)) * 1.2, 0.3 * double(k) - 0.8};
    solid.rotation = {20.0 * k, 10.0 * k, 0};
    solid.id = 4 + k;
    out.solids.push_back(solid);
  }
  return out;
}

/// The search with its patches, without the check that final results get.
void envelope_cold(benchmark::State& state) {
  const EnvelopeInput input = state.range(0) == 4 ? four_solids() : ten_solids();
  const std::vector<PlacedSolid> solids = place_solids(input);
  EnclosureSettings settings;
  settings.strict = false;
  std::size_t patches = 0, builds = 0;
  for (auto _ : state) {
    const EnclosedNetwork found = search_enclosure(solids, settings);
    patches = found.network.patches.size();
    builds = std::size_t(found.builds);
  }
  state.counters["patches"] = double(patches);
  state.counters["builds"] = double(builds);
}
BENCHMARK(envelope_cold)->Arg(4)->Arg(10)->Unit(benchmark::kMillisecond);

void envelope_drag(benchmark::State& state) {
  EnvelopeInput input = state.range(0) == 4 ? four_solids() : ten_solids();
  EnvelopeSurfacer surfacer;
  benchmark::DoNotOptimize(surfacer.rebuild(input).ok());
  int step = 0;
  for (auto _ : state) {
    input.solids[1].position.x() = 1.9 + 0.004 * (step++ % 100);
    benchmark::DoNotOptimize(surfacer.rebuild(input, Quality::drag).ok());
  }
}
BENCHMARK(envelope_drag)->Arg(4)->Arg(10)->Unit(benchmark::kMillisecond);

/// On a field's cage, as tight as can be.
EnvelopeInput field_scene_of(const std::string& name) {
  std::ifstream file(std::string(HARIKO_SOURCE_DIR) + "/tests/golden/envelope/" + name + ".json");
  std::ostringstream text;
  text << file.rdbuf();
  EnvelopeInput out = read_scene(text.str()).value();
  out.settings.method = EnvelopeMethod::field;
  out.settings.tightness = 1;
  return out;
}

/// The last solid.
void field_drag(benchmark::State& state, const char* name) {
  EnvelopeInput input = field_scene_of(name);
  EnvelopeSurfacer surfacer;
  benchmark::DoNotOptimize(surfacer.rebuild(input).ok());
  const double from = input.solids.back().position.x();
  int step = 0;
  for (auto _ : state) {
    input.solids.back().position.x() = from + 0.004 * (step++ % 100);
    benchmark::DoNotOptimize(surfacer.rebuild(input, Quality::drag).ok());
  }
}

/// A vertex of the cage.
void field_pull(benchmark::State& state, const char* name) {
  EnvelopeInput input = field_scene_of(name);
  EnvelopeSurfacer surfacer;
  const EnvelopeSurface first = surfacer.rebuild(input).value();
  const NetworkVertexKey vertex = first.handles.vertices.front().vertex;
  int step = 0;
  for (auto _ : state) {
    input.settings.offsets.set(vertex, {0.002 * (step++ % 100), 0, 0});
    benchmark::DoNotOptimize(surfacer.rebuild(input, Quality::drag).ok());
  }
}
BENCHMARK_CAPTURE(field_drag, camera, "camera")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(field_pull, camera, "camera")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(field_drag, ten, "ten")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(field_pull, ten, "ten")->Unit(benchmark::kMillisecond);

void envelope_final(benchmark::State& state) {
  const EnvelopeInput input = state.range(0) == 4 ? four_solids() : ten_solids();
  for (auto _ : state) benchmark::DoNotOptimize(EnvelopeSurfacer().rebuild(input).ok());
}
BENCHMARK(envelope_final)->Arg(4)->Arg(10)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hariko

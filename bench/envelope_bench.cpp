// Surfaces that a ball leaves round solids: while dragging, and final.

#include <benchmark/benchmark.h>

#include <cmath>

#include "core/document/format/read_solids.hpp"
#include "core/envelope/ball/tightness.hpp"
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

void envelope_drag(benchmark::State& state) {
  EnvelopeInput input = state.range(0) == 4 ? four_solids() : ten_solids();
  input.settings.rounding = 0.035 * solids_size(input.solids);
  input.settings.ball_radius = 0.3 * solids_size(input.solids);
  EnvelopeSurfacer surfacer;
  benchmark::DoNotOptimize(surfacer.rebuild(input).ok());
  int step = 0;
  for (auto _ : state) {
    input.solids[1].position.x() = 1.9 + 0.004 * (step++ % 100);
    benchmark::DoNotOptimize(surfacer.rebuild(input, Quality::drag).ok());
  }
}
BENCHMARK(envelope_drag)->Arg(4)->Arg(10)->Unit(benchmark::kMillisecond);

void envelope_final(benchmark::State& state) {
  const EnvelopeInput input = state.range(0) == 4 ? four_solids() : ten_solids();
  for (auto _ : state) benchmark::DoNotOptimize(EnvelopeSurfacer().rebuild(input).ok());
}
BENCHMARK(envelope_final)->Arg(4)->Arg(10)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hariko

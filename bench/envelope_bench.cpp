// Surfaces that a ball leaves round solids: while dragging, and final.

#include <benchmark/benchmark.h>

#include <chrono>
#include <string>
#include <utility>

#include "core/base/files/file_io.hpp"
#include "core/document/format/read_solids.hpp"
#include "core/envelope/ball/ball_envelope.hpp"
#include "core/envelope/ball/ball_patches.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/envelope/envelope.hpp"
#include "core/envelope/scene_symmetry.hpp"

namespace hariko {
namespace {

/// Golden scene of 4, 10 or 50 solids, with a rounding of 0.035 and a ball of 0.3 of its size.
EnvelopeInput bench_solids(std::int64_t count) {
  const std::string name = count == 4 ? "four" : count == 10 ? "ten" : "fifty";
  EnvelopeInput out =
      read_scene(*read_file(std::string(HARIKO_SOURCE_DIR) + "/tests/golden/envelope/" + name + ".json"))
          .value();
  const double size = solids_size(out.solids);
  out.settings.method = EnvelopeMethod::ball;
  out.settings.rounding = 0.035 * size;
  out.settings.ball_radius = 0.3 * size;
  return out;
}

/// Drag of the second solid of a scene, which is a ball, along x and back.
class BallDrag {
 public:
  explicit BallDrag(EnvelopeInput of) : input(std::move(of)), start_(input.solids[1].position.x()) {}
  void move() { input.solids[1].position.x() = start_ + 0.004 * (step_++ % 100); }
  int steps() const { return step_; }

  EnvelopeInput input;

 private:
  double start_;
  int step_ = 0;
};

void envelope_drag(benchmark::State& state) {
  BallDrag drag(bench_solids(state.range(0)));
  EnvelopeSurfacer surfacer;
  benchmark::DoNotOptimize(surfacer.rebuild(drag.input).ok());
  for (auto _ : state) {
    drag.move();
    benchmark::DoNotOptimize(surfacer.rebuild(drag.input, Quality::drag).ok());
  }
}
BENCHMARK(envelope_drag)->Arg(4)->Arg(10)->Arg(50)->Unit(benchmark::kMillisecond);

/// Milliseconds of a frame's steps.
struct FrameSteps {
  double field = 0, cage = 0, patches = 0, check = 0, surface = 0;
};

/// Makes a frame with cubes of one size, step by step.
void add_frame(const EnvelopeInput& input, BallMemory& memory, FrameSteps& times) {
  using Clock = std::chrono::steady_clock;
  auto last = Clock::now();
  const auto stop = [&](double& step) {
    const auto now = Clock::now();
    step += std::chrono::duration<double, std::milli>(now - last).count();
    last = now;
  };
  const EnvelopedScene scene = enveloped_scene(input);
  const BallSettings ball = ball_settings(input.settings, solids_size(scene.input.solids));
  const BallField made =
      ball_field(scene.input.solids, ball, scene.origin, scene.mirror, Quality::drag, CancelToken(), &memory);
  stop(times.field);
  const BallCage cage = cage_of(made, scene.origin, ball.sigma);
  stop(times.cage);
  const auto patches = ball_patches(made.field, cage);
  stop(times.patches);
  constexpr int drag_intervals = 4;
  benchmark::DoNotOptimize(patch_fits(made.field, *patches, drag_intervals));
  stop(times.check);
  benchmark::DoNotOptimize(ball_surface(made.field, cage, patches, scene.origin));
  stop(times.surface);
}

void envelope_frame_steps(benchmark::State& state) {
  BallDrag drag(bench_solids(state.range(0)));
  BallMemory memory;
  FrameSteps times;
  for (auto _ : state) {
    drag.move();
    add_frame(drag.input, memory, times);
  }
  state.counters["field"] = times.field / drag.steps();
  state.counters["cage"] = times.cage / drag.steps();
  state.counters["patches"] = times.patches / drag.steps();
  state.counters["check"] = times.check / drag.steps();
  state.counters["surface"] = times.surface / drag.steps();
}
BENCHMARK(envelope_frame_steps)->Arg(4)->Arg(10)->Unit(benchmark::kMillisecond);

/// The closing alone, and how many nodes it searches in a frame: from nothing, and from the frame before.
/// The radius is in hundredths of the size.
void envelope_closing(benchmark::State& state) {
  BallDrag drag(bench_solids(state.range(0)));
  const bool kept = state.range(1) != 0;
  BallSettings settings = ball_settings(drag.input.settings, solids_size(drag.input.solids));
  settings.radius = 0.01 * double(state.range(2)) * solids_size(drag.input.solids);
  BallMemory memory;
  double searched = 0, evaluated = 0;
  for (auto _ : state) {
    drag.move();
    if (!kept) memory.closing = ClosingMemory();
    const EnvelopedScene scene = enveloped_scene(drag.input);
    const BallField made = ball_field(scene.input.solids, settings, scene.origin, scene.mirror, Quality::drag,
                                      CancelToken(), &memory);
    searched += double(made.lattice.searched);
    evaluated += double(made.lattice.evaluated);
  }
  state.counters["searched"] = searched / drag.steps();
  state.counters["evaluated"] = evaluated / drag.steps();
}
BENCHMARK(envelope_closing)
    ->ArgNames({"solids", "kept", "radius"})
    ->ArgsProduct({{4, 10}, {0, 1}, {12, 30}})
    ->Unit(benchmark::kMillisecond);

void envelope_final(benchmark::State& state) {
  const EnvelopeInput input = bench_solids(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(EnvelopeSurfacer().rebuild(input).ok());
}
BENCHMARK(envelope_final)->Arg(4)->Arg(10)->Arg(50)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hariko

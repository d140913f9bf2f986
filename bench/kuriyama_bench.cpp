// Costs of a polyhedron's surface, step by step, on quad tori of about 100, 1,000 and 20,000 faces.
// Single-threaded unless HARIKO_BENCH_THREADS says otherwise.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <numeric>

#include "bench/models.hpp"
#include "core/base/parallel.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/g2_surface.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "render/display_mesh.hpp"

namespace hariko {
namespace {

constexpr int display_density_of_bench = 4;  ///< 15 points a patch

void sizes(benchmark::internal::Benchmark* b) {
  b->Arg(100)->Arg(1000)->Arg(20000)->Unit(benchmark::kMillisecond);
}

void network_assemble(benchmark::State& state) {
  const Polyhedron polyhedron = bench_torus(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(NetworkSystem::assemble(polyhedron, {}));
}
BENCHMARK(network_assemble)->Apply(sizes);

void network_solve(benchmark::State& state) {
  const Polyhedron polyhedron = bench_torus(state.range(0));
  const NetworkSystem system = NetworkSystem::assemble(polyhedron, {}).value();
  const std::vector<Vector3> positions = polyhedron.positions();
  int iterations = 0;
  for (auto _ : state) iterations = system.solve(positions, {}).iterations;
  state.counters["steps"] = iterations;
}
BENCHMARK(network_solve)->Apply(sizes);

void surface(benchmark::State& state, Mode mode) {
  const PolyhedronSurfaceInput input{bench_torus(state.range(0)), {}, mode, Vector3::Zero()};
  PolyhedronSurfacer surfacer;
  const auto steps_of = [&] {
    const SolveReport report = surfacer.rebuild(input)->report;
    return mode == Mode::g2 ? report.g2_iterations : report.fair_iterations;
  };
  int steps = steps_of();
  for (auto _ : state) steps = steps_of();
  state.counters["steps"] = steps;
}
BENCHMARK_CAPTURE(surface, paper, Mode::paper)->Apply(sizes);
BENCHMARK_CAPTURE(surface, fair, Mode::fair)->Apply(sizes);
BENCHMARK_CAPTURE(surface, g2, Mode::g2)->Apply(sizes);

void cold(benchmark::State& state, Mode mode, Frames frames) {
  PolyhedronSurfaceInput input{bench_torus(state.range(0)), {}, mode, Vector3::Zero()};
  input.frames = frames;
  for (auto _ : state) {
    PolyhedronSurfacer surfacer;
    benchmark::DoNotOptimize(surfacer.rebuild(input));
  }
}
BENCHMARK_CAPTURE(cold, fair, Mode::fair, Frames::equal)->Apply(sizes);
BENCHMARK_CAPTURE(cold, fair_metric, Mode::fair, Frames::metric)->Apply(sizes);
BENCHMARK_CAPTURE(cold, g2, Mode::g2, Frames::equal)->Apply(sizes);
BENCHMARK_CAPTURE(cold, g2_metric, Mode::g2, Frames::metric)->Apply(sizes);

/// Bytes a face of mode G2: matrices where faces are equal and where no two are (frames by measure), and
/// controls.
void g2_memory(benchmark::State& state) {
  const Polyhedron polyhedron = bench_torus(state.range(0));
  for (auto _ : state) {
    const double faces = polyhedron.face_count();
    const auto bytes = [&](Frames frames) {
      const NetworkSystem network = NetworkSystem::assemble(polyhedron, {}, {frames}).value();
      return double(G2System(polyhedron.shared_topology(), network).matrix_bytes()) / faces;
    };
    state.counters["shared"] = bytes(Frames::equal);
    state.counters["metric"] = bytes(Frames::metric);
    const NetworkSystem network = NetworkSystem::assemble(polyhedron, {}).value();
    const G2System system(polyhedron.shared_topology(), network);
    const FaceChart& chart = system.chart(0);
    state.counters["controls"] = 24.0 * (chart.control_count() + 7 * chart.sides());
    state.counters["unknowns"] = system.unknown_count() / faces;
  }
}
BENCHMARK(g2_memory)->Arg(1000)->Unit(benchmark::kMillisecond)->Iterations(1);

void evaluate(benchmark::State& state, Mode mode, bool curvatures) {
  PolyhedronSurfacer surfacer;
  const auto result = surfacer.rebuild({bench_torus(1000), {}, mode, Vector3::Zero()});
  const PatchSet& patches = result->surface.patches();
  const GridPattern pattern{Domain::triangle, static_cast<int>(state.range(0))};
  std::vector<Index> all(64);  // a block that stays in the cache
  std::iota(all.begin(), all.end(), Index(0));
  const std::size_t count = all.size() * static_cast<std::size_t>(pattern.point_count());
  std::vector<Vector3> positions(count), normals(count);
  std::vector<PatchPoint> points(count);
  for (auto _ : state) {
    if (curvatures)
      patches.evaluate_grid(all, pattern, points);
    else
      patches.evaluate_grid(all, pattern, positions, normals);
    benchmark::ClobberMemory();
  }
  state.counters["points"] =
      benchmark::Counter(double(count) * double(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(evaluate, position_normal, Mode::paper, false)->Arg(4)->Arg(8)->Arg(16);
BENCHMARK_CAPTURE(evaluate, second_order, Mode::paper, true)->Arg(4)->Arg(8)->Arg(16);
BENCHMARK_CAPTURE(evaluate, g2_position_normal, Mode::g2, false)->Arg(4)->Arg(8)->Arg(16);
BENCHMARK_CAPTURE(evaluate, g2_second_order, Mode::g2, true)->Arg(4)->Arg(8)->Arg(16);

/// One vertex moves: polyhedron value, surface, and the display mesh, refreshed where patches changed.
void drag(benchmark::State& state, Mode mode) {
  PolyhedronSurfaceInput input{bench_torus(state.range(0)), {}, mode, Vector3::Zero()};
  PolyhedronSurfacer surfacer;
  const auto first = surfacer.rebuild(input);
  const Polyhedron start = input.polyhedron;
  const Index vertex = 0;
  DisplayOptions options;
  options.density = display_density_of_bench;
  const auto base = DisplayMesh::build(first->surface, options);
  double step = 0;
  std::size_t changed = 0;
  const auto frame = [&] {
    const Vector3 moved = start.position(vertex) + Vector3(0, 0, 0.3 * std::sin(0.1 * ++step));
    input.polyhedron = start.with_positions(std::span(&vertex, 1), std::span(&moved, 1)).value();
    const auto result = surfacer.rebuild(input, Quality::drag);
    changed = result->changed->size();
    benchmark::DoNotOptimize(base->refreshed(result->surface, *result->changed));
  };
  for (int i = 0; i < 12; ++i) frame();  // the first ones solve for the response
  for (auto _ : state) frame();
  state.counters["patches"] = double(changed);
}
BENCHMARK_CAPTURE(drag, fair, Mode::fair)->Apply(sizes);
BENCHMARK_CAPTURE(drag, paper, Mode::paper)->Apply(sizes);
BENCHMARK_CAPTURE(drag, g2, Mode::g2)->Apply(sizes);

/// The first frame of a drag: steps of the response's solution, and the surface. Each time another vertex.
void drag_start(benchmark::State& state, Mode mode) {
  PolyhedronSurfaceInput input{bench_torus(state.range(0)), {}, mode, Vector3::Zero()};
  PolyhedronSurfacer surfacer;
  benchmark::DoNotOptimize(surfacer.rebuild(input));
  const Polyhedron start = input.polyhedron;
  Index vertex = 0;
  for (auto _ : state) {
    const Vector3 moved = start.position(vertex) + Vector3(0, 0, 0.3);
    input.polyhedron = start.with_positions(std::span(&vertex, 1), std::span(&moved, 1)).value();
    benchmark::DoNotOptimize(surfacer.rebuild(input, Quality::drag));
    vertex = (vertex + 1) % start.vertex_count();
  }
}
BENCHMARK_CAPTURE(drag_start, fair, Mode::fair)->Apply(sizes);
BENCHMARK_CAPTURE(drag_start, g2, Mode::g2)->Apply(sizes);

/// Name of the processor, so that figures can be told apart.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace
}  // namespace hariko

int main(int argc, char** argv) {
  const char* threads = std::getenv("HARIKO_BENCH_THREADS");
  const hariko::ParallelLimit limit(threads ? std::atoi(threads) : 1);
  benchmark::Initialize(&argc, argv);
  benchmark::AddCustomContext("processor", hariko::processor());
  benchmark::AddCustomContext("threads", threads ? threads : "1");
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

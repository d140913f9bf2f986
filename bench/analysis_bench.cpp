// Measures, continuity and statistics of a surface, and one facet deleted from a large mesh, by
// the number of faces. Single-threaded unless HARIKO_BENCH_THREADS says otherwise.

#include <benchmark/benchmark.h>

#include <array>

#include "bench/models.hpp"
#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "core/analysis/statistics.hpp"
#include "core/modeling/operations/delete_elements.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {
namespace {

Surface torus_surface(std::int64_t faces) {
  const PolyhedronSurfaceInput input{bench_torus(faces), {}, Mode::fair, Vector3::Zero()};
  return PolyhedronSurfacer().rebuild(input)->surface;
}

void sizes(benchmark::internal::Benchmark* b) {
  b->Arg(1000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
}

template <class Measured>
void analysis(benchmark::State& state, Measured (*measured)(const Surface&, const CancelToken&)) {
  const Surface surface = torus_surface(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(measured(surface, {}));
}
BENCHMARK_CAPTURE(analysis, measures, measure)->Apply(sizes);
BENCHMARK_CAPTURE(analysis, continuity, continuity)->Apply(sizes);
BENCHMARK_CAPTURE(analysis, statistics, curvature_statistics)->Apply(sizes);

void delete_one_facet(benchmark::State& state) {
  const PolyhedronSource source = PolyhedronSource::from_mesh(bench_torus_mesh(state.range(0))).value();
  const std::array<FaceId, 1> facet{FaceId{7}};
  for (auto _ : state) benchmark::DoNotOptimize(delete_faces(source, facet).value());
}
BENCHMARK(delete_one_facet)->Arg(5000)->Arg(50'000)->Arg(500'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hariko

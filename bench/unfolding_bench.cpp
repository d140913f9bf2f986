// Paper models: growth and joining alone, and with the search (the budget of docs/cli.md).

#include <benchmark/benchmark.h>

#include "bench/models.hpp"
#include "core/unfolding/cuts/cut_search.hpp"
#include "core/unfolding/unfolding.hpp"

namespace hariko {
namespace {

/// The wavy torus with about `facets` triangles.
FacetGraph bench_facets(std::int64_t facets) {
  const PolygonMesh quads = bench_torus_mesh(facets / 2);
  PolygonMesh mesh;
  mesh.positions = quads.positions;
  for (std::size_t f = 0; f < quads.face_count(); ++f) {
    const auto quad = quads.face(f);
    mesh.add_face({quad[0], quad[1], quad[2]});
    mesh.add_face({quad[0], quad[2], quad[3]});
  }
  return FacetGraph::build(mesh).value();
}

void search(benchmark::State& state, std::uint64_t steps) {
  const FacetGraph graph = bench_facets(state.range(0));
  const auto shapes = facet_shapes(graph, 1);
  std::size_t pieces = 0;
  for (auto _ : state) {
    const auto found = search_cuts(graph, shapes, {}, {.steps = steps});
    pieces = piece_count(graph, found.value().back());
  }
  state.counters["facets"] = double(graph.facet_count());
  state.counters["pieces"] = double(pieces);
}
BENCHMARK_CAPTURE(search, growth_and_joining, 0)->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(search, ejection, 300'000)->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);

void pages(benchmark::State& state) {
  const auto graph = std::make_shared<const FacetGraph>(bench_facets(state.range(0)));
  PaperSettings settings;
  settings.scale = 40;
  for (auto _ : state) benchmark::DoNotOptimize(unfold(graph, settings, {.steps = 0}).ok());
}
BENCHMARK(pages)->Arg(600)->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hariko

// Control points from outlines: sites inserted and solved, by mode and number.

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "core/base/parallel.hpp"
#include "core/gaussmap/control_points.hpp"

namespace hariko {
namespace {

/// The ellipsoid (2, 1.5, 1) over a circle of normals 60 degrees round z.
Outline ellipsoid_cap(int count) {
  const Vector3 squares(4, 2.25, 1);
  OutlineLoop loop;
  for (int i = 0; i < count; ++i) {
    const double t = 2 * std::numbers::pi * i / count, polar = std::numbers::pi / 3;
    const Vector3 n(std::sin(polar) * std::cos(t), std::sin(polar) * std::sin(t), std::cos(polar));
    const double square = squares.dot(n.cwiseAbs2());
    loop.normals.push_back(n);
    loop.points.push_back(squares.cwiseProduct(n) / std::sqrt(square));
    loop.curvature.push_back(square * square / squares.prod());
  }
  return {{loop}};
}

void control_points_of_a_cap(benchmark::State& state, GaussMode mode) {
  const ParallelLimit one_core(1);
  const auto wanted = static_cast<Index>(state.range(0));
  // A cap with M points on its rim takes about 0.185 M^2 sites; a few more, so that the limit is reached.
  const Outline outline = ellipsoid_cap(int(std::ceil(std::sqrt(wanted / 0.17))));
  GaussOptions options;
  options.mode = mode;
  options.most_points = wanted;
  for (auto _ : state) {
    const auto points = control_points(outline, options);
    if (!points.ok()) {
      state.SkipWithError(points.error().text.c_str());
      break;
    }
    state.counters["sites"] = double(points->points.size() - points->boundary_count);
    benchmark::DoNotOptimize(points->points.data());
  }
}

BENCHMARK_CAPTURE(control_points_of_a_cap, curvature, GaussMode::curvature)
    ->Arg(200)
    ->Arg(1000)
    ->Arg(3000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(control_points_of_a_cap, umbilic, GaussMode::umbilic)
    ->Arg(200)
    ->Arg(1000)
    ->Arg(3000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(control_points_of_a_cap, position, GaussMode::position)
    ->Arg(200)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hariko

BENCHMARK_MAIN();

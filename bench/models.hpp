#pragma once

// Models of any size for benchmarks.

#include <cmath>
#include <numbers>

#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// A slightly wavy torus of about `faces` quads.
inline PolygonMesh bench_torus_mesh(std::int64_t faces) {
  const int m = static_cast<int>(std::lround(std::sqrt(double(faces) / 2))), n = 2 * m;
  PolygonMesh mesh;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / m;
      const double r = 2 + std::cos(b) + 0.05 * std::sin(5 * a + 3 * b);
      mesh.positions.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
    }
  const auto at = [&](int i, int j) { return static_cast<Index>((i % n) * m + j % m); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) mesh.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return mesh;
}
inline Polyhedron bench_torus(std::int64_t faces) {
  return Polyhedron::build(bench_torus_mesh(faces)).value();
}

}  // namespace hariko

#include "core/modeling/selection/soft_selection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"

namespace hariko {

double falloff(Falloff kind, double x) {
  if (!(x < 1)) return 0;
  const double rest = 1 - std::max(x, 0.0);
  switch (kind) {
    case Falloff::smooth:
      return rest * rest * (3 - 2 * rest);
    case Falloff::linear:
      return rest;
    case Falloff::sharp:
      return rest * rest;
  }
  return 0;
}

std::vector<double> distances_from(const Polyhedron& polyhedron, std::span<const Index> given) {
  std::vector<double> distances(polyhedron.vertex_count());
  parallel_for(polyhedron.vertex_count(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Index g : given)
        nearest = std::min(
            nearest, (polyhedron.position(static_cast<Index>(v)) - polyhedron.position(g)).squaredNorm());
      distances[v] = std::sqrt(nearest);
    }
  });
  return distances;
}

}  // namespace hariko

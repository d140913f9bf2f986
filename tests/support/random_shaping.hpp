#pragma once

// Random tensions, creases and tags on a polyhedron.

#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

/// Modes of the polyhedron that make quartic triangles.
inline constexpr Mode quartic_modes[] = {Mode::paper, Mode::target, Mode::fair};

/// Random shaping. About half of the elements get a tension, alpha logarithmically uniform in [0.001,
/// largest_alpha), beta in [smallest_beta, largest_beta). One mesh in three has creases, one in five tags on
/// border vertices.
inline Shaping random_shaping(const Polyhedron& polyhedron, std::mt19937_64& rng, double largest_alpha,
                              double smallest_beta, double largest_beta) {
  Shaping shaping;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const bool creased = chance(rng, 1.0 / 3), tagged = chance(rng, 0.2);
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
    if (chance(rng, 0.5)) shaping.alpha.set(polyhedron.vertex_id(v), log_uniform(rng, 1e-3, largest_alpha));
    if (tagged && mesh.is_border_vertex(v) && chance(rng, 0.3))
      shaping.tag.set(polyhedron.vertex_id(v), chance(rng, 0.5) ? VertexTag::corner : VertexTag::smooth);
  }
  for (Index e = 0; e < polyhedron.edge_count(); ++e) {
    if (chance(rng, 0.5))
      shaping.beta.set(polyhedron.edge_id(e), log_uniform(rng, smallest_beta, largest_beta));
    if (creased && chance(rng, 0.15)) shaping.crease.set(polyhedron.edge_id(e), true);
  }
  return shaping;
}

}  // namespace hariko::test

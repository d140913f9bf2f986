#pragma once

// Random polyhedra at any size and place for the tests of operations, and a random share of their elements.

#include <algorithm>
#include <set>
#include <vector>

#include "core/polyhedron/validation.hpp"
#include "tests/modeling/support.hpp"

namespace hariko::test {

/// Any mesh a designer may have, 1e-3 to 1e6 large, near zero or a million sizes away, with shaping.
inline PolyhedronSource random_source(std::mt19937_64& rng) {
  PolygonMesh mesh = random_polyhedron(rng);
  const double scale = log_uniform(rng, 1e-3, 1e6);
  const Vector3 shift = chance(rng, 0.3) ? Vector3(1e6 * random_vector(rng)) : Vector3(Vector3::Zero());
  for (Vector3& p : mesh.positions) p = scale * (p + shift);
  PolyhedronSource source = PolyhedronSource::from_mesh(std::move(mesh)).value();
  source.shaping = random_shaping(source.polyhedron, rng, 100, 0.01, 100);
  return source;
}

inline std::vector<VertexId> some_vertices(const Polyhedron& polyhedron, std::mt19937_64& rng, double share) {
  std::vector<VertexId> out;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    if (chance(rng, share)) out.push_back(polyhedron.vertex_id(v));
  return out;
}

inline std::vector<EdgeId> some_edges(const Polyhedron& polyhedron, std::mt19937_64& rng, double share) {
  std::vector<EdgeId> out;
  for (Index e = 0; e < polyhedron.edge_count(); ++e)
    if (chance(rng, share)) out.push_back(polyhedron.edge_id(e));
  return out;
}

inline std::vector<FaceId> some_faces(const Polyhedron& polyhedron, std::mt19937_64& rng, double share) {
  std::vector<FaceId> out;
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    if (chance(rng, share)) out.push_back(polyhedron.face_id(f));
  return out;
}

}  // namespace hariko::test

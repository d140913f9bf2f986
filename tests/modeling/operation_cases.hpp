#pragma once

// What the tests of operations share: random polyhedra at any size and place, random selections, counts.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "core/modeling/edit_result.hpp"
#include "core/polyhedron/validation.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/random_shaping.hpp"

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

inline std::vector<FaceId> all_faces(const Polyhedron& polyhedron) {
  std::vector<FaceId> out;
  for (Index f = 0; f < polyhedron.face_count(); ++f) out.push_back(polyhedron.face_id(f));
  return out;
}

/// V - E + F; isolated vertices do not count.
inline int euler_number(const Polyhedron& polyhedron) {
  int vertices = 0;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    vertices += polyhedron.topology().outgoing(v) != no_index;
  return vertices - static_cast<int>(polyhedron.edge_count()) + static_cast<int>(polyhedron.face_count());
}

/// What every result must be, whatever the operation: a polyhedron (by its type) at the same origin, finite,
/// without loose vertices, whose shaping and selection name elements that exist.
inline void expect_sound(const EditResult& modeled, const PolyhedronSource& before) {
  const Polyhedron& polyhedron = modeled.source.polyhedron;
  EXPECT_EQ(modeled.source.origin, before.origin);
  EXPECT_EQ(modeled.source.mode, before.mode);
  EXPECT_TRUE(HalfEdgeMesh::build(polyhedron.to_mesh()).ok());
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
    EXPECT_NE(polyhedron.topology().outgoing(v), no_index);
    EXPECT_TRUE(polyhedron.position(v).allFinite());
  }
  const Shaping& shaping = *modeled.source.shaping;
  for (const auto& entry : shaping.alpha) EXPECT_NE(polyhedron.find(entry.first), no_index);
  for (const auto& entry : shaping.beta) EXPECT_NE(polyhedron.find(entry.first), no_index);
  for (const auto& entry : shaping.crease) EXPECT_NE(polyhedron.find(entry.first), no_index);
  for (const auto& entry : shaping.tag) EXPECT_NE(polyhedron.find(entry.first), no_index);
  for (const auto& entry : shaping.pin) EXPECT_NE(polyhedron.find(entry.first), no_index);
  for (const VertexId id : modeled.selection.vertices) EXPECT_NE(polyhedron.find(id), no_index);
  for (const EdgeId id : modeled.selection.edges) EXPECT_NE(polyhedron.find(id), no_index);
  for (const FaceId id : modeled.selection.faces) EXPECT_NE(polyhedron.find(id), no_index);
}

/// A refusal says what and why.
inline void expect_refusal(const Message& message) {
  EXPECT_TRUE(message.code.name.starts_with("E_"));
  EXPECT_FALSE(message.text.empty());
  EXPECT_FALSE(message.remedy.empty());
}

}  // namespace hariko::test

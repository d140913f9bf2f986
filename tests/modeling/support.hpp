#pragma once

// Support of the tests of operations: random polyhedra of every kind with random shaping and selections, and
// what must hold of any result.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "core/document/source.hpp"
#include "core/geometry/polygon.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/modeling/operations/face_geometry.hpp"
#include "core/modeling/surfacing/surface_input.hpp"
#include "core/polyhedron/volume.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/random_shaping.hpp"

namespace hariko::test {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline PolyhedronSource source_of(const PolygonMesh& mesh) {
  return PolyhedronSource::from_mesh(mesh).value();
}

/// Edge between two vertices, by their ids.
inline EdgeId edge(std::uint32_t a, std::uint32_t b) {
  return EdgeId::of({a}, {b});
}

/// Ids with gaps, so that ids and dense indices cannot be mistaken for each other.
inline PolyhedronSource with_gaps(PolyhedronSource source, std::mt19937_64& rng) {
  const Polyhedron& polyhedron = source.polyhedron;
  std::vector<VertexId> vertex_ids;
  std::vector<FaceId> face_ids;
  std::uint32_t id = 0;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    vertex_ids.push_back({id += static_cast<std::uint32_t>(uniform_int(rng, 1, 3))});
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    face_ids.push_back({id += static_cast<std::uint32_t>(uniform_int(rng, 1, 3))});
  source.polyhedron = Polyhedron::build(polyhedron.to_mesh(), vertex_ids, face_ids).value();
  return source;
}

/// A valid polyhedron of any kind: open or closed, any genus, faces of many sides, 1e-3 .. 1e6 in size, near
/// zero or a million away, with tensions, creases, tags and pinned planes.
inline PolyhedronSource random_shape_source(std::mt19937_64& rng) {
  PolygonMesh mesh = random_polyhedron(rng);
  const double scale = chance(rng, 0.5) ? 1 : log_uniform(rng, 1e-3, 1e6);
  const Vector3 far = chance(rng, 0.3) ? random_vector(rng, 1e6) : Vector3::Zero();
  for (Vector3& p : mesh.positions) p = scale * p + far;
  PolyhedronSource source = with_gaps(source_of(mesh), rng);
  Shaping shaping = random_shaping(source.polyhedron, rng, 100, 0.01, 100);
  for (Index v = 0; v < source.polyhedron.vertex_count(); ++v)
    if (chance(rng, 0.05))
      shaping.pin.set(source.polyhedron.vertex_id(v),
                      {Pin::Kind::normal, {random_vector(rng) + Vector3(0, 0, 2)}});
  source.shaping = std::move(shaping);
  return source;
}

/// None, one, some or all of `count` elements, as ids.
template <class Id, class ToId>
std::vector<Id> random_selection(Index count, std::mt19937_64& rng, ToId&& to_id) {
  std::vector<Id> out;
  if (chance(rng, 0.3)) {
    out.push_back(to_id(static_cast<Index>(rng() % count)));
    return out;
  }
  const double share = chance(rng, 0.2) ? 1 : uniform(rng, 0, 1);
  for (Index i = 0; i < count; ++i)
    if (chance(rng, share)) out.push_back(to_id(i));
  return out;
}

inline std::vector<FaceId> random_faces(const PolyhedronSource& source, std::mt19937_64& rng) {
  return random_selection<FaceId>(source.polyhedron.face_count(), rng,
                                  [&](Index f) { return source.polyhedron.face_id(f); });
}
inline std::vector<VertexId> random_vertices(const PolyhedronSource& source, std::mt19937_64& rng) {
  return random_selection<VertexId>(source.polyhedron.vertex_count(), rng,
                                    [&](Index v) { return source.polyhedron.vertex_id(v); });
}
inline std::vector<EdgeId> random_edges(const PolyhedronSource& source, std::mt19937_64& rng) {
  return random_selection<EdgeId>(source.polyhedron.edge_count(), rng,
                                  [&](Index e) { return source.polyhedron.edge_id(e); });
}

inline std::vector<FaceId> all_faces(const PolyhedronSource& source) {
  std::vector<FaceId> out;
  for (Index f = 0; f < source.polyhedron.face_count(); ++f) out.push_back(source.polyhedron.face_id(f));
  return out;
}
inline std::vector<EdgeId> border_edges(const Polyhedron& polyhedron) {
  std::vector<EdgeId> out;
  for (Index e = 0; e < polyhedron.edge_count(); ++e)
    if (polyhedron.topology().is_border_edge(e)) out.push_back(polyhedron.edge_id(e));
  return out;
}
inline std::vector<VertexId> all_vertices(const PolyhedronSource& source) {
  std::vector<VertexId> out;
  for (Index v = 0; v < source.polyhedron.vertex_count(); ++v) out.push_back(source.polyhedron.vertex_id(v));
  return out;
}
inline std::vector<EdgeId> all_edges(const PolyhedronSource& source) {
  std::vector<EdgeId> out;
  for (Index e = 0; e < source.polyhedron.edge_count(); ++e) out.push_back(source.polyhedron.edge_id(e));
  return out;
}

/// The size of the box round the polyhedron.
inline double size_of(const PolyhedronSource& source) {
  return size_of(source.polyhedron);
}

/// Mostly a part of the size, now and then something that nobody means.
inline double random_amount(std::mt19937_64& rng, double size) {
  static const std::vector<double> silly{0, -1, 1e300, -1e300, 1e-300, infinity, -infinity, not_a_number};
  if (chance(rng, 0.25)) return silly[rng() % silly.size()];
  return (chance(rng, 0.2) ? -1 : 1) * size * log_uniform(rng, 1e-4, 2);
}

/// V - E + F; isolated vertices do not count.
inline int euler_number(const Polyhedron& polyhedron) {
  int vertices = 0;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    vertices += polyhedron.topology().outgoing(v) != no_index;
  return vertices - static_cast<int>(polyhedron.edge_count()) + static_cast<int>(polyhedron.face_count());
}
inline int euler(const PolyhedronSource& source) {
  return euler_number(source.polyhedron);
}

inline std::string counts(const PolyhedronSource& source) {
  const Polyhedron& p = source.polyhedron;
  return std::to_string(p.vertex_count()) + "/" + std::to_string(p.edge_count()) + "/" +
         std::to_string(p.face_count());
}

inline int edges_of_tension(const PolyhedronSource& source, double beta) {
  int count = 0;
  for (const auto& entry : source.shaping->beta) count += entry.second == beta ? 1 : 0;
  return count;
}

/// Invariants of every result, whatever the operation: a polyhedron (by its type) at the same origin in the
/// same mode, finite, without loose vertices, whose shaping and selection name elements that exist.
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

/// A refusal explains itself; otherwise the result is sound, and something is selected.
inline void expect_whole(const PolyhedronSource& before, const Result<EditResult>& result) {
  if (!result) return expect_refusal(result.error());
  expect_sound(*result, before);
  EXPECT_FALSE(result->selection.empty());
}

/// expect_whole, and the Euler number is the one before.
inline void expect_same_euler(const PolyhedronSource& before, const Result<EditResult>& result) {
  expect_whole(before, result);
  if (result) {
    EXPECT_EQ(euler(result->source), euler(before));
  }
}

/// A surface can be made of it.
inline void expect_surface(const PolyhedronSource& source) {
  const auto made = PolyhedronSurfacer().rebuild(surface_input(source).value());
  EXPECT_TRUE(made) << (made ? "" : to_string(made.error()));
}

template <class T>
void expect_error(const Result<T>& result, Code code) {
  ASSERT_FALSE(result) << "expected " << code.name;
  EXPECT_EQ(result.error().code.name, code.name) << to_string(result.error());
}

inline std::vector<Vector3> corners_of(const Polyhedron& polyhedron, Index f) {
  std::vector<Vector3> out;
  for (const Index v : polyhedron.topology().face_vertices(f)) out.push_back(polyhedron.position(v));
  return out;
}

inline double area_of(const Polyhedron& polyhedron, Index f) {
  return newell_normal(corners_of(polyhedron, f)).norm() / 2;
}

/// Mean of the corners.
inline Vector3 face_centre(const Polyhedron& polyhedron, Index f) {
  const std::vector<Vector3> corners = corners_of(polyhedron, f);
  Vector3 sum = Vector3::Zero();
  for (const Vector3& p : corners) sum += p;
  return sum / double(corners.size());
}

/// Greatest distance of a corner from the face's mean plane through its centre.
inline double unevenness(const Polyhedron& polyhedron, Index f) {
  double worst = 0;
  for (const Vector3& p : corners_of(polyhedron, f))
    worst = std::max(worst, std::abs((p - face_centre(polyhedron, f)).dot(face_normal(polyhedron, f))));
  return worst;
}

inline void expect_areas(const PolyhedronSource& source, double least) {
  for (Index f = 0; f < source.polyhedron.face_count(); ++f)
    EXPECT_GT(area_of(source.polyhedron, f), least) << "face " << source.polyhedron.face_id(f).value;
}

inline void expect_planar(const PolyhedronSource& source, double tolerance) {
  for (Index f = 0; f < source.polyhedron.face_count(); ++f)
    EXPECT_LE(unevenness(source.polyhedron, f), tolerance) << "face " << source.polyhedron.face_id(f).value;
}

}  // namespace hariko::test

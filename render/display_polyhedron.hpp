#pragma once

// DisplayPolyhedron: a polyhedron prepared for display and picking. A value without GL.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/document/document.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "render/camera.hpp"

namespace hariko {

/// Kinds of displayed edges.
enum class EdgeKind : std::uint8_t { plain, crease, boundary };
inline constexpr int edge_kind_count = 3;

/// Polyhedron in single precision. Dense indices are those of the source polyhedron.
struct DisplayPolyhedron {
  Vector3 origin = Vector3::Zero();
  std::vector<std::array<float, 3>> positions;  ///< relative to the origin
  std::vector<std::array<Index, 2>> edges;
  std::vector<EdgeKind> edge_kinds;
  std::vector<Index> face_offsets{0}, face_vertices;
  std::vector<VertexId> vertex_ids;  ///< ascending
  std::vector<FaceId> face_ids;      ///< ascending
  Box3 box;                          ///< bounding box of the positions, relative to the origin

  std::vector<float> alpha, beta;  ///< tensions of all vertices and edges; empty for reference meshes
  std::vector<Index> corners, smooth, pinned;  ///< vertices with these tags or pins

  std::size_t face_count() const { return face_offsets.size() - 1; }
  std::span<const Index> face(std::size_t f) const {
    return {face_vertices.data() + face_offsets[f], face_vertices.data() + face_offsets[f + 1]};
  }
  Vector3 position(Index v) const {
    return {double(positions[v][0]), double(positions[v][1]), double(positions[v][2])};
  }

  EdgeId edge_id(Index e) const { return EdgeId::of(vertex_ids[edges[e][0]], vertex_ids[edges[e][1]]); }

  /// Display polyhedron relative to `origin`. O(elements).
  static std::shared_ptr<const DisplayPolyhedron> build(const Polyhedron& polyhedron, const Shaping& shaping,
                                                        const Vector3& origin);
  /// Copy of the same elements with another shaping. O(elements).
  std::shared_ptr<const DisplayPolyhedron> shaped(const Polyhedron& polyhedron, const Shaping& shaping) const;
  /// Copy of the same elements at the polyhedron's present positions; the polyhedron must have the topology
  /// of the source. O(vertices).
  std::shared_ptr<const DisplayPolyhedron> moved(const Polyhedron& polyhedron) const;
};

/// Polyhedron of an object, or the control net of its patches; null for other objects.
std::shared_ptr<const DisplayPolyhedron> cage_of(const Object& object);

/// Elements to emphasise, dense indices of the polyhedron.
struct Highlights {
  std::vector<Index> vertices, edges, faces;
  bool empty() const { return vertices.empty() && edges.empty() && faces.empty(); }
  friend bool operator==(const Highlights&, const Highlights&) = default;
};

}  // namespace hariko

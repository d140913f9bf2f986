#pragma once

// Polyhedron: a manifold polygon mesh as a value, with positions and stable ids.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/chunked_array.hpp"
#include "core/base/ids.hpp"
#include "core/base/result.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// Manifold polygon mesh. Invariants: manifold connectivity, every position finite, ids unique and ascending
/// with the dense index. Faces may have any number of sides >= 3 and need not be planar; open or closed, any
/// genus, several components.
///
/// Positions are relative to an origin that the owner keeps (see `origin_for`). Copies share memory.
class Polyhedron {
 public:
  /// Builds with ids 0, 1, 2, ... in input order. Errors: those of `HalfEdgeMesh::build`, and E_NONFINITE.
  static Result<Polyhedron> build(const PolygonMesh& mesh);
  /// Builds with given ids, which must be strictly ascending, one per element (E_INDEX_RANGE otherwise).
  /// Errors then name elements by these ids.
  static Result<Polyhedron> build(const PolygonMesh& mesh, std::vector<VertexId> vertex_ids,
                                  std::vector<FaceId> face_ids);

  const HalfEdgeMesh& topology() const { return *topology_; }
  /// Connectivity, shared between copies: the same pointer means the same connectivity, so results that
  /// depend on topology alone may be kept.
  const std::shared_ptr<const HalfEdgeMesh>& shared_topology() const { return topology_; }

  Index vertex_count() const { return topology_->vertex_count(); }
  Index edge_count() const { return topology_->edge_count(); }
  Index face_count() const { return topology_->face_count(); }

  const Vector3& position(Index v) const { return positions_[v]; }
  std::vector<Vector3> positions() const { return positions_.to_vector(); }
  /// Positions of the corners of a face, in order.
  std::vector<Vector3> corners(Index face) const;

  VertexId vertex_id(Index v) const { return (*vertex_ids_)[v]; }
  FaceId face_id(Index f) const { return (*face_ids_)[f]; }
  /// Id of an edge, from the ids of its vertices.
  EdgeId edge_id(Index e) const;
  /// Dense index of an id, no_index when there is none. O(log n).
  Index find(VertexId id) const;
  Index find(FaceId id) const;
  Index find(EdgeId id) const;

  /// Copy with some vertices moved. Positions must be finite (E_NONFINITE otherwise).
  Result<Polyhedron> with_positions(std::span<const Index> vertices,
                                    std::span<const Vector3> positions) const;

  /// The polygons, by dense indices.
  PolygonMesh to_mesh() const;

  friend bool operator==(const Polyhedron& a, const Polyhedron& b);

 private:
  Polyhedron() = default;
  std::shared_ptr<const HalfEdgeMesh> topology_;
  std::shared_ptr<const std::vector<VertexId>> vertex_ids_;
  std::shared_ptr<const std::vector<FaceId>> face_ids_;
  ChunkedArray<Vector3, 128> positions_;
};

/// Origin of an object, which its coordinates are stored relative to: the centre of the bounding box, each
/// coordinate rounded to a multiple of the power of two at or above the box's largest extent. Subtracting it
/// is exact for objects far from zero, and objects near zero keep origin 0. Non-finite positions are ignored.
Vector3 origin_for(std::span<const Vector3> positions);

}  // namespace hariko

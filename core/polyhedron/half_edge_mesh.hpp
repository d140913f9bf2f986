#pragma once

// HalfEdgeMesh: the connectivity of a manifold polygon mesh, without positions. Immutable.

#include <iterator>
#include <span>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Half-edge mesh. Half-edge h is corner h of the face list: it runs from the corner's vertex to the next
/// vertex of its face, with the face on its left. The boundary has no half-edges of its own: a boundary edge
/// has one half-edge, whose twin is no_index.
///
/// Fan of vertex v (kuriyama.md section 0): outgoing edges e_0 .. e_{n-1} counter-clockwise, corner k between
/// e_k and e_{k+1}. A closed fan has n corners; an open fan has n-1, and e_0 is the boundary edge with no
/// face on its right. The corners of the fan, in order, are the half-edges outgoing(v), rotate(outgoing(v)),
/// ...
class HalfEdgeMesh {
 public:
  /// Corners of a fan for range-based loops; valid as long as the mesh.
  class FanCorners {
   public:
    class Iterator {
     public:
      Iterator(const HalfEdgeMesh& mesh, Index first) : mesh_(&mesh), first_(first), at_(first) {}
      Index operator*() const { return at_; }
      Iterator& operator++() {
        at_ = mesh_->rotate(at_);
        if (at_ == first_) at_ = no_index;
        return *this;
      }
      friend bool operator==(const Iterator& at, std::default_sentinel_t) { return at.at_ == no_index; }

     private:
      const HalfEdgeMesh* mesh_;
      Index first_, at_;
    };
    FanCorners(const HalfEdgeMesh& mesh, Index first) : mesh_(&mesh), first_(first) {}
    Iterator begin() const { return {*mesh_, first_}; }
    std::default_sentinel_t end() const { return {}; }

   private:
    const HalfEdgeMesh* mesh_;
    Index first_;
  };

  /// Builds from polygons. Errors: E_NO_FACES, E_INDEX_RANGE, E_FACE_TOO_SMALL, E_FACE_REPEATED_VERTEX,
  /// E_EDGE_NONMANIFOLD_OR_FLIPPED, E_VERTEX_NONMANIFOLD; elements are dense indices. O(corners).
  static Result<HalfEdgeMesh> build(const PolygonMesh& mesh);

  Index vertex_count() const { return static_cast<Index>(outgoing_.size()); }
  Index face_count() const { return static_cast<Index>(face_offsets_.size() - 1); }
  Index edge_count() const { return static_cast<Index>(edge_half_edge_.size()); }
  Index half_edge_count() const { return static_cast<Index>(origin_.size()); }

  Index origin(Index h) const { return origin_[h]; }
  Index target(Index h) const { return origin_[next(h)]; }
  Index face(Index h) const { return face_[h]; }
  Index edge(Index h) const { return edge_[h]; }
  Index twin(Index h) const { return twin_[h]; }  ///< no_index on the boundary
  Index next(Index h) const { return h + 1 == face_offsets_[face_[h] + 1] ? face_offsets_[face_[h]] : h + 1; }
  Index previous(Index h) const {
    return h == face_offsets_[face_[h]] ? face_offsets_[face_[h] + 1] - 1 : h - 1;
  }

  /// Half-edges (= corners) of face f: the range [face_begin, face_end), in order.
  Index face_begin(Index f) const { return face_offsets_[f]; }
  Index face_end(Index f) const { return face_offsets_[f + 1]; }
  Index side_count(Index f) const { return face_offsets_[f + 1] - face_offsets_[f]; }
  std::span<const Index> face_vertices(Index f) const {
    return {origin_.data() + face_offsets_[f], origin_.data() + face_offsets_[f + 1]};
  }

  /// First half-edge of v's fan; no_index for an isolated vertex.
  Index outgoing(Index v) const { return outgoing_[v]; }
  /// Next outgoing half-edge counter-clockwise, no_index at the end of an open fan.
  Index rotate(Index h) const { return twin_[previous(h)]; }
  /// Corners of v's fan in order, as the half-edges that leave v; none for an isolated vertex.
  FanCorners fan_corners(Index v) const { return {*this, outgoing_[v]}; }
  bool is_border_vertex(Index v) const { return outgoing_[v] != no_index && twin_[outgoing_[v]] == no_index; }
  Index corner_count(Index v) const { return corner_count_[v]; }
  /// Number of edges at v: corners, plus one on an open fan.
  Index valence(Index v) const { return corner_count_[v] + (is_border_vertex(v) ? 1 : 0); }

  /// One half-edge of edge e, the one with the smaller index. The other one, if any, is its twin.
  Index half_edge_of_edge(Index e) const { return edge_half_edge_[e]; }
  bool is_border_edge(Index e) const { return twin_[edge_half_edge_[e]] == no_index; }
  /// Half-edge from a to b, or no_index. O(valence of a).
  Index find_half_edge(Index a, Index b) const;

  /// Connected component of each face, numbered from 0; isolated vertices are not counted.
  std::vector<Index> face_components() const;
  /// Number of boundary loops.
  Index border_loop_count() const;

  /// Equality of vertex counts and of polygons in the same order: everything else follows from them.
  friend bool operator==(const HalfEdgeMesh& a, const HalfEdgeMesh& b);

 private:
  HalfEdgeMesh() = default;
  bool link_twins(const PolygonMesh& mesh);
  void number_faces_and_edges();
  bool find_fans(Index vertex_count);
  std::vector<Index> face_offsets_, origin_, face_, edge_, twin_, outgoing_, corner_count_, edge_half_edge_;
};

/// Edge of a vertex's fan: an end of a half-edge on it (end 2h is half-edge h at its origin, end 2h + 1 is h
/// at its target), and the vertex at its other end.
struct FanEnd {
  Index end = no_index;
  Index other = no_index;
};
/// Edges of a vertex's fan, counter-clockwise. O(valence).
std::vector<FanEnd> fan_ends(const HalfEdgeMesh& mesh, Index v);

}  // namespace hariko

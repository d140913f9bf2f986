#pragma once

// CollapsibleMesh: a mesh under half-edge collapses, with the facets around each vertex, and the edges and
// vertices that must stay.

#include <array>
#include <unordered_set>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/vector.hpp"
#include "core/geometry/edge_key.hpp"

namespace hariko {

/// Triangle mesh for half-edge collapses. Kept edges are borders, sharp edges and edges of more than two
/// facets.
class CollapsibleMesh {
 public:
  /// Takes a mesh; edges between facets whose normals differ by more than `sharp` (radians) are kept.
  CollapsibleMesh(std::vector<Vector3> positions, std::vector<std::array<Index, 3>> triangles, double sharp);

  const std::vector<Vector3>& positions() const { return positions_; }
  const std::vector<std::array<Index, 3>>& triangles() const { return triangles_; }
  bool alive(Index facet) const { return alive_[facet] != 0; }
  std::size_t facet_count() const { return count_; }
  /// Facets around a vertex.
  const std::vector<Index>& round(Index vertex) const { return round_[vertex]; }
  bool kept_edge(Index a, Index b) const { return kept_.contains(edge_key(a, b)); }
  /// Vertices that share a facet with this one, in ascending order.
  void neighbours(Index vertex, std::vector<Index>& out) const;

  /// Whether collapsing v into w leaves a mesh of the same kind, and v may leave its place in that direction.
  bool may_collapse(Index v, Index w) const;
  /// Facets around v that remain after the collapse, with w in place of v.
  void moved_facets(Index v, Index w, std::vector<std::pair<Index, std::array<Index, 3>>>& out) const;
  /// Collapses v into w; `may_collapse` must hold.
  void collapse(Index v, Index w);

 private:
  enum class Freedom : std::uint8_t { inside, along, fixed };
  void find_kept(double sharp);
  Freedom freedom_of(Index vertex) const;

  std::vector<Vector3> positions_;
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<char> alive_;
  std::vector<std::vector<Index>> round_;
  std::unordered_set<std::uint64_t> kept_, border_;
  std::vector<Freedom> freedom_;
  std::size_t count_;
  mutable std::vector<Index> near_v_, near_w_;
};

}  // namespace hariko

#pragma once

// A mesh under half-edge collapses: facets round vertices, and which edges and vertices must stay.

#include <array>
#include <unordered_set>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/vector.hpp"
#include "core/geometry/edge_key.hpp"

namespace hariko {

/// Triangles and, of each vertex, those round it. Kept edges are borders, sharp edges and edges of more than
/// two facets.
class CollapsibleMesh {
 public:
  /// Edges between facets whose normals differ by more than `sharp` are kept.
  CollapsibleMesh(std::vector<Vector3> positions, std::vector<std::array<Index, 3>> triangles, double sharp);

  const std::vector<Vector3>& positions() const { return positions_; }
  const std::vector<std::array<Index, 3>>& triangles() const { return triangles_; }
  bool alive(Index facet) const { return alive_[facet] != 0; }
  std::size_t facet_count() const { return count_; }
  const std::vector<Index>& round(Index vertex) const { return round_[vertex]; }
  bool kept_edge(Index a, Index b) const { return kept_.contains(edge_key(a, b)); }
  /// Vertices that share a facet with this one, in ascending order.
  void neighbours(Index vertex, std::vector<Index>& out) const;

  /// True when pulling v into w leaves a mesh of the same kind, and v may leave its place that way.
  bool may_collapse(Index v, Index w) const;
  /// The facets round v that stay, with w in its place.
  void moved_facets(Index v, Index w, std::vector<std::pair<Index, std::array<Index, 3>>>& out) const;
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

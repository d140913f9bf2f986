#pragma once

// Changes of a parameter mesh that can be tried, judged and taken back: collapses, flips and moves.

#include <optional>
#include <vector>

#include "core/approximation/parameter_mesh.hpp"
#include "core/approximation/surface_sampler.hpp"

namespace hariko {

/// Works on a mesh in place; facets that a collapse removes stay as holes until `compact`.
class MeshSurgery {
 public:
  MeshSurgery(const SurfaceSampler& sampler, ParameterMesh& mesh);

  bool alive(Index facet) const { return alive_[facet] != 0; }
  std::size_t facet_count() const { return count_; }
  std::size_t vertex_count() const { return leaving_.size(); }
  bool vertex_alive(Index vertex) const { return leaving_[vertex] != no_index; }

  /// Half-edges that leave a vertex, one a facet; in order round it where it is inside.
  void star(Index vertex, std::vector<Index>& out) const;

  /// A vertex moves freely inside of a patch, along a border that it shares with at most one other patch, or
  /// not at all (corners, poles).
  enum class Freedom { inside, border, fixed };
  Freedom freedom(Index vertex) const;

  /// What a change has done, to take it back.
  struct Change {
    std::vector<Index> facets;  ///< whose errors changed
    std::vector<std::pair<Index, ParameterFacet>> before;
    std::vector<std::pair<Index, Index>> twins;
    std::vector<Index> removed;
    std::optional<std::pair<Index, Vector3>> position;
    void clear();
  };
  /// Pulls the origin of a half-edge into its target. False, with nothing done, where the mesh would no
  /// longer be one, parameters would turn over, or the origin may not move that way.
  bool collapse(Index half_edge, Change& change);
  /// The other diagonal of the two facets at an edge inside of one patch.
  bool flip(Index half_edge, Change& change);
  /// Moves a vertex inside of its patch by a difference of parameters.
  bool move(Index vertex, const Vector2& by, Change& change);
  /// Moves a border vertex towards the target of one of its border edges, by a part t of the edge.
  bool slide(Index half_edge, double t, Change& change);
  void undo(const Change& change);
  /// Makes a change final.
  void keep(const Change& change);

  /// The origin's border edges; two for a vertex with freedom `border`.
  bool is_border_edge(Index half_edge) const;
  /// Removes holes and unused vertices.
  static ParameterMesh compact(const ParameterMesh& mesh, const std::vector<char>& alive);
  ParameterMesh compacted() const { return compact(mesh_, alive_); }

 private:
  bool at_domain_corner(const Vector2& parameter) const;
  bool turned(Index facet) const;
  bool linked(Index a, Index b) const;
  void set_twin(Index half_edge, Index other, Change& change);
  void save(Index facet, Change& change);

  const SurfaceSampler& sampler_;
  ParameterMesh& mesh_;
  std::vector<char> alive_;
  std::vector<Index> leaving_;  ///< one half-edge a vertex
  std::size_t count_;
  mutable std::vector<Index> star_, other_star_;
};

}  // namespace hariko

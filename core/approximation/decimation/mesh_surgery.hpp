#pragma once

// MeshSurgery: local changes of a parameter mesh that can be tried, judged and undone: collapses, flips and
// moves.

#include <optional>
#include <vector>

#include "core/approximation/refinement/parameter_mesh.hpp"
#include "core/approximation/surface_sampler.hpp"

namespace hariko {

/// Editor of a mesh in place; facets that a collapse removes stay as holes until `compact`.
class MeshSurgery {
 public:
  /// Begins to edit `mesh`; keeps references to both.
  MeshSurgery(const SurfaceSampler& sampler, ParameterMesh& mesh);

  bool alive(Index facet) const { return alive_[facet] != 0; }
  std::size_t facet_count() const { return count_; }
  std::size_t vertex_count() const { return leaving_.size(); }
  bool vertex_alive(Index vertex) const { return leaving_[vertex] != no_index; }

  /// Half-edges that leave a vertex, one per facet; in order around an inner vertex.
  void star(Index vertex, std::vector<Index>& out) const;

  /// Freedom of a vertex: to move inside a patch, along a border that it shares with at most one other patch,
  /// or not at all (corners, poles).
  enum class Freedom { inside, border, fixed };
  /// Freedom of a vertex, by its star. O(valence).
  Freedom freedom(Index vertex) const;

  /// Record of a change, for undoing it.
  struct Change {
    std::vector<Index> facets;  ///< facets whose errors changed
    std::vector<std::pair<Index, ParameterFacet>> before;
    std::vector<std::pair<Index, Index>> twins;
    std::vector<Index> removed;
    std::optional<std::pair<Index, Vector3>> position;
    void clear();
  };
  /// Collapses the origin of a half-edge into its target. False, with nothing done, where the result would
  /// not be a mesh, parameters would be inverted, or the origin may not move in that direction.
  bool collapse(Index half_edge, Change& change);
  /// Flips the edge between two facets inside one patch to the other diagonal.
  bool flip(Index half_edge, Change& change);
  /// Moves a vertex inside its patch by a difference of parameters.
  bool move(Index vertex, const Vector2& by, Change& change);
  /// Slides a border vertex towards the target of one of its border edges, by a fraction t of the edge.
  bool slide(Index half_edge, double t, Change& change);
  /// Undoes a change, the last one made.
  void undo(const Change& change);
  /// Makes a change final; it can no longer be undone.
  void keep(const Change& change);

  /// Whether an edge lies on a border between patches or of the surface; a vertex with freedom `border` has
  /// two.
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
  /// Whether the collapse of a half-edge keeps the mesh a manifold. Sets `star_` to the star of its origin.
  bool keeps_manifold(Index half_edge) const;

  const SurfaceSampler& sampler_;
  ParameterMesh& mesh_;
  std::vector<char> alive_;
  std::vector<Index> leaving_;  ///< one half-edge per vertex
  std::size_t count_;
  mutable std::vector<Index> star_, other_star_;
};

}  // namespace hariko

#pragma once

// FacetGraph: a triangle mesh that can be unfolded, with the edges between its facets.

#include <array>
#include <vector>

#include "core/base/message.hpp"
#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

inline constexpr Code e_facet_not_triangular{"E_FACET_NOT_TRIANGULAR"};
inline constexpr Code e_facet_degenerate{"E_FACET_DEGENERATE"};

/// An edge of the mesh and the one or two facets at it. Side s of a facet runs from its corner s to the next.
struct FacetEdge {
  Index low = 0, high = 0;                             ///< vertices, low < high
  std::array<Index, 2> facets = {no_index, no_index};  ///< ascending; the second is no_index on a border
  std::array<Index, 2> sides = {0, 0};
  double length = 0;      ///< in the mesh's unit
  double fold_angle = 0;  ///< radians between the normals; > 0 convex (mountain), < 0 concave (valley)

  bool border() const { return facets[1] == no_index; }
  /// The facet on the other side of the edge; no_index on a border.
  Index across(Index facet) const { return facets[0] == facet ? facets[1] : facets[0]; }
};

/// Immutable. Every facet is a triangle with an area; every edge has one facet, or two that run along it in
/// opposite directions. Facets may touch in single vertices, and there may be several components.
class FacetGraph {
 public:
  /// Errors: the first of `unfolding_errors`. O(facets log facets).
  static Result<FacetGraph> build(const PolygonMesh& mesh);

  std::size_t facet_count() const { return triangles_.size(); }
  std::size_t edge_count() const { return edges_.size(); }
  std::size_t component_count() const { return component_count_; }
  const std::vector<Vector3>& positions() const { return positions_; }
  const std::array<Index, 3>& triangle(Index facet) const { return triangles_[facet]; }
  const FacetEdge& edge(Index e) const { return edges_[e]; }
  const std::vector<FacetEdge>& edges() const { return edges_; }  ///< ascending by (low, high)
  Index edge_at(Index facet, Index side) const { return edges_of_[facet][side]; }
  Index neighbour(Index facet, Index side) const { return edges_[edges_of_[facet][side]].across(facet); }
  /// The side of the neighbour that meets this side.
  Index mate_side(Index facet, Index side) const;
  /// The edge between two vertices; no_index when there is none. O(log edges).
  Index find_edge(Index a, Index b) const;
  Index component(Index facet) const { return component_of_[facet]; }

  double area(Index facet) const { return areas_[facet]; }
  double total_area() const;
  double longest_edge() const { return longest_edge_; }
  /// Unit, outward.
  Vector3 normal(Index facet) const;

 private:
  void find_components();
  std::vector<Vector3> positions_;
  std::vector<std::array<Index, 3>> triangles_, edges_of_;
  std::vector<FacetEdge> edges_;
  std::vector<Index> component_of_;
  std::vector<double> areas_;
  std::size_t component_count_ = 0;
  double longest_edge_ = 0;
};

/// Why a mesh cannot be unfolded: E_NONFINITE, E_NO_FACES, E_INDEX_RANGE, E_FACE_TOO_SMALL,
/// E_FACE_REPEATED_VERTEX, E_FACET_NOT_TRIANGULAR, E_FACET_DEGENERATE (a height below 1e-12 of its base),
/// E_EDGE_NONMANIFOLD_OR_FLIPPED; at most `limit` of each. Elements are dense indices.
std::vector<Message> unfolding_errors(const PolygonMesh& mesh, std::size_t limit = 100);

/// The same triangles as polygons with absolute positions.
PolygonMesh polygons_of(const TriangleMesh& mesh);

}  // namespace hariko

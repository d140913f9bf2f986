#pragma once

// FacetGraph: triangles and edges of a mesh that can be unfolded.

#include <array>
#include <numbers>
#include <span>
#include <vector>

#include "core/base/message.hpp"
#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

inline constexpr Code e_facet_degenerate{"E_FACET_DEGENERATE"};

/// Edge of the mesh with the one or two facets at it. Side s of a facet runs from its corner s to the next.
struct FacetEdge {
  Index low = 0, high = 0;                             ///< vertices, low < high
  std::array<Index, 2> facets = {no_index, no_index};  ///< ascending; the second is no_index on a border
  /// Side of each facet that is the edge.
  std::array<Index, 2> sides = {0, 0};
  double length = 0;      ///< in the mesh's unit
  double fold_angle = 0;  ///< radians between the normals; > 0 convex (mountain), < 0 concave (valley)
  bool inner = false;     ///< within one flat face of the mesh: never cut, never drawn

  bool border() const { return facets[1] == no_index; }
  /// Facet on the other side of the edge; no_index on a border.
  Index across(Index facet) const { return facets[0] == facet ? facets[1] : facets[0]; }
};

/// Largest fold angle between the triangles of a face that counts as flat, radians.
inline constexpr double flat_face_angle = 0.5 * std::numbers::pi / 180;

/// Dual graph of a triangulated mesh; immutable. Every facet is a triangle with an area; every edge has one
/// facet, or two that run along it in opposite directions. Facets may touch in single vertices, and there may
/// be several components. A face with more than three sides is several facets; where they are coplanar the
/// edges between them are inner edges, otherwise the face is folded there.
class FacetGraph {
 public:
  /// Builds the graph, with facets in the order of the faces. Errors: the first of `unfolding_errors`.
  /// O(facets log facets).
  static Result<FacetGraph> build(const PolygonMesh& mesh);

  /// Number of faces of the source mesh.
  std::size_t face_count() const { return face_facets_.size() - 1; }
  Index face(Index facet) const { return face_of_[facet]; }
  /// First facet of a face; its facets end before that of the next face.
  Index first_facet(Index face) const { return face_facets_[face]; }
  /// Corner of a face, as a corner of one of its facets.
  struct FaceCorner {
    Index facet = 0, corner = 0;
  };
  /// Corners of a face, in order.
  std::span<const FaceCorner> face_corners(Index face) const {
    return {corners_.data() + face_corners_[face], corners_.data() + face_corners_[face + 1]};
  }

  std::size_t facet_count() const { return triangles_.size(); }
  std::size_t edge_count() const { return edges_.size(); }
  std::size_t component_count() const { return component_count_; }
  const std::vector<Vector3>& positions() const { return positions_; }
  const std::array<Index, 3>& triangle(Index facet) const { return triangles_[facet]; }
  const FacetEdge& edge(Index e) const { return edges_[e]; }
  /// Edges, ascending by (low, high); a few share both vertices: inner edges of two faces.
  const std::vector<FacetEdge>& edges() const { return edges_; }
  Index edge_at(Index facet, Index side) const { return edges_of_[facet][side]; }
  Index neighbour(Index facet, Index side) const { return edges_[edges_of_[facet][side]].across(facet); }
  /// Side of the neighbour that meets this side.
  Index mate_side(Index facet, Index side) const;
  /// Edge between two vertices; no_index where there is none. O(log edges).
  Index find_edge(Index a, Index b) const;
  Index component(Index facet) const { return component_of_[facet]; }

  double area(Index facet) const { return areas_[facet]; }
  /// Sum of the facets' areas. O(facets).
  double total_area() const;
  double longest_edge() const { return longest_edge_; }
  /// Outward unit normal.
  Vector3 normal(Index facet) const;

 private:
  void add_facets(const PolygonMesh& mesh);
  void add_edge(FacetEdge edge);
  void add_inner_edges();
  void sort_edges();
  void find_components();
  std::vector<Vector3> positions_;
  std::vector<Index> face_of_;                     ///< by facet
  std::vector<Index> face_facets_, face_corners_;  ///< by face: position of its first facet and corner
  std::vector<FaceCorner> corners_;
  std::vector<std::array<Index, 3>> triangles_, edges_of_;
  std::vector<FacetEdge> edges_;
  std::vector<Index> component_of_;
  std::vector<double> areas_;
  std::size_t component_count_ = 0;
  double longest_edge_ = 0;
};

/// Faults for which a mesh cannot be unfolded: E_NONFINITE, E_NO_FACES, E_INDEX_RANGE, E_FACE_TOO_SMALL,
/// E_FACE_REPEATED_VERTEX, E_FACET_DEGENERATE (no area, a height below 1e-12 of its base, or
/// self-intersecting), E_EDGE_NONMANIFOLD_OR_FLIPPED; at most `limit` of each. Elements are dense indices.
/// O(corners log corners).
std::vector<Message> unfolding_errors(const PolygonMesh& mesh, std::size_t limit = 100);

/// Polygon mesh of the same triangles, with absolute positions.
PolygonMesh polygons_of(const TriangleMesh& mesh);

}  // namespace hariko

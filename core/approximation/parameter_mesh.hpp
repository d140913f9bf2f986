#pragma once

// A triangle mesh over a surface whose facets know which part of which patch they stand for.

#include <array>
#include <vector>

#include "core/base/vector.hpp"
#include "core/surface/facet_evaluation.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Half-edge 3 f + c runs from corner c of facet f to the next one.
inline Index facet_of(Index half_edge) {
  return half_edge / 3;
}
inline Index next_of(Index half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
inline Index previous_of(Index half_edge) {
  return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
}

/// The part of a patch that a facet stands for. Parameters belong to corners, not to vertices: a vertex on
/// the border of two patches has other ones in each. At a pole, where a side of the patch is shrunk to a
/// point, a corner has two: `parameter` where the facet's edge leaves it and `pole_parameter` where the edge
/// before it arrives; the facet then stands for a quadrilateral.
struct ParameterFacet {
  Index patch = 0;
  std::array<Index, 3> vertex{};
  std::array<Vector2, 3> parameter{Vector2::Zero(), Vector2::Zero(), Vector2::Zero()};
  Vector2 pole_parameter = Vector2::Zero();
  std::int32_t pole = -1;  ///< the corner with two parameters, or -1

  const Vector2& leaving(Index corner) const { return parameter[corner]; }
  const Vector2& arriving(Index corner) const {
    return std::int32_t(corner) == pole ? pole_parameter : parameter[corner];
  }
  bool degenerate() const {
    return vertex[0] == vertex[1] || vertex[1] == vertex[2] || vertex[2] == vertex[0];
  }
};

/// The one or two triangles of parameters that a facet stands for, in the facet's order of corners (a pole
/// facet's second triangle has the pole's side first).
struct ParameterPieces {
  std::array<ParameterTriangle, 2> triangle;
  int count = 1;
};
ParameterPieces pieces_of(const ParameterFacet& facet);

/// A line in a patch's domain.
struct ParameterLine {
  Index patch = 0;
  Vector2 from = Vector2::Zero(), to = Vector2::Zero();
  Vector2 at(double t) const { return from + t * (to - from); }
};

/// Facets with their neighbours. Positions are relative to the surface's origin. Facets without area at which
/// two corners are one vertex may be among them: they close what a collapsed side leaves open and are dropped
/// in the end.
class ParameterMesh {
 public:
  std::vector<Vector3> positions;
  std::vector<ParameterFacet> facets;
  /// Of each half-edge the one of the facet across; no_index at a border.
  std::vector<Index> twin;

  Index from(Index half_edge) const { return facets[facet_of(half_edge)].vertex[half_edge % 3]; }
  Index to(Index half_edge) const { return from(next_of(half_edge)); }
  std::array<Vector3, 3> corners(Index facet) const {
    const auto& v = facets[facet].vertex;
    return {positions[v[0]], positions[v[1]], positions[v[2]]};
  }
  /// The half-edge's line as its own facet sees it.
  ParameterLine line(Index half_edge) const;
  /// The edge's line as all agree on: that of the facet of the smaller patch (of the smaller half-edge in one
  /// patch), from the smaller vertex to the larger.
  ParameterLine canonical_line(Index half_edge) const;
  double length(Index half_edge) const {
    return (positions[to(half_edge)] - positions[from(half_edge)]).norm();
  }

  Index add_facet(const ParameterFacet& facet);
  void link(Index a, Index b) {
    twin[a] = b;
    twin[b] = a;
  }

  /// What a split made: facets that were cut keep their number and the half up to the new vertex.
  struct Split {
    Index vertex = no_index;
    std::array<Index, 4> facets{};  ///< cut ones and new ones
    int count = 0;
    /// Half-edges, one of each twins, whose edges are new: the edge's two halves, then those to opposite
    /// corners.
    std::array<Index, 4> edges{};
    int edge_count = 0;
  };
  /// Cuts the one or two facets at an edge. `t` is the fraction in the canonical direction, `position` the
  /// new vertex.
  Split split(Index half_edge, double t, const Vector3& position);

 private:
  void cut(Index half_edge, Index vertex, const Vector2& parameter, Split& out);
};

}  // namespace hariko

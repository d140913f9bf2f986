#pragma once

// ParameterMesh: a triangle mesh over a surface whose facets know the part of a patch that they approximate.

#include <array>
#include <vector>

#include "core/base/vector.hpp"
#include "core/surface/patch.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Facet of a half-edge: half-edge 3 f + c runs from corner c of facet f to the next one.
inline Index facet_of(Index half_edge) {
  return half_edge / 3;
}
inline Index next_of(Index half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
inline Index previous_of(Index half_edge) {
  return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
}

/// Facet with its part of a patch. Parameters belong to corners, not to vertices: a vertex on the border of
/// two patches has different ones in each. At a pole, where a side of the patch is shrunk to a point, a
/// corner has two: `parameter` where the facet's edge leaves it and `pole_parameter` where the edge before it
/// arrives; the facet then covers a quadrilateral of parameters.
struct ParameterFacet {
  Index patch = 0;
  std::array<Index, 3> vertex{};
  std::array<Vector2, 3> parameter{Vector2::Zero(), Vector2::Zero(), Vector2::Zero()};
  Vector2 pole_parameter = Vector2::Zero();
  std::int32_t pole = -1;  ///< corner with two parameters, or -1

  const Vector2& leaving(Index corner) const { return parameter[corner]; }
  const Vector2& arriving(Index corner) const {
    return std::int32_t(corner) == pole ? pole_parameter : parameter[corner];
  }
  /// Whether two corners are the same vertex.
  bool degenerate() const {
    return vertex[0] == vertex[1] || vertex[1] == vertex[2] || vertex[2] == vertex[0];
  }
};

/// Parameter triangles of a facet, one or two, in the facet's order of corners (a pole facet's second
/// triangle has the pole's side first).
struct ParameterPieces {
  std::array<ParameterTriangle, 2> triangle;
  int count = 1;
};
/// Parameter triangles of a facet.
ParameterPieces pieces_of(const ParameterFacet& facet);

/// Line segment in a patch's domain.
struct ParameterLine {
  Index patch = 0;
  Vector2 from = Vector2::Zero(), to = Vector2::Zero();
  Vector2 at(double t) const { return from + t * (to - from); }
};

/// Facets with their neighbours. Positions are relative to the surface's origin. Facets without area at which
/// two corners are one vertex may be among them: they fill the gaps left by collapsed sides and are dropped
/// in the end.
class ParameterMesh {
 public:
  std::vector<Vector3> positions;
  std::vector<ParameterFacet> facets;
  /// Opposite half-edge in the facet across, per half-edge; no_index at a border.
  std::vector<Index> twin;

  Index from(Index half_edge) const { return facets[facet_of(half_edge)].vertex[half_edge % 3]; }
  Index to(Index half_edge) const { return from(next_of(half_edge)); }
  std::array<Vector3, 3> corners(Index facet) const {
    const auto& v = facets[facet].vertex;
    return {positions[v[0]], positions[v[1]], positions[v[2]]};
  }
  /// Line of a half-edge as its own facet has it.
  ParameterLine line(Index half_edge) const;
  /// Line of an edge that both facets agree on: that of the facet of the smaller patch (of the smaller
  /// half-edge in one patch), from the smaller vertex to the larger.
  ParameterLine canonical_line(Index half_edge) const;
  double length(Index half_edge) const {
    return (positions[to(half_edge)] - positions[from(half_edge)]).norm();
  }

  Index add_facet(const ParameterFacet& facet);
  /// Makes two half-edges twins.
  void link(Index a, Index b) {
    twin[a] = b;
    twin[b] = a;
  }

  /// Result of a split: facets that were cut keep their number and the half up to the new vertex.
  struct Split {
    Index vertex = no_index;
    std::array<Index, 4> facets{};  ///< the cut facets and the new ones
    int count = 0;
    /// New edges, one half-edge of each twin pair: the edge's two halves, then those to opposite corners.
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

#pragma once

// Vertex frames: the tangents at a vertex as functions of its few basis vectors (Kuriyama 1991, equation (2),
// extended to borders, creases, darts and corners; kuriyama.md section 2.1; metric fans: section 12.2).

#include <array>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/network/face_charts.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Tangent as a combination of basis vectors, T = c[0] X[basis[0]] + c[1] X[basis[1]]; never more than two.
struct TangentCoefficients {
  std::array<Index, 2> basis{no_index, no_index};
  std::array<double, 2> c{0, 0};
};
/// Tangent for given basis vectors; it must have at least one of them.
inline Vector3 tangent_image(const TangentCoefficients& tangent, std::span<const Vector3> basis) {
  Vector3 out = tangent.c[0] * basis[tangent.basis[0]];
  if (tangent.basis[1] != no_index) out += tangent.c[1] * basis[tangent.basis[1]];
  return out;
}
/// Adds a gradient by a tangent to those by its basis vectors, of which it must have at least one: the
/// transpose of `tangent_image`.
inline void add_to_basis(const TangentCoefficients& tangent, const Vector3& gradient,
                         std::span<Vector3> out) {
  out[tangent.basis[0]] += tangent.c[0] * gradient;
  if (tangent.basis[1] != no_index) out[tangent.basis[1]] += tangent.c[1] * gradient;
}

/// Kind of vertex, by the rows of the table in kuriyama.md section 2.1.
enum class FrameKind : std::uint8_t { isolated, smooth, straight, sharp_line, corner };

/// Frames of all vertices. Equal frames depend on connectivity and tags only, metric frames on the positions
/// as well. "End" 2h is half-edge h at its origin: T(origin -> target); end 2h + 1 is h at its target:
/// T(target -> origin). Both half-edges of an edge describe the same two tangents.
struct VertexFrames {
  std::vector<FrameKind> kind;     ///< per vertex
  std::vector<Index> basis_begin;  ///< per vertex, plus one: basis vectors of v are [begin[v], begin[v + 1])
  std::vector<TangentCoefficients> ends;  ///< per end (2 per half-edge)
  std::vector<double> length;   ///< per end: length of the edge's vector in the fan, 1 in equal frames
  std::vector<double> step;     ///< per half-edge: angle between the edges of the corner at its origin
  std::vector<bool> half_turn;  ///< per half-edge: that angle is a half turn, by connectivity and tags
  /// Factor of split tangents, per half-edge: the split tangent of the corner at its origin is this times (x
  /// of the patch behind the corner T(edge) + x of the half-edge's own patch T(edge behind)); 1 in equal
  /// frames.
  std::vector<double> split_gain;
  std::vector<bool> sharp;  ///< per edge: border or crease
  /// Offset that kept forms add, per basis vector; empty where there are none.
  std::vector<Vector3> offset = {};
  FaceCharts charts;
  std::vector<double> kept_area = {};  ///< per face: factor of its area in mode FAIR; empty where all are 1

  Index basis_count() const { return basis_begin.back(); }
  /// Factors of the tangents along half-edge h and along the one before it in the split tangent of the corner
  /// at h's origin. Not defined at a half turn.
  std::array<double, 2> split_factors(const HalfEdgeMesh& mesh, Index h) const {
    return {split_gain[h] * charts.area[mesh.previous(h)], split_gain[h] * charts.area[h]};
  }
};

/// Requirement of the given curves on both sides of a border vertex on its frame (joins): a smooth line where
/// they are one curve, otherwise a corner with their true opening, counter-clockwise from the border edge
/// that leaves the vertex. Takes precedence over tags.
struct FrameRequest {
  Index vertex = no_index;
  bool line = true;
  double opening = 0;  ///< 0 .. 2 pi, its sine not near zero; not used for a line
  friend bool operator==(const FrameRequest&, const FrameRequest&) = default;
};

/// Options of vertex frames.
struct VertexFrameOptions {
  Frames frames = Frames::equal;
  /// Requests at border vertices where no crease ends, at most one per vertex.
  std::span<const FrameRequest> requests = {};
  /// Border half-edges whose curves are given (joins). Their ends keep equal angles and unit lengths, as do
  /// vertices with a pin of kind `tangents`; along a chain of them all split gains are equal.
  std::span<const Index> joined = {};
};

/// Builds the frames of all vertices. Error: E_CORNER_NEEDS_CREASE where an inner vertex tagged corner has
/// fewer than two sharp edges.
Result<VertexFrames> build_vertex_frames(const Polyhedron& polyhedron, const Shaping& shaping,
                                         const VertexFrameOptions& options = {});

}  // namespace hariko

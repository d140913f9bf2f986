#pragma once

// Vertex frames: how the tangents at a vertex depend on its few basis vectors (Kuriyama 1991, equation (2),
// extended to borders, creases, darts and corners; kuriyama.md section 2.1).

#include <array>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// T = c[0] X[basis[0]] + c[1] X[basis[1]]. A tangent never depends on more than two basis vectors.
struct TangentCoefficients {
  std::array<Index, 2> basis{no_index, no_index};
  std::array<double, 2> c{0, 0};
};

/// The rows of the table in kuriyama.md 2.1.
enum class FrameKind : std::uint8_t { isolated, smooth, straight, sharp_line, corner };

/// Depends on connectivity and tags only. "End" 2h is half-edge h at its origin: T(origin -> target); end 2h
/// + 1 is h at its target: T(target -> origin). Both half-edges of an edge describe the same two tangents.
struct VertexFrames {
  std::vector<FrameKind> kind;     ///< per vertex
  std::vector<Index> basis_begin;  ///< per vertex, plus one: basis vectors of v are [begin[v], begin[v + 1])
  std::vector<TangentCoefficients> ends;  ///< per end (2 per half-edge)
  std::vector<double> step;  ///< per half-edge: angular step of the sector of the corner at its origin
  std::vector<bool> sharp;   ///< per edge: border or crease

  Index basis_count() const { return basis_begin.back(); }
};

/// What the curves on both sides of a border vertex ask of its frame when they are given (joins): a smooth
/// line where they are one curve, else a corner with their true opening, counter-clockwise from the border
/// edge that leaves the vertex. It comes before tags.
struct FrameRequest {
  Index vertex = no_index;
  bool line = true;
  double opening = 0;  ///< 0 .. 2 pi, its sine not near zero; not used for a line
  friend bool operator==(const FrameRequest&, const FrameRequest&) = default;
};

/// `requests`: at border vertices where no crease ends, each at most once. Error: E_CORNER_NEEDS_CREASE where
/// an inner vertex tagged corner has fewer than two sharp edges.
Result<VertexFrames> build_vertex_frames(const Polyhedron& polyhedron, const Shaping& shaping,
                                         std::span<const FrameRequest> requests = {});

}  // namespace hariko

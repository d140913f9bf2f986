#pragma once

// Bevelling vertices: corners are cut off.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/modeled.hpp"

namespace hariko {

struct BevelVerticesOptions {
  double amount = 0;
  /// How far along every edge the cut lies. `distance`: a length; `share`: of the edge's length. Where both
  /// ends of an edge are cut, each end takes this much.
  enum class Measure { distance, share } measure = Measure::share;
};

/// Replaces each vertex by one new vertex on each of its edges, and by a face between them; at an inner
/// vertex with two edges and at a border vertex with two there is a new edge instead. The Euler number stays.
///
/// What is left of an edge keeps its tension and crease; the new vertices have the tension and tag of the one
/// cut off, whose pin is gone. A side of the new face is a crease where it runs between two creases, so that
/// a sharp corner is cut sharply; small faces get tension by `tighten_short_edges`. Selected afterwards: the
/// new faces (edges where there is no face).
///
/// Errors: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_BAD_AMOUNT (not above zero, or as long as an edge allows:
/// the cuts at its two ends would meet).
Result<Modeled> bevel_vertices(const PolyhedronSource& source, std::span<const VertexId> vertices,
                               const BevelVerticesOptions& options);

/// The amount that `bevel_vertices` refuses, with all larger ones. Errors: as above, of the selection.
Result<double> largest_vertex_bevel(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                    BevelVerticesOptions::Measure measure);

}  // namespace hariko

#pragma once

// Bevelling vertices: each corner is cut off.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

struct BevelVerticesOptions {
  double amount = 0;
  /// Distance of the cut from the vertex along every edge. `distance`: a length; `share`: a fraction of the
  /// edge's length. Where both ends of an edge are cut, each end loses this much.
  enum class Measure { distance, share } measure = Measure::share;
};

/// Replaces each vertex by one new vertex on each of its edges, and by a face between them; at an inner
/// vertex with two edges and at a border vertex with two there is a new edge instead. The Euler number stays.
///
/// The rest of each edge keeps its tension and crease; the new vertices have the tension and tag of the one
/// cut off, whose pin is gone. A side of the new face is a crease where it runs between two creases, so that
/// a sharp corner is cut sharply; small faces get tension by `tighten_short_edges`. Selected afterwards: the
/// new faces (edges where there is no face).
///
/// Errors: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_BAD_AMOUNT (not above zero, or as long as an edge allows:
/// the cuts at its two ends would meet), E_WRONG_SELECTION (a vertex without faces).
Result<EditResult> bevel_vertices(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                  const BevelVerticesOptions& options);

/// Returns the smallest amount that `bevel_vertices` refuses; it refuses all larger ones too. Errors: those
/// of `bevel_vertices` that concern the selection.
Result<double> largest_vertex_bevel(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                    BevelVerticesOptions::Measure measure);

}  // namespace hariko

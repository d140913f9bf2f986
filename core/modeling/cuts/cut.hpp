#pragma once

// Cutting: faces are split along new edges between points of their boundaries.

#include <span>
#include <variant>

#include "core/base/result.hpp"
#include "core/modeling/cuts/refined_points.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/modeling/surfacing/surface_form.hpp"

namespace hariko {

/// Connects selected points: in every face that has several of them, each with the next one round the face. A
/// selected edge stands for its midpoint, where it gets a vertex. Two points are not connected if they are
/// neighbours along a side, if an edge joins them already, or if the line between them would leave a concave
/// face.
///
/// New edges are plain. Pieces of edges keep tension and crease; points on edges get the interpolated
/// tension. Split faces pass their id to one part. The Euler number stays. Selected afterwards: the new
/// edges. Given `on`, the form of `source`, new points lie on the surface, which stays unchanged.
///
/// Errors: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_WRONG_SELECTION (nothing to connect).
Result<EditResult> connect_points(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                  std::span<const EdgeId> edges, const SurfaceForm* on = nullptr);

using CutPoint = std::variant<VertexId, EdgePoint>;

/// Cuts along a path: consecutive points must lie on a common face, and the line between them inside it.
/// Shaping, ids, selection and `on` as for `connect_points`; points along a side are joined by the side
/// itself. Errors: E_NOTHING_SELECTED (fewer than two different points), E_UNKNOWN_ELEMENT, E_BAD_AMOUNT,
/// E_WRONG_SELECTION (names the element where the path leaves the faces).
Result<EditResult> cut_path(const PolyhedronSource& source, std::span<const CutPoint> path,
                            const SurfaceForm* on = nullptr);

/// Splits one face between two of its corners. Errors: E_UNKNOWN_ELEMENT, E_WRONG_SELECTION (the vertices are
/// not corners of the face, are neighbours or are joined by an edge already, or the line between them leaves
/// the face).
Result<EditResult> split_face(const PolyhedronSource& source, FaceId face, VertexId a, VertexId b,
                              const SurfaceForm* on = nullptr);

}  // namespace hariko

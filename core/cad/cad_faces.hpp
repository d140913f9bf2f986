#pragma once

// Faces of a CAD model between given edges: exact splines where the surface is one, otherwise fits near it,
// with common tangent planes along smooth edges.

#include "core/base/progress.hpp"
#include "core/cad/cad_edges.hpp"

namespace hariko {

/// Faces without `sides`. A face is exact where the surface is a spline of the task's degree over the breaks
/// of its piece; otherwise it is a least-squares fit with knots inserted where the limits are missed. Along
/// smooth edges both faces are tied to common tangent planes: first the surface's, then the mean of the
/// planes that the two faces attain, so that faces agree also at corners where the surface itself has no
/// common second derivatives. The result is of no use once `cancel` is cancelled. Nothing where the faces
/// weigh more than `heaviest` (`weight_of`).
std::optional<std::vector<CadFace>> cad_faces(const EdgeTask& task, const CadEdges& edges,
                                              std::size_t heaviest, const CancelToken& cancel,
                                              const Progress& progress);

/// Weight of a face in a STEP file, in units of one control point (95 bytes): its control points, and 29 for
/// its loop, edges and vertices (2,780 bytes); measured over files of 20 to 400 faces.
inline std::size_t weight_of(const SplineSpace& s, const SplineSpace& t) {
  return s.size() * t.size() + 29;
}

/// Exact face of a piece, if the surface there is a spline of the task's degree, to rounding.
std::optional<CadFace> exact_cad_face(const EdgeTask& task, const CadEdges& edges, Index piece);

}  // namespace hariko

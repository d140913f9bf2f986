#pragma once

// Faces of a CAD model between given edges: splines that are the surface where there are such, others near
// it, and tangent planes in common along smooth edges.

#include "core/base/progress.hpp"
#include "core/cad/cad_edges.hpp"

namespace hariko {

/// Faces without `sides`. The surface itself where a spline of the task's degree over the breaks of its piece
/// is. Else a fit, with knots where they are needed. Along smooth edges both faces are tied to the same
/// tangent planes, which begin as the surface's and become those in the middle of what both faces reach, so
/// that faces agree also in corners where the surface itself has no common second derivatives. What is there
/// after `cancel` is cancelled is of no use. None where they weigh more than `heaviest` (`weight_of`).
std::optional<std::vector<CadFace>> cad_faces(const EdgeTask& task, const CadEdges& edges,
                                              std::size_t heaviest, const CancelToken& cancel,
                                              const Progress& progress);

/// Control points of a face, and as many more as its loop, edges and vertices weigh in a STEP file: of 95
/// bytes a control point and 2,780 a face, measured over files of 20 to 400 faces.
inline std::size_t weight_of(const SplineSpace& s, const SplineSpace& t) {
  return s.size() * t.size() + 29;
}

/// The face of a piece if it is a spline of the task's degree, to rounding.
std::optional<CadFace> exact_cad_face(const EdgeTask& task, const CadEdges& edges, Index piece);

}  // namespace hariko

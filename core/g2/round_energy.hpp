#pragma once

// Bending measured over a reference surface instead of over the face's flat chart (g2.md section 8).

#include <functional>

#include <Eigen/Core>

#include "core/g2/face_chart.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

/// Patch of the reference over a triangle of a face's chart.
using PatchOfSide = std::function<Index(int side)>;

/// Integral of the squared second covariant derivative, over the controls of the face. The metric is kept
/// above 1e-6 of its mean over the face, so that folds and points stay finite.
Eigen::MatrixXd round_plate(const FaceChart& chart, const PatchSet& reference, const PatchOfSide& patch);

/// Area of the reference over the area of all charts: brings the energy to the scale of the charts'.
double round_scale(const HalfEdgeMesh& mesh, const PatchSet& reference,
                   const std::function<const FaceChart&(Index)>& chart,
                   const std::function<Index(Index, int)>& half_edge);

}  // namespace hariko

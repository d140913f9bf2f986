#pragma once

// Bending measured over a reference surface instead of over the face's flat chart (g2.md section 8).

#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/g2/face_energy.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

/// The points of a patch of the reference (corners: the face's centre, and a side's ends) at
/// `reference_parameters()`, with both orders of derivatives. Thread-safe.
using ReferencePoints = std::function<void(Index patch, std::span<PatchPoint> points)>;
/// The quadrature's points in a patch.
std::vector<Vector2> reference_parameters();

/// Patch of the reference over a triangle of a face's chart.
using PatchOfSide = std::function<Index(int side)>;

/// Integral of the squared second covariant derivative, over the controls of the face. The metric is kept
/// above 1e-6 of its mean over the face, so that folds and points stay finite.
Eigen::MatrixXd round_plate(const ChartSamples& samples, const ReferencePoints& reference,
                            const PatchOfSide& patch);

/// Area of the reference over the area of all charts: brings the energy to the scale of the charts'.
double round_scale(const HalfEdgeMesh& mesh, const ReferencePoints& reference,
                   const std::function<const FaceChart&(Index)>& chart,
                   const std::function<Index(Index, int)>& half_edge);

}  // namespace hariko

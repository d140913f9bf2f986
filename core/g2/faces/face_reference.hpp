#pragma once

// Face references: the surface that a face's target curvature is taken from, at the points of the face's
// quadrature (g2.md section 8).

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "core/g2/faces/face_energy.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

/// Derivatives of the reference by the chart's x and y.
struct ReferencePoint {
  Vector3 x, y, xx, xy, yy;
};
/// Reference at the points of the quadrature, per side.
using FaceReference = std::vector<std::vector<ReferencePoint>>;

/// Evaluator of a reference's patches (corners: the face's centre, and a side's ends) at the barycentric
/// coordinates of some points, to second order. Thread-safe.
using ReferencePatches =
    std::function<void(Index patch, std::span<const ChartPoint> at, std::span<PatchPoint> points)>;

/// Reference from patches. `patch`: the reference's patch over each side's triangle.
FaceReference reference_of_patches(const ChartSamples& samples, const ReferencePatches& patches,
                                   const std::function<Index(int side)>& patch);
/// Reference from a surface of mode G2 with the same chart.
FaceReference reference_of_controls(const ChartSamples& samples, std::span<const Vector3> controls);

/// Area of the reference.
double area_of(const ChartSamples& samples, const FaceReference& reference);

}  // namespace hariko

#pragma once

// The surface that a face's target curvature is taken from, at the points of the face's quadrature (g2.md
// section 8).

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "core/g2/face_energy.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

/// Derivatives by the chart's x and y.
struct ReferencePoint {
  Vector3 x, y, xx, xy, yy;
};
/// Points of the quadrature, for each side.
using FaceReference = std::vector<std::vector<ReferencePoint>>;

/// The points of a patch of the reference (corners: the face's centre, and a side's ends) at the barycentric
/// places of some points, with both orders of derivatives. Thread-safe.
using ReferencePatches =
    std::function<void(Index patch, std::span<const ChartPoint> at, std::span<PatchPoint> points)>;

/// `patch`: of the reference over each side's triangle.
FaceReference reference_of_patches(const ChartSamples& samples, const ReferencePatches& patches,
                                   const std::function<Index(int side)>& patch);
/// A surface of mode G2 with the same chart.
FaceReference reference_of_controls(const ChartSamples& samples, std::span<const Vector3> controls);

double area_of(const ChartSamples& samples, const FaceReference& reference);

}  // namespace hariko

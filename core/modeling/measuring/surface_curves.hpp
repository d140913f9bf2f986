#pragma once

// Parts of surfaces by the elements that they come from: curves over edges, patches of faces, and their
// sizes.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/surface/surface.hpp"

namespace hariko {

/// Part of a side of a patch: from fraction `begin` of the side to fraction `end`.
struct SideCurve {
  PatchSide side;
  double begin = 0, end = 1;
};

/// Parameter of the point at fraction x of a curve, in the domain of its patch.
Vector2 curve_parameter(const Surface& surface, const SideCurve& curve, double x);
/// Point at fraction x of a curve, relative to the surface's origin.
Vector3 curve_point(const Surface& surface, const SideCurve& curve, double x);
/// Length of a curve, in the surface's space; to about 1e-6 of it where the curve is smooth.
double curve_length(const Surface& surface, const SideCurve& curve);
/// Area of patches together, in the surface's space, by 8 x 8 Gauss points a patch.
double patch_area(const Surface& surface, std::span<const Index> patches);

/// Curves and patches of a surface by the elements of the source, found quickly. In objects with a live
/// mirror the element's own come before those of its image. Refers to no surface: indices only.
class SurfaceElements {
 public:
  SurfaceElements() = default;
  /// O(n log n) of seams and patches.
  explicit SurfaceElements(const Surface& surface);

  std::vector<SideCurve> curves_over(EdgeId edge) const;
  std::vector<Index> patches_of(FaceId face) const;

 private:
  std::vector<std::pair<std::uint64_t, SideCurve>> curves_;  ///< by packed edges
  std::vector<std::pair<std::uint64_t, Index>> patches_;     ///< by faces
};

/// Curves over one edge, without an index of all. O(seams).
std::vector<SideCurve> curves_over(const Surface& surface, EdgeId edge);

}  // namespace hariko

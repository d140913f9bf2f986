#pragma once

// Sampling grid of a surface in world coordinates, on which contours are traced and which hides lines.

#include <vector>

#include "core/base/cancellation.hpp"
#include "core/drawing/line_drawing.hpp"

namespace hariko {

/// Points and normals of all patches on the same grid pattern.
class SurfaceGrid {
 public:
  /// Samples as finely as the page requires, with at most `largest` triangles.
  SurfaceGrid(const DrawnSurface& drawn, const DrawingView& view, std::size_t largest);

  const Surface& surface() const { return drawn_.surface; }
  const GridPattern& pattern() const { return pattern_; }
  const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
  const Vector3& position(Index patch, int point) const { return positions_[at(patch, point)]; }
  const Vector3& normal(Index patch, int point) const { return normals_[at(patch, point)]; }
  /// Estimated largest distance of a triangle from the surface, a length.
  double chord_error() const { return chord_error_; }

  struct Point {
    Vector3 position, normal;  ///< world; the normal is unit or zero
  };
  /// Point of the surface itself.
  Point evaluate(Index patch, const Vector2& parameter) const;
  /// Second fundamental form, in the tangential part of a world direction: positive where the surface bends
  /// towards its normal.
  double bending(Index patch, const Vector2& parameter, const Vector3& direction) const;

 private:
  std::size_t at(Index patch, int point) const {
    return std::size_t(patch) * std::size_t(pattern_.point_count()) + std::size_t(point);
  }
  Vector3 world_normal(const Vector3& normal) const {
    return (normals_to_world_ * normal).stableNormalized();
  }
  Vector3 world(const Vector3& local) const { return drawn_.transform * (drawn_.surface.origin() + local); }
  void choose_density(const DrawingView& view, std::size_t largest);
  void measure_chords();

  DrawnSurface drawn_;
  Matrix3 normals_to_world_;
  GridPattern pattern_{Domain::triangle, 1};
  std::vector<std::array<int, 3>> triangles_;
  std::vector<Vector3> positions_, normals_;
  double chord_error_ = 0;
};

}  // namespace hariko

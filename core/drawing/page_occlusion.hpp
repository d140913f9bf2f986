#pragma once

// Hidden-line removal: occluding triangles on the page, in bins.

#include <array>
#include <vector>

#include "core/drawing/drawing_view.hpp"

namespace hariko {

/// Visibility test of points against triangles. Thread-safe once all triangles are added.
class PageOcclusion {
 public:
  explicit PageOcclusion(const DrawingView& view);

  /// Adds a triangle, clipped to the kept side of the section and, in perspective, at half the distance of
  /// the near plane. Triangles outside the page are ignored.
  void add(const std::array<Vector3, 3>& triangle);
  /// Whether a triangle is nearer to the eye than a point, by more than `slack` (a length). All triangles
  /// must have been added. O(triangles of the bin).
  bool hides(const Vector3& point, double slack) const;

 private:
  struct Triangle {
    std::array<Vector2, 3> page;
    /// Larger is nearer; linear on the page: 1 / depth in perspective, -depth in orthographic views.
    std::array<double, 3> nearness;
  };
  double nearness(double depth) const { return view_.orthographic ? -depth : 1 / depth; }
  void add_clipped(const std::array<Vector3, 3>& triangle);
  int column(double x) const;
  int row(double y) const;

  DrawingView view_;
  int columns_, rows_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<std::uint32_t>> bins_;
};

}  // namespace hariko

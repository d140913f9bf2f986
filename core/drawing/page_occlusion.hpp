#pragma once

// What lies before a point of the page: triangles on the page, in bins.

#include <array>
#include <vector>

#include "core/drawing/drawing_view.hpp"

namespace hariko {

class PageOcclusion {
 public:
  explicit PageOcclusion(const DrawingView& view);

  /// What lies well before the near plane hides nothing, nor what the section cuts away or what is beside the
  /// page.
  void add(const std::array<Vector3, 3>& triangle);
  /// Is a triangle nearer to the eye than this point, by more than `slack` (length)? To be called after all
  /// triangles were added.
  bool hides(const Vector3& point, double slack) const;

 private:
  struct Triangle {
    std::array<Vector2, 3> page;
    /// Larger is nearer, linear on the page: 1 / depth in perspective, - depth when orthographic.
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

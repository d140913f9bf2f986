#pragma once

// Occlusion by surfaces, by a coarse depth buffer, for marks on or beside a surface.

#include <vector>

#include "render/camera.hpp"
#include "render/scene.hpp"

namespace hariko {

/// Depth buffer with cells of a few pixels. A point counts as hidden where all surfaces in the cells round it
/// are in front of it, so within about a cell of a silhouette nothing is hidden, and marks on the visible
/// side of a surface never are.
class SurfaceOcclusion {
 public:
  /// Draws the display meshes of objects. `cell`: pixels. Parts that the section cuts away and triangles that
  /// reach behind the eye hide nothing. Of meshes with more than 50,000 triangles only the corners of the
  /// patches are used. O(triangles + cells).
  SurfaceOcclusion(const std::vector<SceneObject>& objects, const std::optional<SectionPlane>& section,
                   const Projector& projector, double cell = 4);
  /// Whether surfaces hide a world point.
  bool hides(const Vector3& world) const;

 private:
  void add(const SceneObject& object, const std::optional<SectionPlane>& section);
  void draw(const Vector3& a, const Vector3& b, const Vector3& c);
  double nearness(double depth) const;

  Projector projector_;
  double cell_;
  int width_, height_;
  /// Nearness by cell: grows towards the eye and is linear on the screen; -infinity where there is no
  /// surface.
  std::vector<float> nearest_;
};

}  // namespace hariko

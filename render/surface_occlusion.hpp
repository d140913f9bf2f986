#pragma once

// What surfaces hide, by a coarse depth picture: for marks that lie on a surface or beside it.

#include <vector>

#include "render/camera.hpp"
#include "render/scene.hpp"

namespace hariko {

/// A depth picture with cells of a few pixels. A point is hidden where all surfaces round it are in front of
/// it; within about a cell of a silhouette nothing is, so that what lies on the visible side of a surface
/// never is hidden by it.
class SurfaceOcclusion {
 public:
  /// `cell`: in pixels. Of an object its display mesh and transform are used. What the section cuts away
  /// hides nothing, nor do triangles that reach behind the eye. Of meshes with more than 50,000 triangles
  /// only the corners of the patches are drawn. O(triangles + cells).
  SurfaceOcclusion(const std::vector<SceneObject>& objects, const std::optional<SectionPlane>& section,
                   const Projector& projector, double cell = 4);
  bool hides(const Vector3& world) const;

 private:
  void add(const SceneObject& object, const std::optional<SectionPlane>& section);
  void draw(const Vector3& a, const Vector3& b, const Vector3& c);
  double nearness(double depth) const;

  Projector projector_;
  double cell_;
  int width_, height_;
  /// Of each cell: grows towards the eye and is linear on the screen; -infinity where nothing is.
  std::vector<float> nearest_;
};

}  // namespace hariko

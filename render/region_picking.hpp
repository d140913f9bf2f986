#pragma once

// Picking by regions of the screen: lassos, and what the polyhedra themselves hide.

#include <span>
#include <vector>

#include "render/picking.hpp"

namespace hariko {

/// Elements of one object that lie wholly inside a closed polygon of pixels (even-odd rule). Edges and faces
/// do when all their vertices do. O(vertices * corners of the polygon).
Highlights pick_lasso(const SceneObject& object, const Projector& projector,
                      std::span<const Vector2> polygon);

/// A depth picture of the faces of all polyhedra of a scene: which of many elements can be seen. Faces that
/// reach behind the eye hide nothing, nor does what the section cuts away, which cannot be seen either.
/// O(faces * pixels).
class Occlusion {
 public:
  Occlusion(const Scene& scene, const Projector& projector);
  bool visible(const Vector3& world) const;
  /// Without the elements that are hidden: edges and faces stay when some point of them can be seen.
  Highlights visible(const Highlights& elements, const SceneObject& object) const;

 private:
  void draw(const Vector3& a, const Vector3& b, const Vector3& c);
  double nearness(double depth) const;

  Projector projector_;
  std::optional<SectionPlane> section_;
  std::vector<float>
      nearest_;  ///< grows towards the eye and is linear on the screen; 0 or less where nothing is
};

}  // namespace hariko

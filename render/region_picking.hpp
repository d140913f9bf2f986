#pragma once

// Picking by screen regions (box and lasso), and occlusion by the objects themselves.

#include <span>
#include <vector>

#include "render/picking.hpp"
#include "render/surface_occlusion.hpp"

namespace hariko {

/// Kinds of elements to pick.
struct ElementKinds {
  bool vertices = true, edges = true, faces = true;
};

/// Rectangle in pixels, corners in any order.
struct PixelBox {
  Vector2 first, second;
};
/// Elements of one object in a rectangle: wholly inside, or with `crossing` also those that it touches. Edges
/// and faces count as shown: by the curves and patches of the surface, by the lines of the polyhedron, or by
/// either where both show. Points behind the eye are outside. O(elements + vertices of the mesh).
Highlights pick_box(const SceneObject& object, const Projector& projector, const PixelBox& box, bool crossing,
                    const ElementKinds& kinds = {});

/// Elements of one object wholly inside a closed polygon of pixels (even-odd rule). O(points * corners of the
/// polygon).
Highlights pick_lasso(const SceneObject& object, const Projector& projector, std::span<const Vector2> polygon,
                      const ElementKinds& kinds = {});

/// Depth buffer of the faces of all polyhedra of a scene, to test many points for visibility. Faces that
/// reach behind the eye hide nothing; neither do parts that the section cuts away, which are not visible
/// either. O(faces * pixels).
class Occlusion {
 public:
  Occlusion(const Scene& scene, const Projector& projector);
  /// Whether a world point is visible: not cut away, and not behind a face by more than the length of
  /// `hiding_slack_pixels`, which are design pixels.
  bool visible(const Vector3& world) const;

 private:
  void draw(const Vector3& a, const Vector3& b, const Vector3& c);
  double nearness(double depth) const;

  Projector projector_;
  std::optional<SectionPlane> section_;
  double slack_;  ///< pixels of the framebuffer
  /// Nearness of the foremost face: grows towards the eye and is linear on the screen; -infinity where there
  /// is none.
  std::vector<float> nearest_;
};

/// Visibility of a scene's elements: elements on surfaces are tested against the surfaces, others against the
/// polyhedra.
class RegionSight {
 public:
  RegionSight(const Scene& scene, const Projector& projector);
  /// Visible ones of the elements: edges and faces stay where one of several sampled points is visible.
  Highlights visible(const Highlights& elements, const SceneObject& object) const;

 private:
  bool edge_visible(const SceneObject& object, Index edge) const;
  bool face_visible(const SceneObject& object, Index face) const;
  bool on_surface(const Vector3& world) const;

  std::optional<SectionPlane> section_;
  Occlusion polyhedra_;
  SurfaceOcclusion surfaces_;
};

}  // namespace hariko

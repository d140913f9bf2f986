#pragma once

// Picking by regions of the screen, boxes and lassos, and what the objects themselves hide.

#include <span>
#include <vector>

#include "render/picking.hpp"
#include "render/surface_occlusion.hpp"

namespace hariko {

/// Kinds of elements that are looked for.
struct ElementKinds {
  bool vertices = true, edges = true, faces = true;
};

/// A rectangle in pixels, corners in any order.
struct PixelBox {
  Vector2 first, second;
};
/// Elements of one object in a rectangle: wholly inside, or also those that it touches (crossing). Edges and
/// faces count as they are shown: by the curves and patches of the surface, by the lines of the polyhedron,
/// or by either where both show. Points behind the eye are outside. O(elements + vertices of the mesh).
Highlights pick_box(const SceneObject& object, const Projector& projector, const PixelBox& box, bool crossing,
                    const ElementKinds& kinds = {});

/// The same for a closed polygon of pixels (even-odd rule), wholly inside. O(points * corners of the
/// polygon).
Highlights pick_lasso(const SceneObject& object, const Projector& projector, std::span<const Vector2> polygon,
                      const ElementKinds& kinds = {});

/// A depth picture of the faces of all polyhedra of a scene: which of many elements can be seen. Faces that
/// reach behind the eye hide nothing, nor does what the section cuts away, which cannot be seen either.
/// O(faces * pixels).
class Occlusion {
 public:
  Occlusion(const Scene& scene, const Projector& projector);
  bool visible(const Vector3& world) const;

 private:
  void draw(const Vector3& a, const Vector3& b, const Vector3& c);
  double nearness(double depth) const;

  Projector projector_;
  std::optional<SectionPlane> section_;
  std::vector<float>
      nearest_;  ///< grows towards the eye and is linear on the screen; 0 or less where nothing is
};

/// Elements of a scene that can be seen: on surfaces by what the surfaces hide, else by what the polyhedra
/// hide.
class RegionSight {
 public:
  RegionSight(const Scene& scene, const Projector& projector);
  /// Without the elements that are hidden: edges and faces stay when some point of them can be seen.
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

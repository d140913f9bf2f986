#pragma once

// Picking by distance on the screen: vertices before edges before faces. Pure functions on the CPU.

#include <optional>
#include <vector>

#include "render/camera.hpp"
#include "render/scene.hpp"

namespace hariko {

/// Tolerance of occlusion tests, pixels: elements of an interpolated polyhedron lie on the surface and on
/// their own faces, which must not hide them.
inline constexpr double hiding_slack_pixels = 5;

/// Radii and kinds for picking.
struct PickOptions {
  double vertex_radius = 9, edge_radius = 6;  ///< design pixels; multiplied by the scene's `pixel_scale`
  bool vertices = true, edges = true, faces = true;
  /// Excludes elements behind the polyhedra's faces or the surfaces.
  bool visible_only = false;
  /// Finds vertices and edges at further places of objects, too, where they stand for the whole object.
  bool copies = false;
  /// Uses shown surfaces for picking faces (through provenance) and for occlusion.
  bool use_surface = true;
};

/// Picked element.
struct PickHit {
  std::size_t object = 0;  ///< index into the scene's objects
  Element::Kind kind = Element::Kind::none;
  /// Dense index into the display polyhedron; no_index for faces of objects without one.
  Index index = no_index;
  Element element;                  ///< stable identifier
  Vector3 point = Vector3::Zero();  ///< point of the element nearest to the cursor, world
  double distance = 0;              ///< pixels from the cursor; 0 for faces
  double depth = 0;                 ///< distance from the eye's plane
  bool on_curve = false;            ///< an edge that was found by its curve on the surface
  /// Fraction of an edge from its first vertex; nothing for the image of an edge in a live mirror.
  std::optional<double> share = std::nullopt;
};

/// Element under a pixel. Edges are found where they are shown: by their curves on the surface, by the
/// straight lines of the polyhedron, or both (see SceneObject). Among vertices (or edges) within the radius
/// the one nearest to the cursor wins, among equally near ones (within half a pixel) the one nearest to the
/// eye. O(elements).
std::optional<PickHit> pick(const Scene& scene, const Projector& projector, const Vector2& pixel,
                            const PickOptions& options = {});
/// All hits of the best kind within the radius, nearest first, for cycling through overlapping elements.
std::vector<PickHit> pick_all(const Scene& scene, const Projector& projector, const Vector2& pixel,
                              const PickOptions& options = {});

/// Point of a displayed surface.
struct SurfaceHit {
  std::size_t object = 0;
  Index patch = no_index;
  Vector2 parameter = Vector2::Zero();  ///< parameters in the patch
  Vector3 point = Vector3::Zero();      ///< world point on the display mesh
  double value = 0;  ///< map value there, may be infinite; NaN where undefined or without a map
  double t = 0;      ///< parameter of the ray
};
/// Foremost point of the shown surfaces on a ray, for the probe and for zooming to the cursor.
std::optional<SurfaceHit> pick_surface(const Scene& scene, const Ray& ray);

}  // namespace hariko

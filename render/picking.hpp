#pragma once

// Picking by distance on the screen: vertices before edges before faces. Pure mathematics on the CPU.

#include <optional>
#include <vector>

#include "render/camera.hpp"
#include "render/scene.hpp"

namespace hariko {

/// Elements of an interpolated polyhedron lie on the surface, and on the faces that they belong to: so many
/// pixels' length in front of them do not hide them.
inline constexpr double hiding_slack_pixels = 5;

struct PickOptions {
  double vertex_radius = 9, edge_radius = 6;  ///< design pixels: the scene's `pixel_scale` makes them larger
  bool vertices = true, edges = true, faces = true;
  /// Elements behind the polyhedron's own faces or the surface cannot be picked.
  bool visible_only = false;
  /// Surface counts for faces (through provenance) and for hiding, when it is shown.
  bool use_surface = true;
};

struct PickHit {
  std::size_t object = 0;  ///< index into the scene's objects
  Element::Kind kind = Element::Kind::none;
  Index index =
      no_index;     ///< dense index into the display polyhedron; no_index for faces of objects without one
  Element element;  ///< the stable id
  Vector3 point = Vector3::Zero();  ///< world point on the element nearest to the cursor
  double distance = 0;              ///< pixels from the cursor; 0 for faces
  double depth = 0;                 ///< from the eye's plane
  bool on_curve = false;            ///< an edge that was found by its curve on the surface
  /// Share of an edge from its first vertex; nothing for the image of an edge in a live mirror.
  std::optional<double> share = std::nullopt;
};

/// Finds what is under a pixel. Edges are found where they are shown: by their curves on the surface, by the
/// straight lines of the polyhedron, or both (see SceneObject). Of two vertices (or edges) within the radius
/// the nearer to the cursor wins, of equally near ones (within half a pixel) the nearer to the eye.
/// O(elements).
std::optional<PickHit> pick(const Scene& scene, const Projector& projector, const Vector2& pixel,
                            const PickOptions& options = {});
/// All hits of the best kind within the radius, nearest first: for cycling through overlapping elements.
std::vector<PickHit> pick_all(const Scene& scene, const Projector& projector, const Vector2& pixel,
                              const PickOptions& options = {});

struct SurfaceHit {
  std::size_t object = 0;
  Index patch = no_index;
  Vector2 parameter = Vector2::Zero();  ///< of the patch
  Vector3 point = Vector3::Zero();      ///< world, on the display mesh
  double value = 0;                     ///< of the map there, NaN when undefined or without a map
  double t = 0;                         ///< along the ray
};
/// The front-most point of the shown surfaces on a ray: for the probe and for zooming to the cursor.
std::optional<SurfaceHit> pick_surface(const Scene& scene, const Ray& ray);

}  // namespace hariko

#pragma once

// Scene: a plain description of what to draw. The user interface and the command line fill it, the renderer
// reads it.

#include <memory>
#include <optional>
#include <vector>

#include "core/base/vector.hpp"
#include "core/document/similarity.hpp"
#include "render/camera.hpp"
#include "render/color_map.hpp"
#include "render/display_mesh.hpp"
#include "render/display_polyhedron.hpp"
#include "render/edge_curves.hpp"
#include "render/scene_picture.hpp"
#include "render/surface_lines.hpp"

namespace hariko {

/// What stripes stand still with: the camera, the world, or each object.
enum class StripeLock : std::uint8_t { view, world, object };

/// Parallel light tubes reflected in the surface (zebra), or bands of equal angle between its normal and a
/// direction (isophotes, which do not move on the surface when the view turns but with the lock `view`).
struct ZebraSettings {
  int stripes = 9;                         ///< 2 .. 64 dark stripes over the whole sphere of directions
  Vector3 direction = {0.25, 0.15, 0.95};  ///< across the tubes, any length, in the axes that `lock` names
  StripeLock lock = StripeLock::view;
  friend bool operator==(const ZebraSettings&, const ZebraSettings&) = default;
};

/// Surfaces and polyhedra are cut away where normal . x > offset, in world coordinates: not drawn, not
/// picked.
struct SectionPlane {
  Vector3 normal = Vector3::UnitX();  ///< unit
  double offset = 0;
  bool cuts(const Vector3& world) const { return normal.dot(world) > offset; }
  friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

enum class Background { dark, light, transparent };

struct GridSettings {
  bool visible = true;
  double height = 0;   ///< z of the ground
  double spacing = 0;  ///< of the fine lines; 0 chooses a power of ten for the view
};

/// Object to world.
Matrix4 matrix_of(const Similarity& transform);

struct SceneObject {
  std::shared_ptr<const DisplayMesh> mesh;              ///< may be null: no surface yet
  std::shared_ptr<const DisplayPolyhedron> polyhedron;  ///< may be null
  /// The polyhedron's edges on the surface; null where its elements are not those of the surface.
  std::shared_ptr<const EdgeCurves> edge_curves;
  Matrix4 transform = Matrix4::Identity();  ///< object to world, a similarity

  SurfaceMap map = SurfaceMap::shaded;
  ValueRange range;  ///< for maps with values
  Material material = Material::clay;
  Color color = color_from_hex("#b9b4ac");  ///< of the outside, for `shaded` and `isophotes`

  bool show_surface = true;
  bool show_polyhedron = false;   ///< edges and points
  bool show_network = false;      ///< curves over source edges; creases and boundaries are drawn with it
  bool quiet_network = false;     ///< nobody drew those edges: their curves are thin and pale
  bool elements_pickable = true;  ///< vertices and edges: not those of a net that is not shown
  PatchWire wire = PatchWire::none;
  bool show_points = true;     ///< with the polyhedron
  bool show_bodies = false;    ///< faces of the polyhedron as translucent bodies, through the surface as well
  bool faint_bodies = false;   ///< of an object that cannot be edited
  bool show_tensions = false;  ///< colours of the polyhedron's edges and points
  bool x_ray = false;          ///< hidden lines and points show through faintly
  bool dimmed = false;         ///< the surface is not up to date

  std::shared_ptr<const EdgeMarks> marks;         ///< may be null
  std::shared_ptr<const CombLines> combs;         ///< may be null
  std::shared_ptr<const FacetLines> facet_edges;  ///< over the surface; may be null
  double comb_scale = 1;                          ///< times the automatic length of the teeth

  Highlights selected, hovered;
  Highlights failed;  ///< what the last rebuild complained about: outlined in red
  /// The silhouette of the surface is drawn round: of objects that are selected, or hovered, as a whole.
  bool outlined = false, outlined_as_hovered = false;
  /// Patches to tint, for instance those of selected faces; ascending.
  std::vector<Index> selected_patches, hovered_patches;

  bool draws_surface() const { return mesh && show_surface && mesh->patch_count() > 0; }
  /// The surface is drawn, and edges and faces of the polyhedron can be emphasised on it.
  bool elements_on_surface() const {
    return draws_surface() && edge_curves && edge_curves->curves == mesh->curves();
  }
  /// Pointing finds edges by their curves: where they are shown, or nothing else is that stands for edges.
  bool curves_pickable() const { return elements_on_surface() && (show_network || !show_polyhedron); }
  /// Pointing finds an edge by the straight line between its ends: where those are shown, or it has no curve.
  bool line_pickable(Index edge) const {
    return show_polyhedron || !curves_pickable() || !edge_curves->covers(edge);
  }
  /// A point relative to the mesh's or the polyhedron's origin in world axes.
  Vector3 to_world(const Vector3& origin, const std::array<float, 3>& p) const {
    const Vector3 local = origin + Vector3(double(p[0]), double(p[1]), double(p[2]));
    return transform.topLeftCorner<3, 3>() * local + transform.topRightCorner<3, 1>();
  }
  Vector3 mesh_vertex(std::size_t number) const {
    return to_world(mesh->origin(), mesh->vertex(number).position);
  }
  /// Box in world axes, empty when there is nothing to show.
  Box3 world_box() const;
  /// Appends points whose hull is what is shown, in world axes: at most about `limit` of each part.
  void add_outline(std::vector<Vector3>& points, std::size_t limit = 20'000) const;
};

/// Free geometry over the scene, in world coordinates: drag axes, snapping aids.
struct OverlayLine {
  Vector3 begin, end;
  Color color;
  float width = 1.5F;  ///< pixels
  bool on_top = true;  ///< not hidden by surfaces
};

struct Scene {
  std::vector<SceneObject> objects;
  std::vector<ScenePicture> pictures;
  std::vector<OverlayLine> lines;
  Background background = Background::dark;
  GridSettings grid;
  ZebraSettings zebra;
  std::optional<SectionPlane> section;
  bool colour_blind_safe = false;  ///< which tables colour the maps
  float hidden_opacity = 0.3F;     ///< of what x-ray shows through, times its own
  double pixel_scale = 1;          ///< framebuffer pixels per design pixel: scales line widths and points

  /// Box of the objects; pictures are what they stand before.
  Box3 world_box() const;
};

/// The camera with all of the scene visible, tight round what is shown. The first `left` pixel columns (less
/// than the width) stay free, for a legend. O(vertices).
Camera framed(const Camera& camera, const Scene& scene, PixelSize size, int left = 0);

}  // namespace hariko

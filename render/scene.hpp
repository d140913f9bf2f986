#pragma once

// Scene: a plain description of what to draw. The user interface and the command line fill it, the renderer
// reads it.

#include <memory>
#include <vector>

#include "core/base/vector.hpp"
#include "core/document/similarity.hpp"
#include "render/camera.hpp"
#include "render/color_map.hpp"
#include "render/display_mesh.hpp"
#include "render/display_polyhedron.hpp"

namespace hariko {

/// Stripes of parallel light tubes reflected in the surface.
struct ZebraSettings {
  int stripes = 9;                         ///< 2 .. 64 dark stripes over the whole sphere of directions
  Vector3 direction = {0.25, 0.15, 0.95};  ///< across the tubes, any length, in camera axes unless `fixed`
  bool fixed = false;     ///< direction in world axes: stripes stay on the object as the view turns
  double reflection = 1;  ///< 1 reflects the view, 0 uses the normal alone (isophotes)
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
  Matrix4 transform = Matrix4::Identity();              ///< object to world, a similarity

  SurfaceMap map = SurfaceMap::shaded;
  ValueRange range;  ///< for maps with values

  bool show_surface = true;
  bool show_polyhedron = false;  ///< edges and points
  bool show_network = false;     ///< curves over source edges; creases and boundaries are drawn with it
  bool show_split_edges = false;
  bool show_points = true;  ///< with the polyhedron
  bool x_ray = false;       ///< hidden lines and points show through faintly
  bool dimmed = false;      ///< the surface is not up to date

  Highlights selected, hovered;
  /// Patches to tint, for instance those of selected faces; ascending.
  std::vector<Index> selected_patches, hovered_patches;

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
  std::vector<OverlayLine> lines;
  Background background = Background::dark;
  GridSettings grid;
  ZebraSettings zebra;
  double pixel_scale = 1;  ///< framebuffer pixels per design pixel: scales line widths and points

  Box3 world_box() const;
};

/// The camera with all of the scene visible, tight round what is shown. The first `left` pixel columns (less
/// than the width) stay free, for a legend. O(vertices).
Camera framed(const Camera& camera, const Scene& scene, PixelSize size, int left = 0);

}  // namespace hariko

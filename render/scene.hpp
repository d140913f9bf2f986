#pragma once

// Scene: a plain description of what to draw, filled by the user interface and the command line, read by the
// renderer.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/text/enum_words.hpp"
#include "core/base/vector.hpp"
#include "core/document/picture_source.hpp"
#include "core/document/similarity.hpp"
#include "render/camera.hpp"
#include "render/color_map.hpp"
#include "render/display_mesh.hpp"
#include "render/display_polyhedron.hpp"
#include "render/edge_curves.hpp"
#include "render/environment.hpp"
#include "render/reference_image.hpp"
#include "render/surface_lines.hpp"

namespace hariko {

/// Reference picture with its placement.
struct ScenePicture {
  std::shared_ptr<const ReferenceImage> image;  ///< null: not decoded yet, or not found; only the frame shows
  bool missing = false;                         ///< file not found: the frame is crossed out
  Matrix4 transform = Matrix4::Identity();      ///< object to world, a similarity
  Vector2 half = {0.5, 0.5};                    ///< half of its sides, in object lengths
  PictureLook look;
  bool selected = false, hovered = false;  ///< draws a frame

  /// Whether the picture is visible for a camera: those for one viewing direction vanish while the view
  /// turns.
  bool seen_by(const Camera& camera) const;
  /// Corners in the world, counter-clockwise from the lower left one.
  std::array<Vector3, 4> corners() const;
  Vector3 middle() const { return transform.topRightCorner<3, 1>(); }
  /// Ray parameter of the intersection with the picture, as a multiple of the ray's direction.
  std::optional<double> hit(const Ray& ray) const;

  friend bool operator==(const ScenePicture&, const ScenePicture&) = default;
};

/// Frame of reference of zebra stripes and isophotes.
enum class StripeLock : std::uint8_t {
  view,
  world,
  object,
  /// Zebra: a ceiling of tubes over the scene, at a finite distance, so that each place mirrors another part
  /// of it. Isophotes: as `world`.
  tubes
};

/// Reflection stripes of parallel light tubes (zebra), or bands of equal angle between the normal and a
/// direction (isophotes, which move on the surface with the view only for the lock `view`).
struct ZebraSettings {
  /// 2 .. 64 dark stripes over the whole sphere of directions; of a ceiling, within two diagonals of the
  /// scene.
  int stripes = 9;
  Vector3 direction = {0.25, 0.15, 0.95};  ///< across the tubes, any length, in the axes that `lock` gives
  StripeLock lock = StripeLock::view;
  friend bool operator==(const ZebraSettings&, const ZebraSettings&) = default;
};

/// Section plane in world coordinates. Parts of surfaces and polyhedra with normal . x > offset are neither
/// drawn nor picked.
struct SectionPlane {
  Vector3 normal = Vector3::UnitX();  ///< unit
  double offset = 0;
  bool cuts(const Vector3& world) const { return normal.dot(world) > offset; }
  friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

/// Backgrounds of a picture.
enum class Background { dark, light, transparent };
template <>
inline constexpr auto enum_words<Background> = all_words<Background>(
    {{Background::dark, "dark"}, {Background::light, "light"}, {Background::transparent, "transparent"}});

/// Grid on the ground, or on a plane of its own.
struct GridSettings {
  bool visible = true;
  double height = 0;   ///< z of the ground plane
  double spacing = 0;  ///< spacing of the fine lines; 0 chooses a power of ten for the view
  /// Zero and orthonormal axes (columns: x, y, normal) of another plane than the ground.
  struct Plane {
    Vector3 point;
    Matrix3 axes;
    friend bool operator==(const Plane&, const Plane&) = default;
  };
  std::optional<Plane> plane = std::nullopt;
  friend bool operator==(const GridSettings&, const GridSettings&) = default;
};

/// Matrix from object to world.
Matrix4 matrix_of(const Similarity& transform);

/// Object as it is displayed.
struct SceneObject {
  std::shared_ptr<const DisplayMesh> mesh;              ///< may be null: no surface yet
  std::shared_ptr<const DisplayPolyhedron> polyhedron;  ///< may be null
  /// Curves on the surface that represent the polyhedron's edges; null where the surface's elements are not
  /// the polyhedron's.
  std::shared_ptr<const EdgeCurves> edge_curves;
  Matrix4 transform = Matrix4::Identity();  ///< object to world, a similarity
  /// A further place of an object that the scene has already: it shares its buffers. Its vertices and edges
  /// are not picked, unless they stand for the whole (`PickOptions::copies`).
  bool copy = false;

  SurfaceMap map = SurfaceMap::shaded;
  ValueRange range;  ///< for maps with values
  Material material = Material::clay;
  Color color = color_from_hex("#b9b4ac");  ///< colour of the outside, for `shaded` and `isophotes`

  bool show_surface = true;
  bool show_polyhedron = false;   ///< edges and points
  bool show_network = false;      ///< curves over source edges; creases and boundaries are drawn with it
  bool quiet_network = false;     ///< thin, pale curves and no marks of pins, for edges that nobody drew
  bool elements_pickable = true;  ///< vertices and edges; false for nets that are not shown
  PatchWire wire = PatchWire::none;
  bool show_points = true;     ///< together with the polyhedron
  bool show_bodies = false;    ///< faces of the polyhedron as translucent bodies, also through the surface
  bool faint_bodies = false;   ///< for objects that cannot be edited
  bool show_tensions = false;  ///< colours edges and points of the polyhedron by tension
  bool x_ray = false;          ///< hidden lines and points show through faintly
  bool dimmed = false;         ///< the surface is out of date

  std::shared_ptr<const EdgeMarks> marks;         ///< may be null
  std::shared_ptr<const CombLines> combs;         ///< may be null
  std::shared_ptr<const FacetLines> facet_edges;  ///< drawn over the surface; may be null
  double comb_scale = 1;                          ///< factor of the automatic length of the teeth

  Highlights selected, hovered;
  Highlights failed;  ///< faulty elements of the last rebuild, outlined in red
  /// Whether the silhouette of the surface is outlined: for objects that are selected or hovered as a whole.
  bool outlined = false, outlined_as_hovered = false;
  /// Patches to tint, for instance those of selected faces; ascending.
  std::vector<Index> selected_patches, hovered_patches;

  bool draws_surface() const { return mesh && show_surface && mesh->patch_count() > 0; }
  /// Whether edges and faces of the polyhedron can be emphasised on the drawn surface.
  bool elements_on_surface() const {
    return draws_surface() && edge_curves && edge_curves->curves == mesh->curves();
  }
  /// Whether edges are picked by their curves: where these are shown, or nothing else represents the edges.
  bool curves_pickable() const { return elements_on_surface() && (show_network || !show_polyhedron); }
  /// Whether an edge is picked by its straight line: where lines are shown, or the edge has no curve.
  bool line_pickable(Index edge) const {
    return show_polyhedron || !curves_pickable() || !edge_curves->covers(edge);
  }
  /// World position of a point that is relative to the mesh's or the polyhedron's origin.
  Vector3 to_world(const Vector3& origin, const std::array<float, 3>& p) const {
    const Vector3 local = origin + Vector3(double(p[0]), double(p[1]), double(p[2]));
    return transform.topLeftCorner<3, 3>() * local + transform.topRightCorner<3, 1>();
  }
  Vector3 mesh_vertex(std::size_t number) const {
    return to_world(mesh->origin(), mesh->vertex(number).position);
  }
  /// Bounding box in the world; empty where nothing is shown.
  Box3 world_box() const;
  /// Appends world points whose hull contains what is shown: at most about `limit` for each part.
  void add_outline(std::vector<Vector3>& points, std::size_t limit = 20'000) const;
  friend bool operator==(const SceneObject&, const SceneObject&) = default;
};

/// Free line over the scene, in world coordinates: drag axes, snapping aids.
struct OverlayLine {
  Vector3 begin, end;
  Color color;
  float width = 1.5F;  ///< pixels
  bool on_top = true;  ///< not hidden by surfaces
  friend bool operator==(const OverlayLine&, const OverlayLine&) = default;
};

/// Lines of one look over the surfaces, in world coordinates.
struct SceneLines {
  std::shared_ptr<const FacetLines> lines;  ///< not null
  Color color;
  float width = 1.5F;  ///< pixels
  friend bool operator==(const SceneLines&, const SceneLines&) = default;
};

/// Everything that a picture shows.
struct Scene {
  std::vector<SceneObject> objects;
  std::vector<ScenePicture> pictures;
  std::vector<OverlayLine> lines;
  std::vector<SceneLines> curves;  ///< such as section curves; later ones are drawn over earlier ones
  Background background = Background::dark;
  GridSettings grid;
  ZebraSettings zebra;
  Environment environment;  ///< reflected by what is `shaded`
  std::optional<SectionPlane> section;
  bool colour_blind_safe = false;  ///< selects the colour scales of maps
  float hidden_opacity = 0.3F;     ///< opacity of x-ray parts, multiplied by their own
  double pixel_scale = 1;          ///< framebuffer pixels per design pixel; scales line widths and points

  /// Bounding box of the objects; pictures are excluded, being a background.
  Box3 world_box() const;
  friend bool operator==(const Scene&, const Scene&) = default;
};

/// Camera with the whole scene visible, fitted tightly. The first `left` pixel columns (fewer than the width)
/// stay free for a legend. O(vertices).
Camera framed(const Camera& camera, const Scene& scene, PixelSize size, int left = 0);

/// Whether a curve runs from the first vertex of its edge to the second (true) or the other way; nothing
/// where it does not connect them, as for the image of an edge in a live mirror.
std::optional<bool> runs_forward(const SceneObject& object, Index edge, const EdgeCurves::Run& run);

/// Displayed curve of an edge, in world space from the edge's first vertex to its second, in equal steps of
/// its fraction; empty where the edge is not picked by a curve of its own.
std::vector<Vector3> shown_curve(const SceneObject& object, Index edge);

}  // namespace hariko

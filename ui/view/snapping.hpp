#pragma once

// Snapping: places that a drag or a drawing jumps to.

#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/curve_places.hpp"
#include "core/modeling/objects/plane_frame.hpp"
#include "ui/view/tool.hpp"
#include "ui/view/transform_target.hpp"

namespace hariko {

struct SnapTarget {
  enum class Kind { vertex, midpoint, centre, crossing, perpendicular, tangent, curve, surface, grid };
  Kind kind = Kind::grid;
  Vector3 point = Vector3::Zero();  ///< in the document's space
  /// The object that has it, of a crossing the one in front; none of the grid.
  std::optional<ObjectId> object = std::nullopt;
};

/// Name of a kind of target, in English: "Vertex", "Intersection".
const char* snap_name(SnapTarget::Kind kind);

/// Design pixels round the pointer within which a place attracts.
inline constexpr double snap_radius = 14;

/// Whether a gesture snaps: while Ctrl is held, or while it is not, as the settings say.
bool snaps_now(const Editor& editor, bool control);

/// Search for a target: its kinds, and the gesture that asks.
struct SnapGesture {
  SnapSettings kinds;
  std::optional<Vector3> from = std::nullopt;  ///< its beginning; without it nothing is perpendicular
  Vector3 normal = Vector3::UnitZ();           ///< tangents are meant as seen along it
  const TransformTarget* moving = nullptr;     ///< target not caught, as it moves; null: nothing moves
};

/// Places that can be caught, as they are when a gesture begins, so that where it snaps does not depend on
/// how far it was dragged before. Places of edges are where the edge is shown: on its curve on the surface,
/// on the straight line of the polyhedron, or both. Curves are known by the samples that are drawn.
class SnapPlaces {
 public:
  SnapPlaces() = default;
  /// Places of these kinds of the committed document, which the scene shows. O(elements), for kinds on curves
  /// O(samples of all curves).
  SnapPlaces(const ToolContext& context, const SnapSettings& kinds);

  /// The one under the pointer: vertices first, then the nearest of the other points, then curves, then the
  /// surface. Without the grid. O(places).
  std::optional<SnapTarget> nearest(const ToolContext& context, const SnapGesture& gesture,
                                    const Vector2& pixel) const;

 private:
  /// Vertices that move a place when they move: a part of `vertices_of_`.
  struct Held {
    ObjectId object;
    std::size_t first = 0, count = 0;
  };
  struct Place {
    Held held;
    Vector3 point;  ///< in the document's space
  };
  struct Curve {
    Held held;
    SampledCurve line;  ///< in the document's space
  };
  /// A span of a curve near the pointer, on the picture.
  struct NearSpan {
    const Curve* curve;
    std::size_t span;
    Vector2 begin, end;
    double distance;  ///< pixels from the pointer
  };
  class Search;

  Held hold(ObjectId object, std::initializer_list<VertexId> vertices);
  Held hold(ObjectId object, const std::vector<VertexId>& vertices);
  bool stands(const SnapGesture& gesture, const Held& held) const;

  /// Adds the places of an object, by its kind.
  void add_object(const ToolContext& context, std::size_t scene_object, const Object& object,
                  const SnapSettings& kinds);
  void add_cage(const ToolContext& context, std::size_t scene_object, const Object& object,
                const SnapSettings& kinds);
  void add_edges(const ToolContext& context, std::size_t scene_object, const Object& object,
                 const SnapSettings& kinds);
  void add_solids(const ToolContext& context, std::size_t scene_object, const Object& object,
                  const SnapSettings& kinds);
  void add_drawn_curve(const Object& object, const SubdivisionCurve& curve, const std::vector<VertexId>& ids,
                       const SnapSettings& kinds);
  void add_skin(const Object& object, const SnapSettings& kinds);
  void add_outline(const Object& object, const SnapSettings& kinds);
  void add_curve(const Held& held, std::vector<Vector3> points, bool closed);

  void look_along_curves(const SnapGesture& gesture, Search& search) const;
  std::vector<NearSpan> near_spans(const SnapGesture& gesture, const Search& search) const;
  static void look_for_crossings(const std::vector<NearSpan>& spans, Search& search);
  static void look_on_curves(const std::vector<NearSpan>& spans, Search& search);
  static void look_on_surfaces(const ToolContext& context, const SnapGesture& gesture, Search& search);

  std::vector<VertexId> vertices_of_;
  std::vector<Place> vertices_, middles_, centres_;
  std::vector<Curve> curves_;
};

/// A decimal step: mantissa * 10^exponent.
struct DecimalStep {
  int mantissa = 1, exponent = 0;
  double size() const;
  /// The multiple nearest to a value, as near to the decimal number as a double can be.
  double nearest(double value) const;
  DecimalStep tenth() const { return {mantissa, exponent - 1}; }
};

/// A power of ten that covers at least 10 design pixels: the lines of the ground grid or a tenth of them.
DecimalStep grid_step(const ToolContext& context, const Vector3& at);

/// The point of a plane's grid next to one of its points.
Vector3 on_grid(const ToolContext& context, const PlaneFrame& plane, const Vector3& point);

/// Point where a ray of the eye meets a plane, on the steps of its grid when it snaps to that; nothing near
/// the horizon, where places run away from the pointer, and behind the eye.
std::optional<Vector3> point_on_plane(const ToolContext& context, const PlaneFrame& plane, const Ray& ray,
                                      bool snaps);

/// A value; copies share the places.
class SnapCatcher {
 public:
  /// Call before anything is caught: collects the places anew where the document, a surface or the kinds are
  /// others.
  void update(const ToolContext& context);
  /// The place under a pixel, of the kinds of the settings; nothing but the grid: see `SnapPlaces`. `from`:
  /// where the gesture began; `normal`: of the plane that is drawn in.
  std::optional<SnapTarget> find(const ToolContext& context, const Vector2& pixel,
                                 const std::optional<Vector3>& from, const Vector3& normal) const;

  /// Collected places; null before the first update.
  const SnapPlaces* places() const { return places_.get(); }

 private:
  std::shared_ptr<const SnapPlaces> places_;
  SnapSettings kinds_;
  // Document and settings that the places were collected from.
  std::uint64_t document_ = 0, serial_ = 0;
  std::vector<std::shared_ptr<const DisplayMesh>> meshes_;
};

/// Draws the mark of what was caught, one shape for each kind, and its name above it.
void draw_snap_target(const ToolContext& context, const ToolOverlay& overlay, const SnapTarget& target,
                      bool warning = false);

}  // namespace hariko

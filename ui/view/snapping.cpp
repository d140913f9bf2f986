#include "ui/view/snapping.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace hariko {

namespace {

/// 10^n for n >= 0, exact up to 10^22.
double power_of_ten(int n) {
  double power = 1;
  for (int i = 0; i < n; ++i) power *= 10;
  return power;
}

/// The middle of a curve as the surface has it, of which the mesh is a picture; in the object's space.
/// `parameters`: of the mesh's pattern.
Vector3 middle_of_curve(const Surface& surface, std::span<const Vector2> parameters,
                        std::span<const CurveSegment> segments) {
  const CurveSegment& middle = segments[segments.size() / 2];
  const auto per_patch = static_cast<Index>(parameters.size());
  const Vector2& begin = parameters[middle.vertices[1] % per_patch];
  const Vector2& end = parameters[middle.vertices[2] % per_patch];
  const Vector2 at = segments.size() % 2 == 0 ? begin : Vector2((begin + end) / 2);
  return surface.origin() +
         surface.patches().evaluate(middle.vertices[1] / per_patch, at, Order::first).position;
}

}  // namespace

double DecimalStep::size() const {
  return exponent < 0 ? mantissa / power_of_ten(-exponent) : mantissa * power_of_ten(exponent);
}

double DecimalStep::nearest(double value) const {
  const double count = std::round(value / size()) * mantissa;
  return exponent < 0 ? count / power_of_ten(-exponent) : count * power_of_ten(exponent);
}

DecimalStep grid_step(const ToolContext& context, const Vector3& at) {
  constexpr double least_pixels = 10;
  const double length = least_pixels * context.editor.pixel_scale * context.projector().pixel_length_at(at);
  return {1, std::clamp(static_cast<int>(std::ceil(std::log10(length))), -12, 12)};
}

std::optional<Vector3> point_on_ground(const ToolContext& context, const Ray& ray, bool snaps) {
  constexpr double least_slope = 0.02;
  if (std::abs(ray.direction.z()) < least_slope) return {};
  const double t = -ray.origin.z() / ray.direction.z();
  if (!(t > 0)) return {};
  Vector3 point = ray.at(t);
  point.z() = 0;
  if (snaps) {
    const DecimalStep step = grid_step(context, point);
    for (int axis = 0; axis < 2; ++axis) point[axis] = step.nearest(point[axis]);
  }
  return point;
}

SnapPlaces::SnapPlaces(const ToolContext& context) {
  const Document& document = context.editor.history.current();
  const Scene& scene = context.scene.scene();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object* object = document.find(context.scene.object_id(i));
    const Polyhedron* cage = object && object->visible ? object->cage() : nullptr;
    if (!cage) continue;
    for (Index v = 0; v < cage->vertex_count(); ++v)
      vertices_.push_back({object->id, cage->vertex_id(v), cage->vertex_id(v),
                           object->transform.apply(object->cage_origin() + cage->position(v))});
    if (scene.objects[i].polyhedron) add_middles(context, i, *object);
  }
}

void SnapPlaces::add_middles(const ToolContext& context, std::size_t scene_object, const Object& object) {
  const SceneObject& shown = context.scene.scene().objects[scene_object];
  const SurfaceView* view = context.editor.view_of(object.id);
  const bool curves = shown.curves_pickable() && view && view->mesh == shown.mesh;
  const std::vector<Vector2> parameters =
      curves ? shown.mesh->pattern().parameters() : std::vector<Vector2>();
  const Polyhedron& cage = *object.cage();
  for (Index e = 0; e < shown.polyhedron->edges.size(); ++e) {
    const EdgeId id = shown.polyhedron->edge_id(e);
    const Index low = cage.find(id.low), high = cage.find(id.high);
    if (low == no_index || high == no_index) continue;
    if (shown.line_pickable(e))
      middles_.push_back(
          {object.id, id.low, id.high,
           object.transform.apply(object.cage_origin() + (cage.position(low) + cage.position(high)) / 2)});
    if (!curves) continue;
    for (const EdgeCurves::Run& run : shown.edge_curves->of(e))
      middles_.push_back({object.id, id.low, id.high,
                          object.transform.apply(
                              middle_of_curve(view->surface, parameters, shown.edge_curves->segments(run)))});
  }
}

std::optional<SnapTarget> SnapPlaces::nearest(const ToolContext& context, const TransformTarget& target,
                                              const Vector2& pixel) const {
  const Projector projector = context.projector();
  std::optional<SnapTarget> best;
  double least = snap_radius * context.editor.pixel_scale;
  const auto look = [&](SnapTarget::Kind kind, const std::vector<Place>& places) {
    for (const Place& place : places) {
      const auto at = projector.project(place.point);
      const double distance = at ? (at->head<2>() - pixel).norm() : least;
      if (distance >= least || !target.stands(place.object, place.a) || !target.stands(place.object, place.b))
        continue;
      least = distance;
      best = {kind, place.point};
    }
  };
  look(SnapTarget::Kind::vertex, vertices_);
  if (!best) look(SnapTarget::Kind::midpoint, middles_);
  return best;
}

}  // namespace hariko

#include "ui/tools/snapping.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

/// 10^n for n >= 0, exact up to 10^22.
double power_of_ten(int n) {
  double power = 1;
  for (int i = 0; i < n; ++i) power *= 10;
  return power;
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

std::optional<SnapTarget> snap_to_elements(const ToolContext& context, const TransformTarget& target,
                                           const Vector2& pixel) {
  const Projector projector = context.projector();
  std::optional<SnapTarget> best;
  double least = snap_radius * context.editor.pixel_scale;
  const auto offer = [&](SnapTarget::Kind kind, const Vector3& point) {
    const auto at = projector.project(point);
    if (!at) return;
    const double distance = (at->head<2>() - pixel).norm();
    if (distance >= least) return;
    least = distance;
    best = {kind, point};
  };
  // Of the committed document: what moves is not looked at, and its place must not depend on the last frame.
  const auto each = [&](const auto& visit) {
    for (const auto& object : context.editor.history.current().objects)
      if (object->visible && object->cage()) visit(*object, *object->cage());
  };
  const auto world = [](const Object& object, const Polyhedron& cage, Index v) {
    return object.transform.apply(object.cage_origin() + cage.position(v));
  };
  each([&](const Object& object, const Polyhedron& cage) {
    for (Index v = 0; v < cage.vertex_count(); ++v)
      if (target.stands(object.id, cage.vertex_id(v)))
        offer(SnapTarget::Kind::vertex, world(object, cage, v));
  });
  if (best) return best;
  each([&](const Object& object, const Polyhedron& polyhedron) {
    for (Index e = 0; e < polyhedron.edge_count(); ++e) {
      const EdgeId id = polyhedron.edge_id(e);
      if (!target.stands(object.id, id.low) || !target.stands(object.id, id.high)) continue;
      offer(SnapTarget::Kind::midpoint, (world(object, polyhedron, polyhedron.find(id.low)) +
                                         world(object, polyhedron, polyhedron.find(id.high))) /
                                            2);
    }
  });
  return best;
}

}  // namespace hariko

#include "ui/editor/probe.hpp"

#include <cmath>

#include "render/picking.hpp"

namespace hariko {

std::optional<SurfacePoint> surface_point(const SceneBuilder& scene, const Ray& ray) {
  const auto hit = pick_surface(scene.scene(), ray);
  // Readings belong to the object's own place.
  if (!hit || scene.scene().objects[hit->object].copy) return std::nullopt;
  return SurfacePoint{scene.object_id(hit->object), hit->patch, hit->parameter, hit->value};
}

std::string map_value_text(const Editor& editor, const Language& tr, const SurfacePoint& point) {
  const Object* object = editor.document().find(point.object);
  const ViewMap& view = editor.view.map;
  const SurfaceMap map = object ? shown_map(view, *object) : SurfaceMap::shaded;
  if (!has_values(map)) return {};
  // The view's colours are those of the world, where a scaled object is curved less.
  const double divisor =
      follows_view(view, *object) ? std::pow(object->transform.scale, scale_power(map)) : 1.0;
  const double value = point.value / divisor;
  const std::string unit = unit_of(map, to_string(editor.document().unit));
  if (map == SurfaceMap::radius && std::isinf(value)) return tr("flat");
  if (!std::isfinite(value)) return tr("undefined");
  const std::string number = format_number(value, 4);
  if (map != SurfaceMap::draft) return number + " " + unit;
  return value < 0 ? number + unit + "  " + tr("undercut") : number + unit;
}

std::optional<ProbeReading> read_probe(const Editor& editor, const SurfacePoint& point) {
  const Object* object = editor.document().find(point.object);
  const SurfaceView* view = editor.view_of(point.object);
  if (!object || !object->visible || !view || point.patch >= view->surface.patch_count()) return std::nullopt;
  const Surface& surface = view->surface;
  const PatchPoint at = surface.patches().evaluate(point.patch, point.parameter, Order::second);
  ProbeReading reading;
  reading.position = object->transform.apply(surface.origin() + at.position);
  reading.normal = object->transform.rotation * surface.normal(point.patch, point.parameter);
  reading.curvature = curvature(at);
  if (reading.curvature) {
    // Curvature is one over a length.
    const double scale = object->transform.scale;
    reading.curvature->k1 /= scale;
    reading.curvature->k2 /= scale;
    reading.curvature->mean /= scale;
    reading.curvature->gauss /= scale * scale;
  }
  return reading;
}

}  // namespace hariko

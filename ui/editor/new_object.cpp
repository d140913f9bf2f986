#include "ui/editor/new_object.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

/// 1, 2 or 5 times a power of ten.
double nice_length(double length) {
  const double power = std::pow(10, std::floor(std::log10(length)));
  const double lead = length / power;
  return (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * power;
}

}  // namespace

void begin_document(Editor& editor) {
  if (editor.has_document) return;
  Document document;
  document.unit = editor.settings.unit;
  editor.open(std::move(document), std::nullopt);
}

double new_object_radius(const Editor& editor) {
  Box3 box;
  for (const auto& object : editor.document().objects)
    if (object->visible) box.extend(world_box(*object));
  const double extent = box.isEmpty() ? 0 : box.sizes().maxCoeff();
  if (extent > 0 && std::isfinite(extent)) return nice_length(std::clamp(extent / 4, 1e-6, 1e6));
  return first_object_radius(editor.document().unit);
}

void bring_into_sight(Editor& editor, ObjectId object) {
  bring_into_sight(editor, std::span(&object, 1));
}

void bring_into_sight(Editor& editor, std::span<const ObjectId> objects) {
  const Projector projector(editor.camera(), editor.viewport);
  const auto inside = [&](const Vector3& corner) {
    const auto at = projector.project(corner);
    return at && at->x() >= 0 && at->y() >= 0 && at->x() <= editor.viewport.width &&
           at->y() <= editor.viewport.height;
  };
  for (const ObjectId object : objects) {
    const Object* found = editor.document().find(object);
    const Box3 box = found ? world_box(*found) : Box3();
    for (int i = 0; i < 8 && !box.isEmpty(); ++i)
      if (!inside(box.corner(static_cast<Box3::CornerType>(i)))) return editor.frame_all();
  }
}

double first_object_radius(Unit unit) {
  constexpr double radius = 50;  // mm
  return nice_length(radius / millimetres_per(unit));
}

}  // namespace hariko

#include "app/files/walled_surface.hpp"

#include <utility>

namespace hariko {

namespace {

Message with_object_name(Message message, const Object& object) {
  if (!object.name.empty()) message.text = object.name + ": " + message.text;
  return message;
}

}  // namespace

Result<ObjectSurface> walled_surface(const Document& document, const Object& object, const Wall& wall,
                                     FoldedWalls folds, const CancelToken& cancel) {
  auto built = object_surface(document, object, cancel);
  if (cancel.cancelled()) return make_error(e_cancelled, "The export was cancelled.");
  if (!built.ok()) return with_object_name(built.error(), object);
  ObjectSurface out = std::move(built).value();
  out.warnings.clear();
  if (wall.none()) return out;
  auto made = wall_surface(out.surface, wall, object.transform.scale, cancel);
  if (!made.ok()) {
    if (made.error().code == e_cancelled) return made.error();
    return with_object_name(made.error(), object);
  }
  out.surface = std::move(made.value().surface);
  for (const Message& warning : made->warnings) {
    if (warning.code == w_offset_folds && folds == FoldedWalls::refuse)
      return with_object_name(make_error(e_offset_folds, warning.text, warning.remedy, warning.element),
                              object);
    out.warnings.push_back(with_object_name(warning, object));
  }
  return out;
}

std::optional<Message> why_no_wall(const Document& document, const Wall& wall) {
  if (wall.none()) return {};
  for (const auto& object : document.objects)
    if (object->visible && object->mesh())
      return make_error(e_offset_facets,
                        object->name + ": Reference facets have no smooth surface to keep a distance from.",
                        "Hide the object, or make a polyhedron of it first.");
  return {};
}

}  // namespace hariko

#include "app/files/walled_surface.hpp"

#include <utility>

#include "core/document/object_shape.hpp"
#include "core/exchange/repair/triangulate.hpp"
#include "core/surface/facets.hpp"

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
    if (object->visible && is_faceted(*object))
      return make_error(e_offset_facets,
                        object->name + ": Reference facets have no smooth surface to keep a distance from.",
                        "Hide the object, or make a polyhedron of it first.");
  return {};
}

TriangleMesh triangles_of(const MeshSource& source) {
  return {source.origin, source.mesh->positions, triangulate(*source.mesh).triangles, {}, {}};
}

Surface facets_of(const MeshSource& source) {
  FaceTriangles cut = triangulate(*source.mesh);
  std::vector<Element> sources;
  sources.reserve(cut.faces.size());
  for (const Index face : cut.faces) sources.push_back({Element::Kind::face, face});
  return facet_surface(source.origin, source.mesh->positions, std::move(cut.triangles), sources);
}

Result<Surface> surface_or_facets(const Document& document, const Object& object, const CancelToken& cancel) {
  if (is_faceted(object)) return facets_of(*object.mesh());
  auto built = object_surface(document, object, cancel);
  if (!built.ok()) return built.error();
  return std::move(built).value().surface;
}

}  // namespace hariko

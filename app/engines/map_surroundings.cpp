#include "app/engines/map_surroundings.hpp"

#include "core/document/edits/edit_making.hpp"
#include "core/document/object_shape.hpp"

namespace hariko {

namespace {

bool is_same_surface(const Surface& a, const Surface& b) {
  if (a.patch_count() == 0 || b.patch_count() == 0) return a.patch_count() == b.patch_count();
  return &a.patches() == &b.patches() && a.origin() == b.origin();
}

void find_reference(const Document& document, const Object& object, const ShownSurface& shown,
                    MapSurroundings& out) {
  const Object* reference = document.find(document.making.reference);
  out.state = ReferenceState::none;
  if (!reference || !has_shape(*reference)) return;
  out.state = reference->id == object.id ? ReferenceState::itself : ReferenceState::hidden;
  if (reference->id == object.id || !reference->visible) return;
  const Surface* surface = shown(reference->id);
  out.state = ReferenceState::waiting;
  if (!surface || surface->patch_count() == 0) return;
  out.state = ReferenceState::ready;
  out.reference = *surface;
  out.reference_facets = is_faceted(*reference);
  out.reference_transform = reference->transform;
}

}  // namespace

bool same_values(const MapSurroundings& a, const MapSurroundings& b) {
  return a.transform == b.transform && a.pull == b.pull && a.state == b.state &&
         is_same_surface(a.reference, b.reference) && a.reference_facets == b.reference_facets &&
         a.reference_transform == b.reference_transform;
}

MapSurroundings surroundings_of(const Document& document, const Object& object, const ShownSurface& shown) {
  MapSurroundings out;
  const SurfaceMap map = object.display.map;
  if (!is_of_making(map)) return out;
  out.limit = limit_of(document, map);
  out.transform = object.transform;
  if (map == SurfaceMap::draft) out.pull = document.making.pull;
  if (map == SurfaceMap::deviation) find_reference(document, object, shown, out);
  return out;
}

}  // namespace hariko

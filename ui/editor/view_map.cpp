#include "ui/editor/view_map.hpp"

#include "core/document/object_shape.hpp"
#include "render/color_map.hpp"

namespace hariko {

bool can_show(const Object& object, SurfaceMap map) {
  if (!is_faceted(object)) return object.has_surface();
  return !has_values(map) || (is_of_making(map) && map != SurfaceMap::radius);
}

bool follows_view(const ViewMap& view, const Object& object) {
  return view.map && object.display.map == SurfaceMap::shaded && can_show(object, *view.map);
}

SurfaceMap shown_map(const ViewMap& view, const Object& object) {
  if (follows_view(view, object)) return *view.map;
  return can_show(object, object.display.map) ? object.display.map : SurfaceMap::shaded;
}

DisplaySettings shown_display(const ViewMap& view, const Object& object) {
  DisplaySettings display = object.display;
  display.map = shown_map(view, object);
  if (const auto slot = range_slot(display.map); slot && follows_view(view, object))
    display.ranges[*slot] = view.ranges[*slot];
  return display;
}

int scale_power(SurfaceMap map) {
  switch (map) {
    case SurfaceMap::gaussian:
      return 2;
    case SurfaceMap::mean:
    case SurfaceMap::principal_max:
    case SurfaceMap::principal_min:
      return 1;
    default:
      return 0;
  }
}

}  // namespace hariko

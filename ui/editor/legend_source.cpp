#include "ui/editor/legend_source.hpp"

#include "core/document/edits/edits.hpp"
#include "core/document/object_shape.hpp"

namespace hariko {

namespace {

/// Reason of an object, or null.
const Message* missing_of(const Editor& editor, const Object& object) {
  const SurfaceMap map = shown_map(editor.view.map, object);
  if (!object.visible || !has_shape(object) || !is_of_making(map)) return nullptr;
  const SurfaceView* view = editor.view_of(object.id);
  const bool ready = view && view->mesh && view->object && view->object->display.map == map;
  return ready && view->map_error ? &*view->map_error : nullptr;
}

}  // namespace

std::optional<MissingMap> missing_map(const Editor& editor) {
  if (const Object* active = editor.active_object())
    if (const Message* reason = missing_of(editor, *active)) return MissingMap{{}, reason};
  for (const auto& object : editor.document().objects) {
    if (object->id == editor.document().making.reference) continue;
    if (const Message* reason = missing_of(editor, *object)) return MissingMap{object->name, reason};
  }
  return std::nullopt;
}

std::optional<LegendSource> legend_source(const Editor& editor, const SceneBuilder& scene) {
  const Object* object = editor.active_object();
  const SurfaceView* view =
      object && object->visible && has_shape(*object) ? editor.view_of(object->id) : nullptr;
  if (view && view->mesh && view->object && has_values(object->display.map) && !view->map_error &&
      can_show(*object, object->display.map) && view->object->display.map == object->display.map)
    return LegendSource{object->display.map, view->range, &view->histogram, false};
  const ViewScale* scale = scene.view_scale();
  if (!scale) return std::nullopt;
  return LegendSource{scale->map, scale->range, &scale->histogram, true};
}

const MapRange& range_settings(const Editor& editor, const LegendSource& source) {
  if (source.of_view) return editor.view.map.ranges[range_slot(source.map).value_or(0)];
  return range_of(editor.active_object()->display, source.map);
}

void set_range(Editor& editor, const LegendSource& source, const MapRange& range) {
  if (source.of_view) {
    editor.view.map.ranges[range_slot(source.map).value_or(0)] = range;
    return;
  }
  DisplaySettings display = editor.active_object()->display;
  range_of(display, source.map) = range;
  editor.commit(set_display(editor.history.current(), editor.selection.active, display), "Range of the map");
}

}  // namespace hariko

#include "ui/editor/legend_source.hpp"

#include "core/document/edits/edits.hpp"

namespace hariko {

std::optional<LegendSource> legend_source(const Editor& editor, const SceneBuilder& scene) {
  const Object* object = editor.active_object();
  const SurfaceView* view =
      object && object->visible && object->has_surface() ? editor.view_of(object->id) : nullptr;
  if (view && view->mesh && view->object && has_values(object->display.map) &&
      view->object->display.map == object->display.map)
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

#include "ui/tools/tool.hpp"

#include <cmath>

namespace hariko {

std::optional<PickHit> pick_element(const ToolContext& context, const Vector2& pixel) {
  PickOptions options;
  options.vertices = context.editor.mode == ElementMode::vertex;
  options.edges = context.editor.mode == ElementMode::edge;
  options.faces = context.editor.mode == ElementMode::face;
  options.visible_only = !context.editor.view.x_ray;
  // The surface lies outside of the polyhedron in places: it must not hide the vertices that shape it.
  options.use_surface = context.editor.mode == ElementMode::face;
  return pick(context.scene.scene(), context.projector(), pixel, options);
}

std::unique_ptr<Tool> tool_for(const PointerEvent& press) {
  if (press.button == PointerButton::left && !press.alt) return make_select_tool();
  return press.shift ? make_pan_tool() : make_orbit_tool();
}

void zoom_at(Editor& editor, double steps, const Vector2& pixel) {
  editor.set_camera(editor.camera().zoom(std::pow(0.85, steps), pixel, editor.viewport));
}

}  // namespace hariko

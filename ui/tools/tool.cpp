#include "ui/tools/tool.hpp"

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

}  // namespace hariko

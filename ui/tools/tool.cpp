#include "ui/tools/tool.hpp"

#include <algorithm>

namespace hariko {

namespace {

std::vector<PickHit> pick_elements(const ToolContext& context, const Vector2& pixel) {
  const Editor& editor = context.editor;
  PickOptions options;
  options.vertices = editor.mode == ElementMode::vertex;
  options.edges = editor.mode == ElementMode::edge;
  options.faces = editor.mode == ElementMode::face || editor.mode == ElementMode::object;
  options.visible_only = !editor.view.x_ray && !editor.selecting.through;
  // The surface lies outside of the polyhedron in places: it must not hide the vertices that shape it.
  options.use_surface = options.faces;
  const Scene& scene = context.scene.scene();
  auto hits = pick_all(scene, context.projector(), pixel, options);
  // Thin objects are hard to hit by their faces.
  if (hits.empty() && editor.mode == ElementMode::object) {
    options.edges = true;
    options.use_surface = false;
    hits = pick_all(scene, context.projector(), pixel, options);
  }
  // Of faces one behind the other only the first can be seen.
  if (options.faces && options.visible_only && hits.size() > 1) hits.resize(1);
  return hits;
}

}  // namespace

std::optional<PickHit> pick_element(const ToolContext& context, const Vector2& pixel) {
  const auto hits = pick_elements(context, pixel);
  return hits.empty() ? std::nullopt : std::optional<PickHit>(hits.front());
}

std::vector<ElementRef> elements_under(const ToolContext& context, const Vector2& pixel) {
  const Editor& editor = context.editor;
  std::vector<ElementRef> result;
  if (context.scene.paper()) return result;  // it stands in the place of the objects
  for (const PickHit& hit : pick_elements(context, pixel)) {
    const ObjectId id = context.scene.object_id(hit.object);
    ElementRef ref{id, element_of(id)};
    if (editor.mode != ElementMode::object) {
      if (hit.index == no_index) continue;
      ref = element_at(editor.document(), id, hit.kind, hit.index);
      if (ref.element.kind == Element::Kind::none) continue;
    }
    if (std::find(result.begin(), result.end(), ref) == result.end()) result.push_back(ref);
  }
  return result;
}

}  // namespace hariko

#include "ui/view/tool.hpp"

#include <algorithm>

#include "ui/editor/object_kind.hpp"
#include "ui/editor/reference_pictures.hpp"

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
    options.edges = options.copies = true;
    options.use_surface = false;
    hits = pick_all(scene, context.projector(), pixel, options);
  }
  // Only the first of faces one behind the other can be seen.
  if (options.faces && options.visible_only && hits.size() > 1) hits.resize(1);
  return hits;
}

/// Bodies are picked by their lines, else by their faces, which the surface round them does not hide.
std::vector<ElementRef> bodies_under(const ToolContext& context, const Vector2& pixel) {
  const Scene& scene = context.scene.scene();
  Scene bodies;
  bodies.section = scene.section;
  bodies.pixel_scale = scene.pixel_scale;
  std::vector<ElementRef> refs;  ///< one an object of the scene of bodies
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object* object = context.editor.document().find(context.scene.object_id(i));
    if (!object || !scene.objects[i].show_polyhedron || scene.objects[i].copy) continue;
    // One by one, as of the faces of one object only the first is found.
    for (const ObjectBody& body : object_kind(*object).bodies(*object)) {
      bodies.objects.push_back(scene.objects[i]);
      bodies.objects.back().mesh.reset();
      bodies.objects.back().polyhedron = body.polyhedron;
      refs.push_back({object->id, body.element});
    }
  }
  std::vector<ElementRef> result;
  if (refs.empty()) return result;
  PickOptions options;
  options.vertices = options.edges = options.visible_only = options.use_surface = false;
  auto hits = pick_all(bodies, context.projector(), pixel, options);
  options.faces = false;
  options.edges = true;
  const auto lines = pick_all(bodies, context.projector(), pixel, options);
  hits.insert(hits.begin(), lines.begin(), lines.end());
  for (const PickHit& hit : hits)
    if (std::find(result.begin(), result.end(), refs[hit.object]) == result.end())
      result.push_back(refs[hit.object]);
  return result;
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
  // Elements that are not shown are not taken.
  if (editor.view.surfaces_only && editor.mode != ElementMode::object) return result;
  for (const PickHit& hit : pick_elements(context, pixel)) {
    const ObjectId id = context.scene.object_id(hit.object);
    ElementRef ref{id, element_of(id)};
    if (editor.mode != ElementMode::object) {
      // Elements are those at the object's own place.
      if (hit.index == no_index || context.scene.scene().objects[hit.object].copy) continue;
      ref = element_at(editor.document(), id, hit.kind, hit.index);
      if (ref.element.kind == Element::Kind::none) continue;
    }
    if (std::find(result.begin(), result.end(), ref) == result.end()) result.push_back(ref);
  }
  if (editor.mode != ElementMode::object && result.empty()) return bodies_under(context, pixel);
  if (editor.mode == ElementMode::object)
    for (const ObjectId id : pictures_under(editor, context.projector(), pixel))
      result.push_back({id, element_of(id)});
  return result;
}

}  // namespace hariko

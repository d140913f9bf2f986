// Commands that join border edges of a polyhedron to the sides of patch objects.

#include <algorithm>

#include "core/document/edits/edits.hpp"
#include "core/patching/joins/join.hpp"
#include "ui/editor/command_host.hpp"

namespace hariko {

namespace {

/// Selected border edges of the active polyhedron.
std::vector<EdgeId> border_edges(const Editor& editor) {
  std::vector<EdgeId> out;
  const Object* object = editor.active_object();
  if (!object || !object->polyhedron()) return out;
  const Polyhedron& polyhedron = object->polyhedron()->polyhedron;
  for (const EdgeId& edge : editor.selection.of_active().edges)
    if (const Index e = polyhedron.find(edge); e != no_index && polyhedron.topology().is_border_edge(e))
      out.push_back(edge);
  return out;
}

/// The side that is selected by an edge of its control net, if there is just one.
std::optional<std::pair<const Object*, NetSide>> selected_side(const Editor& editor) {
  std::optional<std::pair<const Object*, NetSide>> found;
  for (const auto& [id, elements] : editor.selection.elements()) {
    const Object* object = editor.document().find(id);
    if (!object || !object->patches()) continue;
    for (const EdgeId& edge : elements.edges)
      if (const auto side = side_of(*object->patches(), edge)) {
        if (found && !(found->first == object && found->second == *side)) return {};
        found = {object, *side};
      }
  }
  return found;
}

/// A selected polyhedron is meant where the active object is the patch.
void prefer_polyhedron(Editor& editor) {
  if (editor.active_object() && editor.active_object()->polyhedron()) return;
  for (const auto& [id, elements] : editor.selection.elements())
    if (const Object* object = editor.document().find(id); object && object->polyhedron()) {
      editor.selection.active = id;
      return;
    }
}

void attach(Editor& editor) {
  prefer_polyhedron(editor);
  const auto edges = border_edges(editor);
  const auto chosen = selected_side(editor);
  const ObjectId id = editor.selection.active;
  Result<Document> result = editor.history.current();
  for (const EdgeId& edge : edges) {
    const Object* object = result->find(id);
    const auto attachment = chosen && edges.size() == 1
                                ? attachment_to(*object, edge, *chosen->first, chosen->second)
                                : nearest_side(*result, *object, edge);
    if (!attachment) break;
    result = attach_edge(*result, id, edge, *attachment);
    if (!result) break;
  }
  editor.commit(result, edges.size() == 1 ? "Attach edge" : "Attach edges");
}

WhyNot needs_border_edges(const Editor& editor) {
  return [&editor]() -> Reason {
    if (auto reason = needs_document(editor)()) return reason;
    bool any_polyhedron = false;
    for (const auto& [id, elements] : editor.selection.elements())
      if (const Object* object = editor.document().find(id); object && object->polyhedron())
        any_polyhedron = any_polyhedron || !elements.edges.empty();
    if (!any_polyhedron) return translatable("No edges are selected. Press 2 and click one.");
    return {};
  };
}

WhyNot needs_side(const Editor& editor) {
  return [&editor]() -> Reason {
    if (auto reason = needs_border_edges(editor)()) return reason;
    const auto& objects = editor.document().objects;
    if (std::none_of(objects.begin(), objects.end(),
                     [](const auto& object) { return object->patches() && object->visible; }))
      return translatable("There is no patch object to attach to. Add one, or show it.");
    const Object* active = editor.active_object();
    if (active && active->polyhedron() && border_edges(editor).empty())
      return translatable("No border edge is selected: one that has a face on one side only.");
    return {};
  };
}

/// The vertex where the active object's surface says that joined patches do not fit.
std::optional<VertexId> misfit(const Editor& editor) {
  const Object* object = editor.active_object();
  const SurfaceView* view = object ? editor.view_of(object->id) : nullptr;
  if (!view || !view->error || view->error->element.kind != Element::Kind::vertex) return {};
  if (!(view->error->code == e_join_corner) && !(view->error->code == e_join_twist)) return {};
  return VertexId{static_cast<std::uint32_t>(view->error->element.id)};
}

void release_chosen_edges(Editor& editor) {
  prefer_polyhedron(editor);
  editor.commit(release_edges(editor.history.current(), editor.selection.active, border_edges(editor)),
                "Release edges");
}

bool attached_edge_chosen(const Editor& editor) {
  const Object* object = editor.active_object();
  return object && object->polyhedron() && std::ranges::any_of(border_edges(editor), [&](const EdgeId& edge) {
           return object->polyhedron()->attachments->contains(edge);
         });
}

void adapt_patch(Editor& editor) {
  if (const auto vertex = misfit(editor))
    editor.commit(let_patch_adapt(editor.history.current(), editor.selection.active, *vertex),
                  "Let patch adapt");
}

}  // namespace

void add_attach_commands(CommandHost& host) {
  Editor& editor = host.editor;
  host.table.add(
      {.id = "shape.attach",
       .menu = "Shape",
       .label = "Attach to patch side",
       .help = "Join the selected border edges to the nearest sides of patch objects, or to the side that is "
               "selected too.",
       .changes_document = true,
       .separator_before = true,
       .run = [&editor] { attach(editor); },
       .why_not = needs_side(editor)});
  host.table.add({.id = "shape.release_edges",
                  .menu = "Shape",
                  .label = "Release attached edges",
                  .help = "The selected border edges follow their patches no more.",
                  .changes_document = true,
                  .run = [&editor] { release_chosen_edges(editor); },
                  .why_not = only_if(
                      needs_border_edges(editor), [&editor] { return attached_edge_chosen(editor); },
                      translatable("None of the selected edges is attached."))});
  host.table.add(
      {.id = "shape.adapt_patch",
       .menu = "Shape",
       .label = "Let the patch adapt",
       .help = "Where joined patches do not fit each other, one of them follows the surface instead.",
       .changes_document = true,
       .run = [&editor] { adapt_patch(editor); },
       .why_not = only_if(
           needs_polyhedron(editor), [&editor] { return misfit(editor).has_value(); },
           translatable("The joined patches fit each other.")),
       .script = {.looks_at_surfaces = true}});
}

}  // namespace hariko

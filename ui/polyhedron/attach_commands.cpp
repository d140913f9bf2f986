// Commands that join border edges of a polyhedron to the sides of patch objects.

#include <algorithm>

#include "core/document/edits/edits.hpp"
#include "core/modeling/objects/patch_objects.hpp"
#include "core/patching/joins/join.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/view/transform_target.hpp"

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
  return only_if(
      needs_document(editor),
      [&editor] {
        return std::ranges::any_of(editor.selection.elements(), [&](const auto& chosen) {
          const Object* object = editor.document().find(chosen.first);
          return object && object->polyhedron() && !chosen.second.edges.empty();
        });
      },
      translatable("No edges are selected. Press 2 and click one."));
}

WhyNot needs_side(const Editor& editor) {
  return [&editor, edges = needs_border_edges(editor)]() -> Reason {
    if (auto reason = edges()) return reason;
    if (std::ranges::none_of(editor.document().objects,
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
  MenuRows rows(host.table, "Shape");
  rows.add_edit(
      "shape.attach", "Attach to patch side",
      "Join the selected border edges to the nearest sides of patch objects, or to the side that is "
      "selected too.",
      [&editor] { attach(editor); }, needs_side(editor), {.separator_before = true});
  rows.add_edit(
      "shape.release_edges", "Release attached edges",
      "The selected border edges follow their patches no more.", [&editor] { release_chosen_edges(editor); },
      only_if(
          needs_border_edges(editor), [&editor] { return attached_edge_chosen(editor); },
          translatable("None of the selected edges is attached.")));
  rows.add_edit("shape.adapt_patch", "Let the patch adapt",
                "Where joined patches do not fit each other, one of them follows the surface instead.",
                [&editor] { adapt_patch(editor); },
                only_if(
                    needs_polyhedron(editor), [&editor] { return misfit(editor).has_value(); },
                    translatable("The joined patches fit each other.")),
                {.script = {.looks_at_surfaces = true}});
}

// Commands that take objects of patches apart and put them together.

namespace {

void select(Editor& editor, std::span<const ObjectId> objects) {
  editor.selection.clear_elements();
  editor.selection.active = objects[0];
  if (editor.mode != ElementMode::object) return;
  editor.selection.clear_objects();
  for (const ObjectId id : objects) editor.selection.select({id, element_of(id)}, Selection::How::add);
  editor.selection.active = objects[0];
}

void separate(Editor& editor) {
  const auto done = separate_patches(editor.history.current(), editor.selection.active);
  if (!done) return editor.notify(done.error());
  if (editor.commit(Result<Document>(done->document), translatable("Separate patches")))
    select(editor, done->objects);
}

bool has_several_patches(const Editor& editor) {
  const BezierSource* bezier = editor.active_object()->bezier();
  return bezier && bezier->patches->size() > 1;
}

void weld(Editor& editor) {
  const auto done = weld_patch_objects(editor.history.current(), active_and_selected(editor));
  if (!done) return editor.notify(done.error());
  if (editor.commit(Result<Document>(done->document), translatable("Weld patches")))
    select(editor, std::span(&done->object, 1));
}

}  // namespace

void add_patch_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot object = needs_object(editor);
  MenuRows rows(host.table, "Shape");
  rows.add_edit(
      "shape.weld_patches", "Weld patches",
      "Make one surface of the chosen objects of patches: sides that are equal are joined.",
      [&editor] { weld(editor); },
      [&editor, object]() -> Reason {
        if (auto reason = object()) return reason;
        const Object& active = *editor.active_object();
        if (!active.patches() && !active.bezier())
          return translatable("The active object is not made of patches.");
        if (selected_objects(editor).size() > 1) return {};
        return translatable("Choose two or more objects. Press 4 and click them with Shift.");
      },
      {.separator_before = true});
  rows.add_edit(
      "shape.separate_patches", "Separate patches",
      "Each patch becomes an object; the control points of those of degree 3 by 3 without weights can then "
      "be edited, and edges attached to their sides.",
      [&editor] { separate(editor); },
      only_if(
          object, [&editor] { return has_several_patches(editor); },
          translatable("The active object does not have several welded patches.")));
}

}  // namespace hariko

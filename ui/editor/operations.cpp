#include "ui/editor/operations.hpp"

#include "core/document/edits/edits.hpp"
#include "core/modeling/selection/select_convert.hpp"
#include "ui/editor/object_kind.hpp"

namespace hariko {

namespace {

const char* why_no_cage(const Object& object) {
  if (object.cage()) return nullptr;
  return translatable(
      "Nothing of a polyhedron or of patches is selected. Click a vertex, an edge or a "
      "face.");
}

const char* why_no_polyhedron(const Object& object) {
  if (object.polyhedron()) return nullptr;
  return translatable("Nothing of a polyhedron is selected. Click a vertex, an edge or a face.");
}

const char* why_no_links(const Object& object) {
  return object_kind(object).why_not_linked();
}

/// The elements of `all` that are not among the selected ones.
ElementSelection unselected(ElementSelection all, const ElementSelection& selected) {
  std::erase_if(all.vertices, [&](VertexId id) { return selected.vertices.contains(id); });
  std::erase_if(all.edges, [&](const EdgeId& id) { return selected.edges.contains(id); });
  std::erase_if(all.faces, [&](FaceId id) { return selected.faces.contains(id); });
  return all;
}

ElementSet in_mode(const Polyhedron& polyhedron, const ElementSet& set, ElementMode mode) {
  switch (mode) {
    case ElementMode::vertex:
      return set.vertices.empty() ? to_vertices(polyhedron, set) : ElementSet{set.vertices, {}, {}};
    case ElementMode::edge:
      return set.edges.empty() ? to_edges(polyhedron, set) : ElementSet{{}, set.edges, {}};
    case ElementMode::face:
      return set.faces.empty() ? to_faces(polyhedron, set) : ElementSet{{}, {}, set.faces};
    default:
      return {};
  }
}

}  // namespace

void select_result(Editor& editor, ObjectId id, const ElementSet& result) {
  const Object* object = editor.document().find(id);
  if (!object || !object->polyhedron()) return;
  editor.selection.active = id;
  editor.selection.clear_elements();
  ElementSet chosen = in_mode(object->polyhedron()->polyhedron, result, editor.mode);
  if (chosen.empty()) {
    editor.mode = !result.faces.empty()   ? ElementMode::face
                  : !result.edges.empty() ? ElementMode::edge
                                          : ElementMode::vertex;
    chosen = in_mode(object->polyhedron()->polyhedron, result, editor.mode);
  }
  editor.selection.set(id, std::move(chosen));
}

ElementChange by_cage(std::function<ElementSelection(const Polyhedron&, const ElementSelection&)> change) {
  return {why_no_cage, [change = std::move(change)](const Object& object, const ElementSelection& elements) {
            return change(*object.cage(), elements);
          }};
}

ElementChange by_polyhedron(
    std::function<ElementSelection(const PolyhedronSource&, const ElementSelection&)> change) {
  return {why_no_polyhedron,
          [change = std::move(change)](const Object& object, const ElementSelection& elements) {
            return change(*object.polyhedron(), elements);
          }};
}

ElementChange by_links() {
  return {why_no_links, [](const Object& object, const ElementSelection& elements) {
            return object_kind(object).linked(object, elements);
          }};
}

void change_elements(Editor& editor, const ElementChange& change) {
  const auto before = editor.selection.elements();
  for (const auto& [id, elements] : before) {
    const Object* object = editor.document().find(id);
    if (object && !change.why_not(*object)) editor.selection.set(id, change.change(*object, elements));
  }
}

void invert_elements(Editor& editor) {
  Selection& selection = editor.selection;
  std::set<ObjectId> objects{selection.active};
  for (const auto& entry : selection.elements()) objects.insert(entry.first);
  for (const ObjectId id : objects)
    if (const Object* object = editor.document().find(id))
      selection.set(id, unselected(object_kind(*object).all(*object, editor.mode), selection.of(id)));
}

bool select_linked_to(Editor& editor, const ElementRef& element) {
  const Object* object = editor.document().find(element.object);
  if (!object || why_no_links(*object)) return false;
  Selection one;
  one.select(element, Selection::How::replace);
  editor.selection.select(object->id, object_kind(*object).linked(*object, one.of(object->id)),
                          Selection::How::add);
  editor.selection.active = object->id;
  return true;
}

bool run_operation(Editor& editor, const Operation& operation, const Phrase& label) {
  const ObjectId id = editor.selection.active;
  const Result<ModeledDocument> done = edit_polyhedron(editor.history.current(), id, operation);
  if (!done) return editor.refuse(done.error());
  if (!editor.commit(done->document, label)) return false;
  select_result(editor, id, done->selection);
  return true;
}

FormToKeep form_for_refinement(const Editor& editor, const PolyhedronSource& source) {
  if (!editor.settings.refine_on_surface) return {};
  auto form = form_to_keep(source);
  if (!form) return {{}, form.error()};
  return {std::move(form).value(), {}};
}

void say_form_lost(Editor& editor, const std::optional<Message>& why) {
  if (!why) return;
  editor.notify(Notice::Kind::warning,
                editor.language("The surface could not be made, so the new points lie on straight edges and "
                                "flat faces."),
                editor.language.text_of(*why));
}

bool run_refinement(Editor& editor, const Refinement& refinement, const Phrase& label) {
  std::optional<Message> lost;
  const bool done = run_operation(
      editor,
      [&](const PolyhedronSource& source) {
        const FormToKeep kept = form_for_refinement(editor, source);
        lost = kept.lost;
        return refinement(source, kept.pointer());
      },
      label);
  if (done) say_form_lost(editor, lost);
  return done;
}

void say_locked(Editor& editor) {
  const Document& document = editor.history.current();
  std::vector<ObjectId> ids(editor.selection.objects().begin(), editor.selection.objects().end());
  for (const auto& entry : editor.selection.elements()) ids.push_back(entry.first);
  for (const ObjectId id : ids) {
    const Object* object = document.find(id);
    if (!object || !object->visible || !object->locked) continue;
    if (const auto refused = set_transform(document, id, object->transform); !refused)
      return editor.notify(refused.error());
  }
}

}  // namespace hariko

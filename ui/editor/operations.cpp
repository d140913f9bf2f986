#include "ui/editor/operations.hpp"

#include "core/document/edits/edits.hpp"
#include "core/modeling/selection/select_convert.hpp"

namespace hariko {

namespace {

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

bool run_operation(Editor& editor, const Operation& operation, const std::string& label) {
  const ObjectId id = editor.selection.active;
  const Result<ModeledDocument> done = edit_polyhedron(editor.history.current(), id, operation);
  if (!done) {
    editor.notify(done.error());
    return false;
  }
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

bool run_refinement(Editor& editor, const Refinement& refinement, const std::string& label) {
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

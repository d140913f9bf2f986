#include "ui/editor/command_host.hpp"

#include <algorithm>
#include <utility>

#include "core/document/object_shape.hpp"

namespace hariko {

namespace {

Reason no_document(const Editor& editor) {
  if (editor.has_document) return {};
  return translatable("Nothing is open. Open a file or a sample first.");
}

Reason no_object(const Editor& editor) {
  if (auto reason = no_document(editor)) return reason;
  if (editor.active_object()) return {};
  return translatable("No object is chosen. Choose one in the list of objects.");
}

Reason no_polyhedron(const Editor& editor) {
  if (auto reason = no_object(editor)) return reason;
  if (!editor.active_object()->polyhedron())
    return translatable("The chosen object is not a polyhedron. Choose one in the list of objects.");
  return {};
}

Reason no_surface(const Editor& editor, bool curves) {
  if (auto reason = no_object(editor)) return reason;
  const Object& object = *editor.active_object();
  if (!has_shape(object) || (curves && !object.has_surface()))
    return translatable("The chosen object has no surface. Choose another in the list of objects.");
  const SurfaceView* view = curves ? editor.view_of(object.id) : nullptr;
  if (!view || !view->mesh) return {};
  if (std::ranges::none_of(view->mesh->curves()->curves, [](const DisplayCurve& curve) {
        return curve.source.kind == Element::Kind::edge;
      }))
    return translatable("The surface of the chosen object has no curves over edges.");
  return {};
}

}  // namespace

WhyNot needs_shown_surface(const Editor& editor, bool curves) {
  return [&editor, curves] { return no_surface(editor, curves); };
}

WhyNot needs_document(const Editor& editor) {
  return [&editor] { return no_document(editor); };
}

WhyNot needs_object(const Editor& editor) {
  return [&editor] { return no_object(editor); };
}

WhyNot needs_polyhedron(const Editor& editor) {
  return [&editor] { return no_polyhedron(editor); };
}

WhyNot needs_elements(const Editor& editor, NeededElements kinds) {
  return [&editor, kinds]() -> Reason {
    if (auto reason = no_polyhedron(editor)) return reason;
    if (kinds.among(editor.selection.of_active())) return {};
    return kinds.missing();
  };
}

bool NeededElements::among(const ElementSelection& selection) const {
  return (vertices && !selection.vertices.empty()) || (edges && !selection.edges.empty()) ||
         (faces && !selection.faces.empty());
}

const char* NeededElements::missing() const {
  if (vertices && edges && faces)
    return translatable("Nothing is selected. Click a vertex, an edge or a face.");
  if (vertices && edges) return translatable("Nothing is selected. Click a vertex or an edge.");
  if (edges && faces) return translatable("No edges or faces are selected. Press 2 or 3 and click one.");
  if (vertices) return translatable("No vertices are selected. Press 1 and click one.");
  if (edges) return translatable("No edges are selected. Press 2 and click one.");
  return translatable("No faces are selected. Press 3 and click one.");
}

WhyNot only_if(std::function<bool()> holds, const char* otherwise) {
  return only_if({}, std::move(holds), otherwise);
}

WhyNot only_if(WhyNot first, std::function<bool()> holds, const char* otherwise) {
  return [first = std::move(first), holds = std::move(holds), otherwise]() -> Reason {
    if (first)
      if (auto reason = first()) return reason;
    if (holds()) return {};
    return otherwise;
  };
}

}  // namespace hariko

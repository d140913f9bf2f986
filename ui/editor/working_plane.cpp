#include "ui/editor/working_plane.hpp"

#include <algorithm>
#include <vector>

#include "ui/editor/editor.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/skin_edits.hpp"
#include "ui/editor/skin_view.hpp"

namespace hariko {

namespace {

PlaneFrame in_document(const PlaneFrame& frame, const Similarity& transform) {
  return {transform.apply(frame.point), transform.rotation.toRotationMatrix() * frame.axes};
}

/// Selected points of visible objects, in the order of their numbers.
std::vector<ElementRef> selected_point_refs(const Editor& editor) {
  std::vector<ElementRef> out;
  for (const auto& [id, elements] : editor.selection.elements())
    for (const VertexId vertex : elements.vertices) out.push_back({id, element_of(vertex)});
  return out;
}

}  // namespace

const char* plane_name(WorkingPlane::Kind kind) {
  return name_among(kind, {"Ground", "View plane", "Face", "Three points", "Section"});
}

WorkingPlane plane_of_view(const Editor& editor) {
  const Camera camera = editor.camera();
  const Box3 box = editor.selected_box();
  PlaneFrame frame;
  frame.point = box.isEmpty() ? camera.target : Vector3(box.center());
  frame.axes = camera.orientation.toRotationMatrix();
  return {WorkingPlane::Kind::view, frame};
}

std::optional<WorkingPlane> plane_of_selected_face(const Editor& editor) {
  const Object* found = nullptr;
  FaceId face;
  std::size_t count = 0;
  for (const auto& [id, elements] : editor.selection.elements()) {
    const Object* object = editor.document().find(id);
    if (!object || !object->cage() || elements.faces.empty()) continue;
    count += elements.faces.size();
    found = object;
    face = *elements.faces.begin();
  }
  const Index index = count == 1 ? found->cage()->find(face) : no_index;
  if (index == no_index) return std::nullopt;
  const Polyhedron& cage = *found->cage();
  std::vector<Vector3> corners;
  for (const Index v : cage.topology().face_vertices(index))
    corners.push_back(found->transform.apply(found->cage_origin() + cage.position(v)));
  const auto frame = plane_of_polygon(corners);
  if (!frame) return std::nullopt;
  return WorkingPlane{WorkingPlane::Kind::face, *frame};
}

std::optional<WorkingPlane> plane_of_selected_points(const Editor& editor) {
  std::vector<ElementRef> refs = selected_point_refs(editor);
  const auto bring = [&](const std::optional<ElementRef>& ref, std::size_t to) {
    const auto at = ref ? std::find(refs.begin(), refs.end(), *ref) : refs.end();
    if (at != refs.end()) std::swap(refs[to], *at);
  };
  if (refs.size() == 3) {
    bring(editor.selection.first, 0);
    if (editor.selection.last != editor.selection.first) bring(editor.selection.last, 2);
  }
  std::vector<Vector3> places;
  for (const ElementRef& ref : refs)
    if (const auto place = place_of(editor.document(), ref)) places.push_back(*place);
  if (refs.size() != 3 || places.size() != 3) return std::nullopt;
  const auto frame = plane_through(places[0], places[1], places[2]);
  if (!frame) return std::nullopt;
  return WorkingPlane{WorkingPlane::Kind::points, *frame};
}

std::optional<WorkingPlane> plane_of_selected_section(const Editor& editor) {
  const Object* object = shown_skin(editor);
  const SkinSection* section = object ? selected_section(editor) : nullptr;
  if (!section) return std::nullopt;
  const PlaneFrame frame = plane_of_section(*object->skin()->skin, *section);
  return WorkingPlane{WorkingPlane::Kind::section, in_document(frame, object->transform)};
}

}  // namespace hariko

#include "core/modeling/operations/flip.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/selection/selected.hpp"
#include "core/network/kept_form.hpp"

namespace hariko {

Result<EditResult> flip_faces(const PolyhedronSource& source, std::span<const FaceId> faces) {
  const Polyhedron& polyhedron = source.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const auto chosen = selected(polyhedron, faces, "Select all faces of a part.");
  if (!chosen) return chosen.error();
  std::vector<char> inside(mesh.face_count(), 0);
  for (const Index f : *chosen) inside[f] = 1;
  for (const Index f : *chosen)
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h)
      if (const Index twin = mesh.twin(h); twin != no_index && !inside[mesh.face(twin)])
        return make_error(e_wrong_selection,
                          "Neighbouring faces would face opposite ways: only whole parts can be flipped.",
                          "Select the whole part (Select linked).",
                          element_of(polyhedron.face_id(mesh.face(twin))));
  MeshEditor draft(source);
  ElementSet selection;
  Shaping& shaping = draft.shaping();
  std::map<VertexId, KeptForm> forms;
  for (const Index f : *chosen) {
    const FaceId id = polyhedron.face_id(f);
    const auto old = draft.face(id);
    std::vector<VertexId> corners(old.begin(), old.end());
    std::reverse(corners.begin() + 1, corners.end());
    draft.set_face(id, std::move(corners));
    selection.faces.insert(id);
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const VertexId id = polyhedron.vertex_id(v);
    const KeptForm* form = shaping.form.find(id);
    if (form && mesh.outgoing(v) != no_index && inside[mesh.face(mesh.outgoing(v))]) {
      KeptForm turned = reflected_form(*form);
      for (KeptForm::Edge& edge : turned.edges) edge.offset.z() = -edge.offset.z();
      forms.emplace(id, std::move(turned));
    }
    const Pin* pin = shaping.pin.find(id);
    if (!pin || pin->kind != Pin::Kind::normal || mesh.outgoing(v) == no_index) continue;
    if (inside[mesh.face(mesh.outgoing(v))])
      shaping.pin.set(id, {Pin::Kind::normal, {Vector3(-pin->vectors[0])}});
  }
  auto flipped = std::move(draft).finish(std::move(selection));
  if (flipped && !forms.empty()) {  // the edges at the form's vertices are the same, in reverse order
    Shaping kept = *flipped->source.shaping;
    for (auto& [id, form] : forms) kept.form.set(id, std::move(form));
    flipped.value().source.shaping = std::move(kept);
  }
  return flipped;
}

}  // namespace hariko

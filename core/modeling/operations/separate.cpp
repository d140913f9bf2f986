#include "core/modeling/operations/separate.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/document/edits/edits.hpp"
#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/objects/edit_modeling.hpp"
#include "core/modeling/operations/delete_elements.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {
namespace {

using Copies = std::map<VertexId, VertexId>;

VertexId copy_of(MeshEditor& draft, Copies& copies, VertexId v) {
  const auto [it, fresh] = copies.try_emplace(v);
  if (fresh) {
    it->second = draft.add_vertex(Vector3(draft.position(v)));
    draft.inherit(v, it->second);
    const Pin* pin = draft.shaping().pin.find(v);
    if (pin && pin->kind == Pin::Kind::normal) draft.shaping().pin.set(it->second, Pin(*pin));
  }
  return it->second;
}

/// Copies the settings of the sides of a face to those of its copy.
void inherit_sides(MeshEditor& draft, std::span<const VertexId> old, std::span<const VertexId> fresh) {
  for (std::size_t i = 0; i < old.size(); ++i) {
    const std::size_t next = (i + 1) % old.size();
    const EdgeId from = EdgeId::of(old[i], old[next]), to = EdgeId::of(fresh[i], fresh[next]);
    if (from != to) draft.inherit(from, to);
  }
}

}  // namespace

Result<EditResult> duplicate_faces(const PolyhedronSource& source, std::span<const FaceId> faces) {
  const auto chosen = selected(source.polyhedron, faces, "Select faces.");
  if (!chosen) return chosen.error();
  MeshEditor draft(source);
  Copies copies;
  ElementSet selection;
  for (const Index f : *chosen) {
    const auto span = draft.face(source.polyhedron.face_id(f));
    const std::vector<VertexId> old(span.begin(), span.end());
    std::vector<VertexId> corners;
    for (const VertexId v : old) corners.push_back(copy_of(draft, copies, v));
    selection.faces.insert(draft.add_face(corners));
    inherit_sides(draft, old, corners);
  }
  return std::move(draft).finish(std::move(selection));
}

Result<EditResult> separate_faces(const PolyhedronSource& source, std::span<const FaceId> faces) {
  const HalfEdgeMesh& mesh = source.polyhedron.topology();
  const auto chosen = selected(source.polyhedron, faces, "Select faces.");
  if (!chosen) return chosen.error();
  std::vector<char> inside(mesh.face_count(), 0);
  for (const Index f : *chosen) inside[f] = 1;
  std::vector<char> outside_too(mesh.vertex_count(), 0);
  for (Index h = 0; h < mesh.half_edge_count(); ++h)
    if (!inside[mesh.face(h)]) outside_too[mesh.origin(h)] = 1;

  MeshEditor draft(source);
  Copies copies;
  ElementSet selection;
  for (const Index f : *chosen) {
    const FaceId id = source.polyhedron.face_id(f);
    const auto span = draft.face(id);
    const std::vector<VertexId> old(span.begin(), span.end());
    std::vector<VertexId> corners;
    for (const VertexId v : old)
      corners.push_back(outside_too[source.polyhedron.find(v)] ? copy_of(draft, copies, v) : v);
    draft.set_face(id, corners);
    inherit_sides(draft, old, corners);
    selection.faces.insert(id);
  }
  if (copies.empty())
    return make_error(e_wrong_selection, "The faces are a part of their own already.",
                      "Select some faces of a part.");
  return std::move(draft).finish(std::move(selection));
}

Result<Detached> detach_faces(const Document& document, ObjectId object, std::span<const FaceId> faces) {
  const Object* original = document.find(object);
  Result<ModeledDocument> rest = edit_polyhedron(
      document, object, [&](const PolyhedronSource& source) { return delete_faces(source, faces); });
  if (!rest) return rest.error();
  const PolyhedronSource& whole = *original->polyhedron();
  std::vector<FaceId> others;
  const std::set<FaceId> taken(faces.begin(), faces.end());
  for (Index f = 0; f < whole.polyhedron.face_count(); ++f)
    if (!taken.contains(whole.polyhedron.face_id(f))) others.push_back(whole.polyhedron.face_id(f));
  Result<EditResult> part = delete_faces(whole, others);
  if (!part) return part.error();
  // A duplicate has the name, place and display that the new object needs.
  Result<Added> added = duplicate_object(rest->document, object);
  if (!added) return added.error();
  Result<Document> done = set_source(added->document, added->id, std::move(part).value().source);
  if (!done) return done.error();
  return Detached{std::move(done).value(), added->id};
}

}  // namespace hariko

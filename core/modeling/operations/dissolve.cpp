#include "core/modeling/operations/dissolve.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/disjoint_sets.hpp"
#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/selection/selected.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {
namespace {

Message not_a_disk(FaceId face) {
  return make_error(e_would_be_nonmanifold, "The joined face would have a hole or touch itself.",
                    "Dissolve fewer elements at a time.", element_of(face));
}

/// Border of a group of faces, as the corners of the face that replaces them. Nothing unless the group is a
/// disk: one border loop that passes no vertex twice, and no handle inside.
std::optional<std::vector<Index>> outline(const HalfEdgeMesh& mesh, DisjointSets& groups,
                                          std::span<const Index> faces) {
  std::map<Index, Index> next;
  std::set<Index> vertices;
  std::size_t border_sides = 0, inner_sides = 0;
  for (const Index f : faces)
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      vertices.insert(mesh.origin(h));
      const Index twin = mesh.twin(h);
      if (twin != no_index && groups.find(mesh.face(twin)) == groups.find(f)) {
        ++inner_sides;
      } else {
        next[mesh.origin(h)] = mesh.target(h);
        ++border_sides;
      }
    }
  if (next.size() != border_sides || border_sides == 0) return std::nullopt;
  if (vertices.size() + faces.size() != border_sides + inner_sides / 2 + 1) return std::nullopt;
  // Starts at the first corner of the first face that lies on the border, so that little changes.
  std::vector<Index> loop;
  for (const Index v : mesh.face_vertices(faces[0]))
    if (loop.empty() && next.contains(v)) loop.push_back(v);
  if (loop.empty()) loop.push_back(next.begin()->first);
  while (next.at(loop.back()) != loop[0]) loop.push_back(next.at(loop.back()));
  if (loop.size() != border_sides) return std::nullopt;
  return loop;
}

/// The two neighbours of a vertex with two edges.
std::pair<VertexId, VertexId> neighbours_of(const MeshEditor& draft, VertexId v) {
  const auto corners = draft.face(draft.faces_at(v).front());
  const auto n = corners.size();
  const auto i = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
  return {corners[(i + n - 1) % n], corners[(i + 1) % n]};
}

/// Reason why a vertex with two edges cannot be removed from its faces; nothing if it can.
std::optional<Message> cannot_drop(const MeshEditor& draft, VertexId v) {
  for (const FaceId f : draft.faces_at(v))
    if (draft.face(f).size() <= 3)
      return make_error(e_face_too_small, "A face would keep fewer than three corners.",
                        "Delete the face, or merge its vertices.", element_of(f));
  const auto [a, b] = neighbours_of(draft, v);
  if (!draft.contains(EdgeId::of(a, b))) return std::nullopt;
  // Two faces would have two edges between the same vertices, or a hole of three edges would close.
  return make_error(e_would_be_nonmanifold, "An edge joins the neighbours of the vertex already.",
                    "Merge vertices instead.", element_of(v));
}

/// Removes a vertex with two edges from its faces; the edge that remains is a crease if both were, and has
/// their tension if they agree.
void drop_vertex(MeshEditor& draft, VertexId v) {
  const auto [a, b] = neighbours_of(draft, v);
  for (const FaceId f : draft.faces_at(v)) {
    const auto old = draft.face(f);
    std::vector<VertexId> corners(old.begin(), old.end());
    std::erase(corners, v);
    draft.set_face(f, std::move(corners));
  }
  Shaping& shaping = draft.shaping();
  const EdgeId before = EdgeId::of(a, v), after = EdgeId::of(v, b), whole = EdgeId::of(a, b);
  const double beta = shaping.beta.get_or(before, 1);
  if (beta == shaping.beta.get_or(after, 1) && beta != 1) shaping.beta.set(whole, double(beta));
  if (shaping.crease.contains(before) && shaping.crease.contains(after)) shaping.crease.set(whole, true);
}

bool has_two_edges(const MeshEditor& draft, VertexId v) {
  std::set<VertexId> neighbours;
  for (const FaceId f : draft.faces_at(v)) {
    const auto corners = draft.face(f);
    const auto n = corners.size();
    const auto i = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
    neighbours.insert(corners[(i + n - 1) % n]);
    neighbours.insert(corners[(i + 1) % n]);
  }
  return neighbours.size() == 2;
}

/// Joins every group of several faces in the draft and selects the joined faces.
std::optional<Message> join_groups(const Polyhedron& polyhedron, DisjointSets& groups, MeshEditor& draft,
                                   ElementSet& selection) {
  const Index count = polyhedron.face_count();
  std::vector<char> has_others(count, 0);
  for (Index f = 0; f < count; ++f)
    if (const Index first = groups.find(f); first != f) has_others[first] = 1;
  std::map<Index, std::vector<Index>>
      members;  // without the faces that stay alone, nearly all of a large mesh
  for (Index f = 0; f < count; ++f)
    if (const Index first = groups.find(f); has_others[first]) members[first].push_back(f);
  for (const auto& [first, faces] : members) {
    const FaceId id = polyhedron.face_id(first);
    const auto loop = outline(polyhedron.topology(), groups, faces);
    if (!loop) return not_a_disk(id);
    std::vector<VertexId> corners;
    for (const Index v : *loop) corners.push_back(polyhedron.vertex_id(v));
    for (const Index f : faces)
      if (f != first) draft.remove_face(polyhedron.face_id(f));
    draft.set_face(id, std::move(corners));
    selection.faces.insert(id);
  }
  return std::nullopt;
}

}  // namespace

Result<EditResult> dissolve_vertices(const PolyhedronSource& source, std::span<const VertexId> vertices) {
  const auto chosen = selected(source.polyhedron, vertices, "Select vertices.");
  if (!chosen) return chosen.error();
  const HalfEdgeMesh& mesh = source.polyhedron.topology();
  DisjointSets groups(mesh.face_count());
  MeshEditor draft(source);
  ElementSet selection;
  // The fan of a vertex becomes one face; a vertex with two edges separates no faces, so that they stay
  // apart.
  for (const Index v : *chosen) {
    if (mesh.outgoing(v) == no_index || mesh.valence(v) == 2) continue;
    for (const Index h : mesh.fan_corners(v)) groups.join(mesh.face(mesh.outgoing(v)), mesh.face(h));
  }
  if (auto failed = join_groups(source.polyhedron, groups, draft, selection)) return *std::move(failed);
  for (const Index v : *chosen) {
    const VertexId id = source.polyhedron.vertex_id(v);
    if (draft.faces_at(id).empty()) continue;  // it was inside a joined face
    if (auto failed = cannot_drop(draft, id)) return *std::move(failed);
    drop_vertex(draft, id);
  }
  return std::move(draft).finish(std::move(selection));
}

Result<EditResult> dissolve_edges(const PolyhedronSource& source, std::span<const EdgeId> edges) {
  const auto chosen = selected(source.polyhedron, edges, "Select edges.");
  if (!chosen) return chosen.error();
  const HalfEdgeMesh& mesh = source.polyhedron.topology();
  DisjointSets groups(mesh.face_count());
  std::set<Index> ends;
  for (const Index e : *chosen) {
    const Index h = mesh.half_edge_of_edge(e);
    if (mesh.is_border_edge(e))
      return make_error(e_wrong_selection, "A border edge has a face on one side only.",
                        "Select edges between two faces, or delete the face.",
                        element_of(source.polyhedron.edge_id(e)));
    groups.join(mesh.face(h), mesh.face(mesh.twin(h)));
    ends.insert({mesh.origin(h), mesh.target(h)});
  }
  MeshEditor draft(source);
  ElementSet selection;
  if (auto failed = join_groups(source.polyhedron, groups, draft, selection)) return *std::move(failed);
  if (selection.empty()) return not_a_disk(source.polyhedron.face_id(0));
  for (const Index v : ends) {
    const VertexId id = source.polyhedron.vertex_id(v);
    if (mesh.valence(v) > 2 && has_two_edges(draft, id) && !cannot_drop(draft, id)) drop_vertex(draft, id);
  }
  return std::move(draft).finish(std::move(selection));
}

Result<EditResult> dissolve_faces(const PolyhedronSource& source, std::span<const FaceId> faces) {
  const auto chosen = selected(source.polyhedron, faces, "Select neighbouring faces.");
  if (!chosen) return chosen.error();
  const HalfEdgeMesh& mesh = source.polyhedron.topology();
  std::vector<char> inside(mesh.face_count(), 0);
  for (const Index f : *chosen) inside[f] = 1;
  DisjointSets groups(mesh.face_count());
  bool any = false;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index twin = mesh.twin(h);
    if (twin == no_index || !inside[mesh.face(h)] || !inside[mesh.face(twin)]) continue;
    groups.join(mesh.face(h), mesh.face(twin));
    any = any || mesh.face(h) != mesh.face(twin);
  }
  if (!any)
    return make_error(e_wrong_selection, "No two of the faces are neighbours.",
                      "Select faces that share an edge.");
  MeshEditor draft(source);
  ElementSet selection;
  if (auto failed = join_groups(source.polyhedron, groups, draft, selection)) return *std::move(failed);
  return std::move(draft).finish(std::move(selection));
}

}  // namespace hariko

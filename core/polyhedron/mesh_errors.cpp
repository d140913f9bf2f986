#include "core/polyhedron/mesh_errors.hpp"

#include <string>

#include "core/base/ids.hpp"
#include "core/polyhedron/corner_fans.hpp"
#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/face_check.hpp"
#include "core/polyhedron/message_group.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

namespace {

Element dense_vertex(std::size_t v) {
  return element_of(VertexId{static_cast<Index>(v)});
}
Element dense_face(std::size_t f) {
  return element_of(FaceId{static_cast<Index>(f)});
}
Element dense_edge(Index a, Index b) {
  return element_of(EdgeId::of(VertexId{a}, VertexId{b}));
}

Index first_out_of_range(const PolygonMesh& mesh, std::size_t f) {
  for (Index v : mesh.face(f))
    if (v >= mesh.positions.size()) return v;
  return no_index;
}

/// Reports the faces with faults of their own; returns 1 for every sound face, 0 for the others.
std::vector<char> report_faces(const PolygonMesh& mesh, std::size_t limit, std::vector<Message>& out) {
  std::vector<FaceFault> faults(mesh.face_count());
  FaceCheck check(mesh.positions.size());
  for (std::size_t f = 0; f < faults.size(); ++f) faults[f] = check(mesh.face(f));

  const auto report = [&](FaceFault fault, Code code, const char* remedy, auto&& text) {
    MessageGroup group(out, Severity::error, code, remedy, limit);
    for (std::size_t f = 0; f < faults.size(); ++f)
      if (faults[f] == fault) group.add(dense_face(f), [&] { return text(f); });
  };
  report(FaceFault::index_range, e_index_range, "Correct the vertex number or delete the face.",
         [&](std::size_t f) {
           return "The face refers to vertex " + std::to_string(first_out_of_range(mesh, f)) +
                  ", but there are only " + std::to_string(mesh.positions.size()) +
                  " vertices, counted from 0.";
         });
  report(FaceFault::too_small, e_face_too_small, "Delete the face or add corners.", [&](std::size_t f) {
    const std::size_t sides = mesh.face(f).size();
    return "The face has " + std::to_string(sides) + (sides == 1 ? " corner" : " corners") +
           "; a face needs at least three.";
  });
  report(
      FaceFault::repeated_vertex, e_face_repeated_vertex,
      "Remove the repeated corner, or split the face into faces that each use a vertex once.",
      [](std::size_t) { return std::string("The face passes through one of its vertices more than once."); });

  std::vector<char> sound(faults.size());
  for (std::size_t f = 0; f < faults.size(); ++f) sound[f] = faults[f] == FaceFault::none;
  return sound;
}

std::string edge_text(std::span<const EdgeUse> uses) {
  if (uses.size() == 2)
    return "The two faces at the edge run along it in the same direction: one of them faces the other way.";
  return "The edge belongs to " + std::to_string(uses.size()) + " faces; an edge may have at most two.";
}

void report_edges(const PolygonMesh& mesh, const EdgeTable& edges, std::size_t limit,
                  std::vector<Message>& out) {
  MessageGroup group(out, Severity::error, e_edge_nonmanifold_or_flipped,
                     "Repair the orientation, or split the non-manifold edges.", limit);
  edges.for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
    if (!is_manifold_edge(mesh, uses)) group.add(dense_edge(low, high), [&] { return edge_text(uses); });
  });
}

void report_vertices(const CornerFans& fans, std::size_t limit, std::vector<Message>& out) {
  MessageGroup group(out, Severity::error, e_vertex_nonmanifold, "Split the non-manifold vertices.", limit);
  for (std::size_t v = 0; v < fans.fan_count.size(); ++v) {
    if (fans.fan_count[v] <= 1 || fans.at_faulty_edge[v] || fans.at_unsound_face[v]) continue;
    group.add(dense_vertex(v), [&] {
      return "The faces round the vertex form " + std::to_string(fans.fan_count[v]) +
             " separate fans that touch only in this point.";
    });
  }
}

}  // namespace

std::vector<Message> position_errors(const PolygonMesh& mesh, std::size_t limit) {
  std::vector<Message> out;
  {
    MessageGroup group(out, Severity::error, e_nonfinite, "Give the vertex finite coordinates.", limit);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      if (!mesh.positions[v].allFinite())
        group.add(dense_vertex(v),
                  [] { return std::string("A coordinate of the vertex is infinite or not a number."); });
  }
  return out;
}

std::vector<Message> connectivity_errors(const PolygonMesh& mesh, std::size_t limit) {
  std::vector<Message> out;
  if (mesh.face_count() == 0) {
    if (limit > 0)
      out.push_back(make_error(e_no_faces, "The object has no faces.", "Add at least one face."));
    return out;
  }
  const std::vector<char> sound = report_faces(mesh, limit, out);
  const EdgeTable edges(mesh, sound);
  report_edges(mesh, edges, limit, out);
  report_vertices(find_corner_fans(mesh, sound, edges), limit, out);
  return out;
}

}  // namespace hariko

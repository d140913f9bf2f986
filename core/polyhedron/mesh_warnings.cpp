#include "core/polyhedron/mesh_warnings.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "core/geometry/polygon.hpp"
#include "core/polyhedron/message_group.hpp"
#include "core/polyhedron/near_vertices.hpp"
#include "core/polyhedron/part_nesting.hpp"
#include "core/polyhedron/validation.hpp"
#include "core/polyhedron/volume.hpp"

namespace hariko {

namespace {

/// Input of all checks.
struct Checked {
  const HalfEdgeMesh& topology;
  std::span<const Vector3> positions;
  const ElementNames& names;
  std::size_t limit;
  std::vector<Message>& out;

  MessageGroup group(Code code, const char* remedy) const {
    return {out, Severity::warning, code, remedy, limit};
  }
};

void warn_isolated(const Checked& mesh) {
  MessageGroup group = mesh.group(w_isolated_vertex, "Delete it, or use it in a face.");
  for (Index v = 0; v < mesh.topology.vertex_count(); ++v)
    if (mesh.topology.outgoing(v) == no_index)
      group.add(mesh.names.vertex(v), [] { return std::string("No face uses the vertex; it is ignored."); });
}

/// Triangles of each closed component, for their nesting; none for those with the volume 0.
std::vector<PartNesting::Triangles> closed_parts(const HalfEdgeMesh& topology,
                                                 const std::vector<double>& volumes) {
  const std::vector<Index> component = topology.face_components();
  std::vector<PartNesting::Triangles> out(volumes.size());
  for (Index f = 0; f < topology.face_count(); ++f) {
    if (volumes[component[f]] == 0) continue;
    const std::span<const Index> corners = topology.face_vertices(f);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      out[component[f]].push_back({corners[0], corners[i], corners[i + 1]});
  }
  return out;
}

void warn_inside_out(const Checked& mesh) {
  const std::vector<Index> component = mesh.topology.face_components();
  const std::vector<char> wrong = inside_out_components(mesh.topology, mesh.positions);
  MessageGroup group = mesh.group(w_inside_out, "Turn it: Mesh > Flip, or --repair where it is opened.");
  Index next = 0;  // components are numbered by their first face
  for (Index f = 0; f < mesh.topology.face_count(); ++f) {
    if (component[f] != next) continue;
    if (wrong[next++])
      group.add(mesh.names.face(f),
                [] { return std::string("The closed part with this face is inside out."); });
  }
}

/// Length that counts as zero: 1e-12 of the diagonal of the bounding box of all used vertices.
double zero_length(const Checked& mesh) {
  Eigen::AlignedBox3d box;
  for (Index v = 0; v < mesh.topology.vertex_count(); ++v)
    if (mesh.topology.outgoing(v) != no_index) box.extend(mesh.positions[v]);
  const double size = box.sizes().stableNorm();
  return std::isfinite(size) ? 1e-12 * size : 0;
}

/// Warns of vertices on borders only. Where faces close round a vertex a weld closes nothing: bodies that
/// touch, and a body that touches itself, are kept apart there on purpose (`separate_bodies`).
void warn_duplicates(const Checked& mesh, double zero) {
  std::vector<Index> used;
  std::vector<Vector3> points;
  for (Index v = 0; v < mesh.topology.vertex_count(); ++v) {
    if (!mesh.topology.is_border_vertex(v)) continue;
    used.push_back(v);
    points.push_back(mesh.positions[v]);
  }
  const std::vector<Index> standing = representatives(points, zero);
  MessageGroup group = mesh.group(w_duplicate_vertex, "Weld the two vertices, or move them apart.");
  for (std::size_t i = 0; i < used.size(); ++i) {
    const Index v = used[i], other = used[standing[i]];
    if (v == other) continue;
    group.add(mesh.names.vertex(v), [&] {
      return "The vertex lies at the same place as vertex " +
             std::to_string(mesh.names.vertex_id(other).value) + ".";
    });
  }
}

void warn_zero_edges(const Checked& mesh, double zero) {
  MessageGroup group = mesh.group(w_zero_edge, "Weld its two vertices, or move them apart.");
  for (Index e = 0; e < mesh.topology.edge_count(); ++e) {
    const Index h = mesh.topology.half_edge_of_edge(e);
    const Index a = mesh.topology.origin(h), b = mesh.topology.target(h);
    if ((mesh.positions[a] - mesh.positions[b]).stableNorm() <= zero)
      group.add(mesh.names.edge(a, b),
                [] { return std::string("The edge has no length; the surface may fold there."); });
  }
}

void warn_face_shapes(const Checked& mesh) {
  std::vector<FaceShape> shapes(mesh.topology.face_count());
  std::vector<Vector3> corners;
  for (Index f = 0; f < shapes.size(); ++f) {
    corners.clear();
    for (Index v : mesh.topology.face_vertices(f)) corners.push_back(mesh.positions[v]);
    shapes[f] = classify_face(corners);
  }
  const auto report = [&](FaceShape shape, MessageGroup group, const char* text) {
    for (Index f = 0; f < shapes.size(); ++f)
      if (shapes[f] == shape) group.add(mesh.names.face(f), [&] { return std::string(text); });
  };
  report(FaceShape::concave, mesh.group(w_concave_face, "Split it into convex faces."),
         "The face is concave; the surface may fold over it.");
  report(FaceShape::self_crossing, mesh.group(w_self_crossing_face, "Move or reorder its corners."),
         "Sides of the face cross each other; the surface folds over it.");
}

void warn_valence_2(const Checked& mesh) {
  MessageGroup group = mesh.group(w_valence_2, "Remove it, or join it to another vertex by an edge.");
  for (Index v = 0; v < mesh.topology.vertex_count(); ++v)
    if (mesh.topology.corner_count(v) == 2 && !mesh.topology.is_border_vertex(v))
      group.add(mesh.names.vertex(v),
                [] { return std::string("Only two edges meet at this inner vertex."); });
}

}  // namespace

std::vector<char> inside_out_components(const HalfEdgeMesh& topology, std::span<const Vector3> positions) {
  const std::vector<double> volumes = closed_component_volumes(topology, positions);
  std::vector<char> out;
  bool inwards = false, outwards = false;
  for (const double volume : volumes) {
    out.push_back(volume < 0);
    inwards = inwards || volume < 0;
    outwards = outwards || volume > 0;
  }
  if (!inwards || !outwards) return out;
  PartNesting nesting(positions, closed_parts(topology, volumes));
  for (Index part = 0; part < out.size(); ++part) {
    if (!out[part]) continue;
    int depth = 0;
    for (const Index around : nesting.around(part)) depth += volumes[around] > 0 ? 1 : -1;
    if (depth > 0) out[part] = 0;
  }
  return out;
}

std::vector<Message> mesh_warnings(const HalfEdgeMesh& topology, std::span<const Vector3> positions,
                                   const ElementNames& names, std::size_t limit) {
  std::vector<Message> out;
  const Checked mesh{topology, positions, names, limit, out};
  const double zero = zero_length(mesh);
  warn_isolated(mesh);
  warn_inside_out(mesh);
  warn_duplicates(mesh, zero);
  warn_zero_edges(mesh, zero);
  warn_face_shapes(mesh);
  warn_valence_2(mesh);
  return out;
}

std::vector<Message> face_shape_warnings(const HalfEdgeMesh& topology, std::span<const Vector3> positions,
                                         const ElementNames& names, std::size_t limit) {
  std::vector<Message> out;
  warn_face_shapes({topology, positions, names, limit, out});
  return out;
}

}  // namespace hariko

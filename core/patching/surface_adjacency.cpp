#include "core/patching/surface_adjacency.hpp"

#include <Eigen/Geometry>

namespace hariko {

namespace {

/// Whether all patches at the vertex share one tangent plane.
bool has_plane(const HalfEdgeMesh& mesh, const VertexFrames& frames, Index v) {
  switch (frames.kind[v]) {
    case FrameKind::smooth:
    case FrameKind::straight:
      return true;
    case FrameKind::isolated:
      return false;
    case FrameKind::sharp_line:
    case FrameKind::corner:
      break;
  }
  if (!mesh.is_border_vertex(v)) return false;
  Index h = mesh.rotate(mesh.outgoing(v));
  for (; h != no_index; h = mesh.rotate(h))
    if (frames.sharp[mesh.edge(h)]) return false;
  return true;
}

Vector3 vertex_normal(const QuarticPatch& patch) {
  using namespace quartic;
  const auto& d = patch.control;
  return (d[d031] - d[d040]).cross(d[d130] - d[d040]).stableNormalized();
}

Vector3 centre_normal(const QuarticPatch& patch) {
  using namespace quartic;
  const auto& d = patch.control;
  return (d[d310] - d[d400]).cross(d[d301] - d[d400]).stableNormalized();
}

}  // namespace

Surface::Parts polyhedron_surface_parts(const Polyhedron& polyhedron, const VertexFrames& frames,
                                        const ElementAliases* aliases, Continuity smooth) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  Surface::Parts parts;
  std::vector<Index> vertex_node(mesh.vertex_count(), no_index);
  Index node = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.outgoing(v) != no_index) vertex_node[v] = node++;
  const Index first_centre = node;
  parts.node_count = first_centre + mesh.face_count();

  auto corner_nodes = std::make_shared<std::vector<Index>>();
  auto provenance = std::make_shared<std::vector<Provenance>>();
  auto seams = std::make_shared<std::vector<Seam>>();
  auto boundary_sides = std::make_shared<std::vector<PatchSide>>();
  auto boundary_sources = std::make_shared<std::vector<Element>>();
  corner_nodes->reserve(3 * std::size_t(mesh.half_edge_count()));
  provenance->reserve(mesh.half_edge_count());
  seams->reserve(std::size_t(mesh.half_edge_count()) + mesh.edge_count());
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index f = mesh.face(h);
    corner_nodes->push_back(first_centre + f);
    corner_nodes->push_back(vertex_node[mesh.origin(h)]);
    corner_nodes->push_back(vertex_node[mesh.target(h)]);
    const FaceId face = polyhedron.face_id(f);
    const Index side = h - mesh.face_begin(f);
    const bool copy = aliases && aliases->is_copy(face);
    provenance->push_back({element_of(aliases ? aliases->original(face, polyhedron.vertex_id(mesh.origin(h)),
                                                                  polyhedron.vertex_id(mesh.target(h)))
                                              : face),
                           copy ? mesh.side_count(f) - 1 - side : side});
    Seam split;
    split.first = {h, 0};
    split.second = {mesh.previous(h), 2};
    split.intended = smooth;
    seams->push_back(split);
  }
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e), twin = mesh.twin(h);
    const EdgeId edge = polyhedron.edge_id(e);
    Element source = aliases ? aliases->original(edge) : element_of(edge);
    if (source.kind != Element::Kind::edge) source = {};  // within a face that was cut
    if (twin == no_index) {
      boundary_sides->push_back({h, 1});
      boundary_sources->push_back(source);
      continue;
    }
    Seam seam;
    seam.first = {h, 1};
    seam.second = {twin, 1};
    seam.intended = frames.sharp[e] ? Continuity::g0 : smooth;
    seam.source = source;
    seams->push_back(seam);
  }
  parts.corner_nodes = std::move(corner_nodes);
  parts.provenance = std::move(provenance);
  parts.seams = std::move(seams);
  parts.boundary_sides = std::move(boundary_sides);
  parts.boundary_sources = std::move(boundary_sources);
  return parts;
}

CornerNormal corner_normals(const QuarticPatchArray& patches) {
  return [&patches](Index patch, int corner) {
    return corner == 0 ? centre_normal(patches[patch]) : vertex_normal(patches[patch]);
  };
}

std::vector<Vector3> node_normals(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                                  const Surface::Parts& parts, const CornerNormal& normal) {
  std::vector<Vector3> normals(parts.node_count, Vector3::Zero());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index h = mesh.outgoing(v);
    if (h != no_index && has_plane(mesh, frames, v))
      normals[(*parts.corner_nodes)[3 * std::size_t(h) + 1]] = normal(h, 1);
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index h = mesh.face_begin(f);
    normals[(*parts.corner_nodes)[3 * std::size_t(h)]] = normal(h, 0);
  }
  return normals;
}

void update_node_normals(const HalfEdgeMesh& mesh, const VertexFrames& frames, const Surface::Parts& parts,
                         const CornerNormal& normal, std::span<const Index> changed,
                         std::vector<Vector3>& normals) {
  for (const Index h : changed) {
    const Index* nodes = parts.corner_nodes->data() + 3 * std::size_t(h);
    if (mesh.face_begin(mesh.face(h)) == h) normals[nodes[0]] = normal(h, 0);
    const Index v = mesh.origin(h);
    if (mesh.outgoing(v) == h && has_plane(mesh, frames, v)) normals[nodes[1]] = normal(h, 1);
  }
}

}  // namespace hariko

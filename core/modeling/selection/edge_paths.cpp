#include "core/modeling/selection/edge_paths.hpp"

#include <algorithm>

namespace hariko {
namespace {

/// Half-edge straight on from the target of this one, or no_index.
Index straight_on(const HalfEdgeMesh& mesh, Index h) {
  const Index v = mesh.target(h);
  if (mesh.is_border_vertex(v)) return mesh.twin(h) == no_index ? mesh.outgoing(v) : no_index;
  switch (mesh.valence(v)) {
    case 2:
      return mesh.rotate(mesh.twin(h));
    case 4:
      return mesh.rotate(mesh.rotate(mesh.twin(h)));
    default:
      return no_index;
  }
}

/// Half-edges after `start`, up to where the path ends or closes.
std::vector<Index> follow(const HalfEdgeMesh& mesh, Index start, bool& closed) {
  std::vector<Index> path;
  Index h = straight_on(mesh, start);
  for (; h != no_index && h != start; h = straight_on(mesh, h)) path.push_back(h);
  closed = h == start;
  return path;
}

/// Walks a ring from a half-edge whose face is the next to be crossed. Calls visit(o) with each opposite
/// half-edge; returns true when the walk came back to the start.
template <class Visit>
bool cross_quads(const HalfEdgeMesh& mesh, Index start, Visit&& visit) {
  for (Index h = start; h != no_index && mesh.side_count(mesh.face(h)) == 4;) {
    const Index opposite = mesh.next(mesh.next(h));
    if (mesh.edge(opposite) == mesh.edge(start)) return true;
    visit(opposite);
    h = mesh.twin(opposite);
  }
  return false;
}

}  // namespace

std::vector<EdgeId> edge_loop(const Polyhedron& polyhedron, EdgeId edge) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const Index e = polyhedron.find(edge);
  if (e == no_index) return {};
  const Index start = mesh.half_edge_of_edge(e);
  bool closed = false;
  std::vector<Index> path;
  const std::vector<Index> forward = follow(mesh, start, closed);
  if (!closed && mesh.twin(start) != no_index) {
    path = follow(mesh, mesh.twin(start), closed);
    std::reverse(path.begin(), path.end());
  }
  path.push_back(start);
  path.insert(path.end(), forward.begin(), forward.end());
  std::vector<EdgeId> out;
  for (const Index h : path) out.push_back(polyhedron.edge_id(mesh.edge(h)));
  return out;
}

EdgeRing find_edge_ring(const Polyhedron& polyhedron, Index edge) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const Index start = mesh.half_edge_of_edge(edge);
  EdgeRing forward;
  forward.closed = cross_quads(mesh, start, [&](Index opposite) {
    forward.edges.push_back(mesh.edge(opposite));
    forward.starts.push_back(mesh.target(opposite));
  });
  EdgeRing ring;
  ring.closed = forward.closed;
  if (!forward.closed && mesh.twin(start) != no_index) {
    cross_quads(mesh, mesh.twin(start), [&](Index opposite) {
      ring.edges.push_back(mesh.edge(opposite));
      ring.starts.push_back(mesh.origin(opposite));
    });
    std::reverse(ring.edges.begin(), ring.edges.end());
    std::reverse(ring.starts.begin(), ring.starts.end());
  }
  ring.edges.push_back(edge);
  ring.starts.push_back(mesh.origin(start));
  ring.edges.insert(ring.edges.end(), forward.edges.begin(), forward.edges.end());
  ring.starts.insert(ring.starts.end(), forward.starts.begin(), forward.starts.end());
  return ring;
}

std::vector<EdgeId> edge_ring(const Polyhedron& polyhedron, EdgeId edge) {
  const Index e = polyhedron.find(edge);
  if (e == no_index) return {};
  std::vector<EdgeId> out;
  for (const Index member : find_edge_ring(polyhedron, e).edges) out.push_back(polyhedron.edge_id(member));
  return out;
}

}  // namespace hariko

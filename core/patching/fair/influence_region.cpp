#include "core/patching/fair/influence_region.hpp"

namespace hariko {

Neighbourhood neighbourhood(const HalfEdgeMesh& mesh, const std::vector<Index>& moved, int rings) {
  std::vector<bool> face_in(mesh.face_count(), false), vertex_in(mesh.vertex_count(), false);
  std::vector<Index> front = moved;
  for (const Index v : moved) vertex_in[v] = true;
  for (int ring = 0; ring < rings && !front.empty(); ++ring) {
    std::vector<Index> next;
    for (const Index v : front)
      for (const Index h : mesh.fan_corners(v)) {
        const Index f = mesh.face(h);
        if (face_in[f]) continue;
        face_in[f] = true;
        for (const Index w : mesh.face_vertices(f))
          if (!vertex_in[w]) {
            vertex_in[w] = true;
            next.push_back(w);
          }
      }
    front = std::move(next);
  }
  Neighbourhood out;
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (face_in[f]) out.faces.push_back(f);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (vertex_in[v] && mesh.outgoing(v) != no_index) out.vertices.push_back(v);
  return out;
}

LocalDrag local_drag(const SurfaceSystem& system, const std::vector<Index>& moved,
                     const std::vector<double>& weight, int rings, double tolerance) {
  HARIKO_ASSERT(!system.network.couples_coordinates(), "normal pins couple the coordinates");
  const HalfEdgeMesh& mesh = *system.mesh;
  LocalDrag out;
  out.near = neighbourhood(mesh, moved, rings);
  out.field.assign(mesh.vertex_count(), Vector3::Zero());
  for (std::size_t i = 0; i < moved.size(); ++i) out.field[moved[i]] = weight[i] * Vector3::UnitX();
  NetworkSystem::SolveOptions options;
  options.active_vertices = &out.near.vertices;
  options.tolerance = tolerance;
  options.homogeneous = true;
  const auto solution = system.network.solve(out.field, options);
  Network& network = out.network;
  network.start.assign(mesh.half_edge_count(), Vector3::Zero());
  network.end.assign(mesh.half_edge_count(), Vector3::Zero());
  const auto set_tangents = [&](Index h) {
    std::tie(network.start[h], network.end[h]) = system.network.tangents(h, solution.basis);
  };
  for (const Index f : out.near.faces)
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      set_tangents(h);
      if (mesh.twin(h) != no_index) set_tangents(mesh.twin(h));
    }
  return out;
}

}  // namespace hariko

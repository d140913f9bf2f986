#include "core/patching/drag_response.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

/// Rings of faces to solve in: 0.27^12 is 1.5e-7.
constexpr int ring_count = 12;
/// Patches whose control points all move by less than this share of the displacement are left alone.
constexpr double negligible_share = 2e-7;
constexpr double response_tolerance = 1e-8;

struct Neighbourhood {
  std::vector<Index> faces, vertices;  ///< ascending
};

Neighbourhood neighbourhood(const HalfEdgeMesh& mesh, const std::vector<Index>& moved) {
  std::vector<bool> face_in(mesh.face_count(), false), vertex_in(mesh.vertex_count(), false);
  std::vector<Index> front = moved;
  for (const Index v : moved) vertex_in[v] = true;
  for (int ring = 0; ring < ring_count && !front.empty(); ++ring) {
    std::vector<Index> next;
    for (const Index v : front) {
      const Index first = mesh.outgoing(v);
      for (Index h = first; h != no_index;) {
        const Index f = mesh.face(h);
        if (!face_in[f]) {
          face_in[f] = true;
          for (const Index w : mesh.face_vertices(f))
            if (!vertex_in[w]) {
              vertex_in[w] = true;
              next.push_back(w);
            }
        }
        h = mesh.rotate(h);
        if (h == first) break;
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

/// Tangents of a displacement field: zero outside the neighbourhood.
Network local_network(const SurfaceSystem& system, const Neighbourhood& near,
                      std::span<const Vector3> field) {
  const HalfEdgeMesh& mesh = *system.mesh;
  NetworkSystem::SolveOptions options;
  options.active_vertices = &near.vertices;
  options.tolerance = response_tolerance;
  options.homogeneous = true;
  const auto solution = system.network.solve(field, options);
  Network network;
  network.start.assign(mesh.half_edge_count(), Vector3::Zero());
  network.end.assign(mesh.half_edge_count(), Vector3::Zero());
  const auto set_tangents = [&](Index h) {
    std::tie(network.start[h], network.end[h]) = system.network.tangents(h, solution.basis);
  };
  for (const Index f : near.faces)
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      set_tangents(h);
      if (mesh.twin(h) != no_index) set_tangents(mesh.twin(h));
    }
  return network;
}

}  // namespace

DragResponse drag_response(const SurfaceSystem& system, std::vector<Index> moved, std::vector<double> weight,
                           const CancelToken& cancel) {
  HARIKO_ASSERT(!system.network.couples_coordinates(), "normal pins couple the coordinates");
  const HalfEdgeMesh& mesh = *system.mesh;
  DragResponse response;
  HARIKO_ASSERT(moved.size() == weight.size(), "one weight a vertex");
  response.moved = std::move(moved);
  response.weight = std::move(weight);
  const Neighbourhood near = neighbourhood(mesh, response.moved);

  // A unit displacement along x; the other coordinates stay zero.
  std::vector<Vector3> field(mesh.vertex_count(), Vector3::Zero());
  for (std::size_t i = 0; i < response.moved.size(); ++i)
    field[response.moved[i]] = response.weight[i] * Vector3::UnitX();
  FairSystem::SolveOptions options;
  options.active_faces = &near.faces;
  options.tolerance = response_tolerance;
  ZeroedArray<QuarticPatch> patches(mesh.half_edge_count());
  build_patches(system, field, local_network(system, near, field), {near.faces, near.vertices}, options,
                cancel, patches.span());

  auto felt = std::make_shared<std::vector<Index>>();
  for (const Index f : near.faces)
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      std::array<double, quartic_control_count> share;
      double largest = 0;
      for (std::size_t i = 0; i < quartic_control_count; ++i) {
        share[i] = patches[h].control[i].x();
        largest = std::max(largest, std::abs(share[i]));
      }
      if (largest < negligible_share) continue;
      felt->push_back(h);
      response.share.push_back(share);
    }
  response.patches = std::move(felt);
  return response;
}

QuarticPatchArray displaced(const QuarticPatchArray& base, const DragResponse& response,
                            const Vector3& displacement) {
  QuarticPatchArray out = base;
  for (std::size_t k = 0; k < response.share.size(); ++k) {
    QuarticPatch& patch = out.edit((*response.patches)[k]);
    for (std::size_t i = 0; i < quartic_control_count; ++i)
      patch.control[i] += response.share[k][i] * displacement;
  }
  return out;
}

}  // namespace hariko

#include "core/patching/drag_response.hpp"

#include <algorithm>
#include <cmath>

#include "core/patching/drag_region.hpp"

namespace hariko {

namespace {

/// Rings of faces to solve in: 0.27^12 is 1.5e-7.
constexpr int ring_count = 12;
/// Patches whose control points all move by less than this share of the displacement are left alone.
constexpr double negligible_share = 2e-7;
constexpr double response_tolerance = 1e-8;

}  // namespace

DragResponse drag_response(const SurfaceSystem& system, std::vector<Index> moved, std::vector<double> weight,
                           const CancelToken& cancel) {
  HARIKO_ASSERT(!system.network.couples_coordinates(), "normal pins couple the coordinates");
  const HalfEdgeMesh& mesh = *system.mesh;
  DragResponse response;
  HARIKO_ASSERT(moved.size() == weight.size(), "one weight a vertex");
  response.moved = std::move(moved);
  response.weight = std::move(weight);
  const Neighbourhood near = neighbourhood(mesh, response.moved, ring_count);

  const std::vector<Vector3> field = unit_displacement(mesh, response.moved, response.weight);
  FairSystem::SolveOptions options;
  options.active_faces = &near.faces;
  options.tolerance = response_tolerance;
  ZeroedArray<QuarticPatch> patches(mesh.half_edge_count());
  build_patches(system, field, local_network(system, near, field, response_tolerance),
                {near.faces, near.vertices}, options, cancel, patches.span());

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

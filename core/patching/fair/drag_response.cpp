#include "core/patching/fair/drag_response.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

/// Number of rings to solve in: 0.27^16 is 8e-10, relative to a displacement that is a part of the object's
/// size.
constexpr int ring_count = 16;
constexpr double response_tolerance = 1e-10;
constexpr int steps_a_frame = 6;

}  // namespace

DragResponse drag_response(const SurfaceSystem& system, std::vector<Index> moved, std::vector<double> weight,
                           const CancelToken& cancel) {
  HARIKO_ASSERT(moved.size() == weight.size(), "one weight a vertex");
  DragResponse response;
  response.moved = std::move(moved);
  response.weight = std::move(weight);
  response.local = local_drag(system, response.moved, response.weight, ring_count, response_tolerance);
  refine(system, response, cancel);
  return response;
}

void refine(const SurfaceSystem& system, DragResponse& response, const CancelToken& cancel) {
  const HalfEdgeMesh& mesh = *system.mesh;
  const LocalDrag& local = response.local;
  FairSystem::SolveOptions options;
  options.active_faces = &local.near.faces;
  options.tolerance = response_tolerance;
  options.max_steps = steps_a_frame;
  if (response.unknowns.size() > 0) options.start = &response.unknowns;
  ZeroedArray<QuarticPatch> patches(mesh.half_edge_count());
  auto solution = build_patches(system, local.field, local.network, {local.near.faces, local.near.vertices},
                                options, cancel, patches.span());
  if (solution.cancelled) return;
  response.settled = solution.converged;
  response.unknowns = std::move(solution.unknowns);
  response.patches.clear();
  response.share.clear();
  response.largest.clear();
  for (const Index f : local.near.faces)
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      std::array<double, quartic_control_count> share;
      double largest = 0;
      for (std::size_t i = 0; i < quartic_control_count; ++i) {
        share[i] = patches[h].control[i].x();
        largest = std::max(largest, std::abs(share[i]));
      }
      if (largest < negligible_share) continue;
      response.patches.push_back(h);
      response.share.push_back(share);
      response.largest.push_back(largest);
    }
}

QuarticPatchArray displaced(const QuarticPatchArray& base, const DragResponse& response,
                            const Vector3& displacement, double negligible, std::vector<Index>& changed) {
  QuarticPatchArray out = base;
  const double length = displacement.norm();
  for (std::size_t k = 0; k < response.share.size(); ++k) {
    if (!(response.largest[k] * length > negligible)) continue;
    changed.push_back(response.patches[k]);
    QuarticPatch& patch = out.edit(response.patches[k]);
    for (std::size_t i = 0; i < quartic_control_count; ++i)
      patch.control[i] += response.share[k][i] * displacement;
  }
  return out;
}

}  // namespace hariko

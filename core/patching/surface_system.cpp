#include "core/patching/surface_system.hpp"

#include "core/base/parallel.hpp"
#include "core/patching/quartic/rings.hpp"

namespace hariko {

namespace {
constexpr std::size_t base_face_grain = 64;
}

FairSystem::Solution build_patches(const SurfaceSystem& system, std::span<const Vector3> positions,
                                   const Network& network, const PatchRegion& region,
                                   const FairSystem::SolveOptions& options, const CancelToken& cancel,
                                   std::span<QuarticPatch> patches, const JoinGeometry& joins,
                                   std::span<const Index> rims) {
  const HalfEdgeMesh& mesh = *system.mesh;
  const auto& faces = region.faces;
  PatchNetwork split;
  split.split_tangent.assign(mesh.half_edge_count(), Vector3::Zero());
  split.centre.assign(mesh.face_count(), Vector3::Zero());
  split.centre_tangent.assign(mesh.half_edge_count(), Vector3::Zero());
  fill_split_tangents(mesh, system.network.frames(), system.constants, positions, network, faces, split);

  // Split tangents of joined half-turn corners: given by the join, and zero in the response to a
  // displacement.
  if (!system.given_side.empty())
    for (const Index f : faces)
      for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h)
        if (system.given_side[h])
          for (const Index corner : {h, mesh.next(h)})
            if (system.constants.free_split[corner]) split.split_tangent[corner].setZero();
  for (const PrescribedSplit& given : joins.splits) split.split_tangent[given.half_edge] = given.tangent;

  const PatchBuilder builder(mesh, system.constants, positions, network, split);
  const auto build_base = [&] {
    parallel_for(faces.size(), base_face_grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        for (Index h = mesh.face_begin(faces[k]); h < mesh.face_end(faces[k]); ++h)
          patches[h] = builder.base_patch(h);
    });
    for (const PrescribedSide& given : joins.sides) {
      patches[given.half_edge].control[quartic::d121u] = given.at_origin;
      patches[given.half_edge].control[quartic::d112u] = given.at_target;
    }
  };
  if (!system.fair) {
    fill_split_points(mesh, system.network.frames().charts, positions, faces, split);
    build_base();
    solve_rings(mesh, system.constants, system.mode, region.vertices, faces, patches, system.given_side);
    return {};
  }
  build_base();  // with O and Y zero: the part that does not depend on the unknowns
  std::vector<BoundaryCurvatureLoad> bends;
  const FaceCharts& charts = system.network.frames().charts;
  for (const Index h : rims)
    bends.push_back(rim_bend(mesh, positions, network, patches, h, rim_measure(mesh, charts, h)));
  FairSystem::SolveOptions with_rims = options;
  with_rims.rims = bends;
  FairSystem::Solution solution = system.fair->solve(patches, with_rims, cancel);
  if (solution.cancelled) return solution;
  system.fair->fill_split_points(solution.unknowns, faces, split);
  build_base();
  system.fair->add_free_parts(solution.unknowns, faces, patches);
  return solution;
}

}  // namespace hariko

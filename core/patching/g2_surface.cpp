#include "core/patching/g2_surface.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/patching/quartic/quartic_kernel.hpp"

namespace hariko {

namespace {

constexpr std::size_t g2_face_grain = 64;
/// Number of rings of faces to solve in: 0.27^18 is 6e-11.
constexpr int g2_ring_count = 18;
constexpr double g2_response_tolerance = 1e-12;
constexpr int g2_steps_a_frame = 14;

}  // namespace

ReferencePatches reference_patches(const QuarticPatchArray& patches) {
  return [patches, kernel = quartic_kernel()](Index patch, std::span<const ChartPoint> at,
                                              std::span<PatchPoint> out) {
    std::vector<Vector2> parameters;
    for (const ChartPoint& point : at) parameters.push_back(point.barycentric);
    kernel.second_order(patches[patch], quartic_point_table(parameters), out.size(), out.data());
  };
}

std::shared_ptr<const G2PatchSet> g2_patches(const G2System& system, const G2System::Given& given,
                                             const G2System::Field& unknowns) {
  std::vector<std::shared_ptr<const G2Face>> faces(system.mesh().face_count());
  parallel_for(faces.size(), g2_face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      faces[f] = std::make_shared<const G2Face>(system.controls(static_cast<Index>(f), given, unknowns));
  });
  return std::make_shared<const G2PatchSet>(system.atlas(), std::move(faces));
}

G2DragResponse g2_drag_response(const SurfaceSystem& system, std::vector<Index> moved,
                                std::vector<double> weight, const CancelToken& cancel) {
  HARIKO_ASSERT(moved.size() == weight.size(), "one weight a vertex");
  G2DragResponse response;
  response.moved = std::move(moved);
  response.weight = std::move(weight);
  response.local = local_drag(system, response.moved, response.weight, g2_ring_count, g2_response_tolerance);
  refine(system, response, cancel);
  return response;
}

void refine(const SurfaceSystem& system, G2DragResponse& response, const CancelToken& cancel) {
  const LocalDrag& local = response.local;
  G2System::SolveOptions options;
  options.active_faces = &local.near.faces;
  options.only_x = true;
  options.tolerance = g2_response_tolerance;
  options.max_steps = g2_steps_a_frame;
  options.paused = response.paused;
  const G2System::Given given{local.field, &local.network};
  const auto solution = system.g2->solve(given, options, cancel);
  if (solution.cancelled) return;
  response.settled = solution.converged;
  response.paused = solution.paused;
  response.faces.clear();
  response.share.clear();
  response.largest.clear();
  for (const Index f : local.near.faces) {
    const G2Face controls = system.g2->controls(f, given, solution.unknowns);
    std::vector<double> share;
    share.reserve(controls.size());
    double largest = 0;
    for (const Vector3& control : controls) {
      share.push_back(control.x());
      largest = std::max(largest, std::abs(control.x()));
    }
    if (largest < negligible_share) continue;
    response.faces.push_back(f);
    response.share.push_back(std::move(share));
    response.largest.push_back(largest);
  }
}

std::shared_ptr<const G2PatchSet> displaced(const HalfEdgeMesh& mesh, const G2PatchSet& base,
                                            const G2DragResponse& response, const Vector3& displacement,
                                            double negligible, std::vector<Index>& changed) {
  std::vector<std::shared_ptr<const G2Face>> faces = base.faces();
  const double length = displacement.norm();
  for (std::size_t k = 0; k < response.faces.size(); ++k) {
    if (!(response.largest[k] * length > negligible)) continue;
    const Index f = response.faces[k];
    auto moved = std::make_shared<G2Face>(*faces[f]);
    for (std::size_t i = 0; i < moved->size(); ++i) (*moved)[i] += response.share[k][i] * displacement;
    faces[f] = std::move(moved);
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) changed.push_back(h);
  }
  return std::make_shared<const G2PatchSet>(base.atlas(), std::move(faces));
}

}  // namespace hariko

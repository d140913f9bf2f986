#include "core/approximation/approximate.hpp"

#include <Eigen/Geometry>
#include <numbers>

#include "core/approximation/decimation/offset_vertices.hpp"
#include "core/approximation/decimation/optimise.hpp"
#include "core/approximation/mesh_report.hpp"
#include "core/approximation/refinement/bisection.hpp"
#include "core/approximation/refinement/cell_sizes.hpp"

namespace hariko {

namespace {

/// Size of a surface: the diagonal of the box of a few points of every patch; not a number where there are
/// none.
double size_of(const SurfaceSampler& sampler) {
  const Surface& surface = sampler.surface();
  const std::vector<Vector2> parameters = GridPattern{surface.domain(), 3}.parameters();
  std::vector<Vector3> points(parameters.size());
  Eigen::AlignedBox3d box;
  for (Index p = 0; p < surface.patch_count(); ++p) {
    sampler.positions(p, parameters, points);
    for (const Vector3& q : points) box.extend(q);
  }
  return box.diagonal().norm();
}

std::string limit_text(const MeshOptions& options) {
  return "The limit of " + std::to_string(options.facet_limit) +
         " facets was reached before the tolerance was.";
}

/// Adds warnings from the measured errors and from the refinement.
void add_warnings(const MeshOptions& options, const BisectionResult& refined, MeshApproximation& out) {
  out.unreached = refined.unreached;
  if (refined.limit_reached)
    out.warnings.push_back(make_warning(w_mesh_limit, limit_text(options), "Choose a larger tolerance."));
  if (refined.unreached > 0)
    out.warnings.push_back(
        make_warning(w_mesh_unreached,
                     "The tolerance was not reached: " + std::to_string(refined.unreached) +
                         " facets are above it (edges too short).",
                     "Look for kinks, cusps or folds of the surface there."));
  if (options.balanced)
    out.warnings.push_back(make_warning(
        w_mesh_balanced, "The vertices stay on the surface: it does not bend one way everywhere.",
        "Balance surfaces with positive Gaussian curvature, by a distance alone."));
  const std::optional<double>& angle = options.criteria.min_angle;
  const auto tenths = static_cast<int>(out.smallest_angle * 180 / std::numbers::pi * 10);
  if (angle && out.smallest_angle < *angle)
    out.warnings.push_back(make_warning(w_mesh_unreached,
                                        "The smallest angle of a facet is " + std::to_string(tenths / 10) +
                                            "." + std::to_string(tenths % 10) + " degrees.",
                                        "Ask for a smaller angle, or let the mesh be optimised."));
}

/// Share of the progress that balancing takes; where balancing does not apply, the rest follows.
constexpr double balancing_share = 0.5;

}  // namespace

Result<MeshApproximation> approximate(const Surface& surface, const MeshOptions& options,
                                      const CancelToken& cancel, const Progress& progress) {
  if (surface.patch_count() == 0)
    return make_error(e_mesh_nothing, "There is nothing to approximate.", "Select an object with a surface.");
  const SurfaceSampler sampler(surface);
  const double size = size_of(sampler);
  if (!(size > 0)) return make_error(e_mesh_surface, "The surface is shrunk to a point.", "Give it a size.");
  if (auto error = check_criteria(options.criteria, size)) return *error;
  const FacetErrors errors(sampler, options.criteria);
  const auto cancelled = [] { return make_error(e_cancelled, "The meshing was cancelled."); };
  if (options.balanced) {
    auto balanced = balanced_mesh(sampler, options, cancel, progress.part(0, balancing_share));
    if (cancel.cancelled()) return cancelled();
    if (balanced) {
      MeshApproximation out =
          mesh_report(sampler, errors, options, *balanced, {}, cancel, progress.part(balancing_share, 1));
      if (cancel.cancelled()) return cancelled();
      return out;
    }
  }
  const bool optimised = options.optimise || options.balanced;
  const double begun = options.balanced ? balancing_share : 0;
  ParameterMesh mesh = optimised ? optimised_mesh(sampler, options, cancel, progress.part(begun, 0.8))
                                 : start_mesh(sampler, options);
  // An optimised mesh is good already except for folds, which the optimiser only estimates.
  const BisectionResult refined =
      bisect(sampler, errors, options, mesh, cancel, progress.part(optimised ? 0.8 : 0, 0.85));
  if (refined.cancelled) return cancelled();
  MeshApproximation out =
      mesh_report(sampler, errors, options, mesh, refined, cancel, progress.part(0.85, 1));
  if (cancel.cancelled()) return cancelled();
  if (out.mesh.triangles.empty())
    return make_error(e_mesh_surface, "The surface has no area.", "Give it an extent in two directions.");
  add_warnings(options, refined, out);
  return out;
}

}  // namespace hariko

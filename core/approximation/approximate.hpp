#pragma once

// Triangle meshes of surfaces under tolerances (Yamamoto and Saitoh, with corrections).

#include <vector>

#include "core/approximation/mesh_options.hpp"
#include "core/approximation/refinement/parameter_mesh.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

/// Errors of a mesh by one criterion: lengths, radians or differences of luminance.
struct CriterionErrors {
  bool measured = false;  ///< false: all members below are empty
  double largest = 0, mean = 0;
  Index facet = no_index;  ///< the facet with the largest error
  /// Certain upper bound of the error at any point. Only where `certified`; otherwise `largest` is the
  /// largest of the samples.
  double bound = 0;
  bool certified = false;
  std::vector<float> facets;  ///< largest sampled error of each facet
};

/// Mesh with its measured errors.
struct MeshApproximation {
  TriangleMesh mesh;  ///< has the surface's normals, split at creases, if reported
  /// One per triangle: the part of the surface that it approximates; vertices as in the mesh.
  std::vector<ParameterFacet> parts;
  CriterionErrors distance;      ///< surface to facets and borders; measured as `MeshReport` says
  CriterionErrors normal_angle;  ///< measured likewise
  CriterionErrors fold_angle;    ///< folds between neighbours, except creases of the surface; in every report
  CriterionErrors luminance;     ///< measured if required
  double longest_edge = 0, smallest_angle = 0;
  std::size_t unreached = 0;      ///< facets above a tolerance that could not be refined further
  std::vector<Message> warnings;  ///< W_MESH_UNREACHED, W_MESH_LIMIT

  /// True when all tolerances are kept, as far as measured.
  bool reached() const { return warnings.empty(); }
};

/// Triangle mesh of a surface that satisfies the criteria, without cracks: sides joined by seams share their
/// vertices. Closed surfaces give closed meshes. The same input gives the same mesh on any number of threads.
/// Errors: those of `check_criteria`, E_MESH_NOTHING for a surface without patches, E_MESH_SURFACE,
/// E_CANCELLED.
Result<MeshApproximation> approximate(const Surface& surface, const MeshOptions& options,
                                      const CancelToken& cancel = {}, const Progress& progress = {});

}  // namespace hariko

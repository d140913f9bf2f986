#pragma once

// Triangle meshes of surfaces under tolerances (Yamamoto and Saitoh, with corrections).

#include <vector>

#include "core/approximation/mesh_options.hpp"
#include "core/approximation/parameter_mesh.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

/// Errors of a mesh by one criterion. Lengths, radians or differences of brightness.
struct CriterionErrors {
  bool measured = false;  ///< else all below is empty
  double largest = 0, mean = 0;
  Index facet = no_index;  ///< that has the largest
  /// Certain: no point has a larger error. Only where `certified`; else the largest is what samples showed.
  double bound = 0;
  bool certified = false;
  std::vector<float> facets;  ///< of each facet, from samples
};

/// A mesh and what is known about it.
struct MeshApproximation {
  TriangleMesh mesh;                  ///< with the surface's normals, split at creases, if reported
  std::vector<ParameterFacet> parts;  ///< one a triangle: what it stands for; vertices as in the mesh
  CriterionErrors distance;           ///< surface to facets and borders; measured as `MeshReport` says
  CriterionErrors normal_angle;       ///< likewise
  CriterionErrors fold_angle;         ///< real folds between neighbours, creases apart; in every report
  CriterionErrors luminance;          ///< where asked for
  double longest_edge = 0, smallest_angle = 0;
  std::size_t unreached = 0;      ///< facets above a tolerance that could not be refined further
  std::vector<Message> warnings;  ///< W_MESH_UNREACHED, W_MESH_LIMIT

  /// All tolerances are kept, as far as measured.
  bool reached() const { return warnings.empty(); }
};

/// A mesh of the surface that satisfies the criteria, without cracks: sides that seams join share their
/// vertices. Closed surfaces give closed meshes. The same input gives the same mesh on any number of threads.
/// Errors: those of `check_criteria`, E_MESH_NOTHING for a surface without patches, E_MESH_SURFACE,
/// E_CANCELLED.
Result<MeshApproximation> approximate(const Surface& surface, const MeshOptions& options,
                                      const CancelToken& cancel = {}, const Progress& progress = {});

}  // namespace hariko

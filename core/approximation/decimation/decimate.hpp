#pragma once

// Decimation of arbitrary triangle meshes under tolerances.

#include "core/approximation/approximate.hpp"

namespace hariko {

/// Decimates a dense mesh by half-edge collapses, cheapest first by quadric error (the sum of squared
/// distances to the planes of the original facets; Garland and Heckbert), as long as all criteria hold:
/// distances between the dense mesh and the result, in both directions, tested at the dense mesh's corners
/// and centroids during the work and certain in the end (`bounded_distance`), for which the tolerance is
/// lowered until they are; angles between the normals of the dense facets and those of the facets that
/// replace them; folds, luminance (flat, whatever the shading), edges and angles. Border edges and sharp
/// edges (folds above `sharp_angle`) remain chains: their vertices move along them only; ends, branchings and
/// non-manifold places stay. Vertices of the result are vertices of the dense mesh. `mesh.normals` are not
/// used, and the result has none; `split`, `propagation`, `optimise` and `balanced` have no effect. `parts`
/// are empty. The same result on any number of threads. O(n log n) collapses. Errors: those of
/// `check_criteria`, E_MESH_NOTHING, E_MESH_SURFACE, E_CANCELLED.
Result<MeshApproximation> decimate(const TriangleMesh& dense, const MeshOptions& options,
                                   const CancelToken& cancel = {}, const Progress& progress = {});

inline constexpr double sharp_angle = 0.5236;  // 30 degrees

}  // namespace hariko

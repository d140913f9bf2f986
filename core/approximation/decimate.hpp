#pragma once

// Arbitrary triangle meshes under tolerances: fewer facets in place of a dense mesh.

#include "core/approximation/approximate.hpp"

namespace hariko {

/// Half-edge collapses of the dense mesh, cheapest first by the sum of squared distances to the planes of
/// what was there (Garland and Heckbert), as long as all criteria hold: distances between the dense mesh and
/// the result, both ways, looked at in the dense mesh's corners and middles during the work and certain in
/// the end (`bounded_distance`), where the tolerance is narrowed until they are; angles between the dense
/// facets' normals and those of the facets that stand for them; folds, luminance (flat, whatever the
/// shading), edges and angles. Border edges and sharp edges (folds above `sharp_angle`) stay chains of their
/// own: their vertices move along them only; ends, branchings and what is not manifold stay. Vertices of the
/// result are vertices of the dense mesh. `mesh.normals` are not used, and the result has none; `split`,
/// `propagation`, `optimise` and `balanced` have no effect. `parts` are empty. The same on any number of
/// threads. O(n log n) collapses. Errors: those of `check_criteria`, E_MESH_NOTHING, E_MESH_SURFACE,
/// E_CANCELLED.
Result<MeshApproximation> decimate(const TriangleMesh& dense, const MeshOptions& options,
                                   const CancelToken& cancel = {}, const Progress& progress = {});

inline constexpr double sharp_angle = 0.5236;  // 30 degrees

}  // namespace hariko

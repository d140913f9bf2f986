#pragma once

// Fold angles between neighbouring facets, present ones and those that a split would make.

#include "core/approximation/refinement/parameter_mesh.hpp"
#include "core/approximation/refinement/split_rule.hpp"
#include "core/approximation/surface_sampler.hpp"

namespace hariko {

/// Angle between the surface's own normals across a side, radians, above which the side is a crease and not
/// an error.
inline constexpr double crease_angle = 0.0873;  // 5 degrees

/// Whether the surface has a kink of more than `angle` (radians) along the edge, measured at its midpoint.
bool is_crease(const SurfaceSampler& sampler, const ParameterMesh& mesh, Index half_edge, double angle);

/// Angle between the normals of the facets on both sides, radians; 0 at borders and where a facet has no
/// area.
double edge_fold(const ParameterMesh& mesh, Index half_edge);

/// Largest fold at the facet's sides, except creases; radians.
double facet_fold(const SurfaceSampler& sampler, const ParameterMesh& mesh, Index facet, double crease);

/// Virtual fold, the paper's criterion (section 4.1): the folds of the four facets that cutting `half_edge`
/// at `position` would make of the facets on both sides of it (of the two halves, at a border); radians.
double virtual_fold(const ParameterMesh& mesh, Index half_edge, const Vector3& position);

}  // namespace hariko

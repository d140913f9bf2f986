#pragma once

// Angles between neighbouring facets, those there are and those that a split would make.

#include "core/approximation/parameter_mesh.hpp"
#include "core/approximation/split_rule.hpp"
#include "core/approximation/surface_sampler.hpp"

namespace hariko {

/// Neighbours across a side where the surface's own normals differ by more than this are a crease: no error.
inline constexpr double crease_angle = 0.0873;  // 5 degrees

/// True where the surface has a kink of more than `angle` along the edge, measured in its middle.
bool is_crease(const SurfaceSampler& sampler, const ParameterMesh& mesh, Index half_edge, double angle);

/// Angle between the normals of the facets on both sides; 0 at borders and where a facet has no area.
double edge_fold(const ParameterMesh& mesh, Index half_edge);

/// Largest real fold at the facet's sides, creases apart; radians.
double facet_fold(const SurfaceSampler& sampler, const ParameterMesh& mesh, Index facet, double crease);

/// The paper's criterion (section 4.1): the folds of the four facets that cutting `half_edge` at `position`
/// would make of the facets on both sides of it (of the two halves, at a border).
double virtual_fold(const ParameterMesh& mesh, Index half_edge, const Vector3& position);

}  // namespace hariko

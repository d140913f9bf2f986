#pragma once

// Split rule: the edge of a facet that is split first, and where.

#include "core/approximation/mesh_options.hpp"
#include "core/approximation/refinement/parameter_mesh.hpp"
#include "core/approximation/surface_sampler.hpp"

namespace hariko {

/// Split of an edge. Priority and place are functions of the edge alone, so that the facets on both sides
/// agree. `priority` is rounded to about twelve digits, so that edges equal up to rounding count as equal; -1
/// for an edge between equal vertices, which is never split. `parameter` is in the canonical direction.
struct EdgeSplit {
  double priority = -1, parameter = 0.5;
};

/// Split of an edge by a rule.
EdgeSplit edge_split(const SurfaceSampler& sampler, const ParameterMesh& mesh, Index half_edge,
                     SplitRule rule);

}  // namespace hariko

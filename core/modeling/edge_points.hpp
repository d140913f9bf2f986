#pragma once

// New vertices on edges.

#include <span>
#include <vector>

#include "core/modeling/mesh_draft.hpp"

namespace hariko {

/// Puts vertices into the source's edge between `a` and `b`, at these shares of its length from `a`
/// (ascending, within 0 .. 1). They get the tension in between that of the ends; the pieces keep the edge's
/// tension and crease.
std::vector<VertexId> add_edge_points(MeshDraft& draft, VertexId a, VertexId b,
                                      std::span<const double> shares);

/// 1 / (count + 1), 2 / (count + 1), ...
std::vector<double> even_shares(int count);

}  // namespace hariko

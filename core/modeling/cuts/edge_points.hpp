#pragma once

// New vertices on edges.

#include <span>
#include <vector>

#include "core/modeling/mesh_editor.hpp"

namespace hariko {

/// Puts new vertices into the source's edge between `a` and `b`, at these fractions of its length from `a`
/// (ascending, within 0 .. 1), and returns their ids in that order. They get tensions interpolated between
/// those of the ends; the pieces keep the edge's tension and crease.
std::vector<VertexId> add_edge_points(MeshEditor& draft, VertexId a, VertexId b,
                                      std::span<const double> shares);

/// Evenly spaced fractions 1 / (count + 1), 2 / (count + 1), ..., count / (count + 1).
std::vector<double> even_shares(int count);

}  // namespace hariko

#pragma once

// Soft selection: vertices near the selected ones follow a transformation in part.

#include <span>
#include <vector>

#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Decrease of the weight with the distance.
enum class Falloff { smooth, linear, sharp };

/// Weight of a vertex at a distance of x radii: 1 at 0, 0 from 1 on, falling in between.
double falloff(Falloff kind, double x);

/// Distance of each vertex from the nearest of the given ones (dense indices), 0 for these; infinity when
/// none is given. O(vertices * given).
std::vector<double> distances_from(const Polyhedron& polyhedron, std::span<const Index> given);

}  // namespace hariko

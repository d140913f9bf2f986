#pragma once

// Where on the path a point of a skin's surface is.

#include <optional>
#include <vector>

#include "core/skinning/evaluate_skin.hpp"

namespace hariko {

/// Of each vertex of the control mesh, 0 .. 1, on the strip across the seam of a closed path up to 2; NaN for
/// vertices of caps. O(vertices).
std::vector<double> vertex_places(const Skin& skin, const SkinMesh& mesh);

/// Of a point of the surface, 0 .. 1: linear in the parameters of its face. `places`: those of the vertices;
/// `closed`: the path is. Nothing on a cap.
std::optional<double> place_on_path(const SubdivisionTopology& topology, const std::vector<double>& places,
                                    bool closed, Index patch, const Vector2& parameter);

}  // namespace hariko

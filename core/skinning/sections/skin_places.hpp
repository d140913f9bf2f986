#pragma once

// Path parameters of points of a skin's surface.

#include <optional>
#include <vector>

#include "core/skinning/evaluate_skin.hpp"

namespace hariko {

/// Path parameter of each vertex of the control mesh, 0 .. 1, on the strip across the seam of a closed path
/// up to 2; NaN for vertices of caps. O(vertices).
std::vector<double> vertex_places(const Skin& skin, const SkinMesh& mesh);

/// Path parameter of a point of the surface, 0 .. 1, interpolated linearly in the parameters of its face.
/// `places`: parameters of the vertices; `closed`: the path is closed. Nothing on a cap.
std::optional<double> place_on_path(const SubdivisionTopology& topology, const std::vector<double>& places,
                                    bool closed, Index patch, const Vector2& parameter);

}  // namespace hariko

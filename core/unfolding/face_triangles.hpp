#pragma once

// Triangulation of one face of a mesh, for unfolding.

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Triangulates a face over its corners (indices into `corners`) into corners - 2 triangles, the roundest
/// ears first, none degenerate. Nothing where the face intersects itself in its mean plane, or has no area.
/// Corners inside a side are allowed. O(corners^2) for most faces.
std::vector<std::array<Index, 3>> face_triangles(std::span<const Vector3> corners);

/// Height of a triangle over its longest side, relative to that side; 0 where it is degenerate.
double flatness(const Vector3& a, const Vector3& b, const Vector3& c);

}  // namespace hariko

#pragma once

// One face of a mesh as triangles that can be laid flat.

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Triangles over the face's corners (numbers into `corners`), the roundest ears first, none of them without
/// area: corners - 2 of them. Nothing where the face crosses itself in its mean plane, or has no area.
/// Corners within a side are fine. O(corners^2) for most.
std::vector<std::array<Index, 3>> face_triangles(std::span<const Vector3> corners);

/// Height of a triangle over its longest side, against that side; 0 where it has none.
double flatness(const Vector3& a, const Vector3& b, const Vector3& c);

}  // namespace hariko

#pragma once

// Triangles over flat faces, made the same on both sides of a plane of symmetry.

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// The hull of symmetric points is symmetric but for how it cuts flat faces with more than three corners.
/// Where such a face and its image are cut differently, the image gets the cuts of the one with the lower
/// corners. What is its own image stays as it is. `image`: of each vertex. O(n log n).
void mirror_triangles(std::vector<std::array<Index, 3>>& triangles, std::span<const Index> image);

}  // namespace hariko

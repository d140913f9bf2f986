#pragma once

// Detection of all overlaps among convex polygons on sheets.

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/vector.hpp"
#include "core/unfolding/cuts/facet_layout.hpp"

namespace hariko {

/// Convex polygon with three or four corners, counter-clockwise, on one of the sheets.
struct SheetPolygon {
  std::array<Vector2, 4> corners;
  std::uint8_t size = 3;
  Index sheet = 0;

  SheetPolygon(const FacetCorners& triangle, Index on)
      : corners{triangle[0], triangle[1], triangle[2], triangle[2]}, sheet(on) {}
  SheetPolygon(const std::array<Vector2, 4>& quad, Index on) : corners(quad), size(4), sheet(on) {}
  std::span<const Vector2> span() const { return {corners.data(), size}; }
};

/// Pairs (first < second) of polygons on the same sheet that overlap by more than `tolerance` (`overlaps`),
/// ascending. Sweep along x: O(n log n + pairs whose x ranges meet).
std::vector<std::pair<Index, Index>> overlapping_pairs(std::span<const SheetPolygon> polygons,
                                                       double tolerance);

}  // namespace hariko

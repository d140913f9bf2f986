#include "core/unfolding/pages/sheet_overlaps.hpp"

#include <algorithm>
#include <tuple>

#include "core/base/index_list.hpp"
#include "core/unfolding/cuts/convex_overlap.hpp"

namespace hariko {

namespace {

struct PolygonBox {
  Vector2 low, high;
  explicit PolygonBox(const SheetPolygon& polygon) : low(polygon.corners[0]), high(polygon.corners[0]) {
    for (const Vector2& corner : polygon.span()) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
};

}  // namespace

std::vector<std::pair<Index, Index>> overlapping_pairs(std::span<const SheetPolygon> polygons,
                                                       double tolerance) {
  std::vector<PolygonBox> boxes;
  boxes.reserve(polygons.size());
  for (const SheetPolygon& polygon : polygons) boxes.emplace_back(polygon);
  std::vector<Index> order = ascending_indices(polygons.size());
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::tuple(polygons[a].sheet, boxes[a].low.x(), a) <
           std::tuple(polygons[b].sheet, boxes[b].low.x(), b);
  });
  std::vector<std::pair<Index, Index>> out;
  std::vector<Index> active;
  for (const Index i : order) {
    std::erase_if(active, [&](Index j) {
      return polygons[j].sheet != polygons[i].sheet || boxes[j].high.x() <= boxes[i].low.x();
    });
    for (const Index j : active)
      if (boxes[j].high.y() > boxes[i].low.y() && boxes[i].high.y() > boxes[j].low.y() &&
          overlaps(polygons[i].span(), polygons[j].span(), tolerance))
        out.emplace_back(std::minmax(i, j));
    active.push_back(i);
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace hariko

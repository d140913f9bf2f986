#include "core/polyhedron/part_nesting.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/index_list.hpp"

namespace hariko {

PartNesting::PartNesting(std::span<const Vector3> positions, std::vector<Triangles> parts)
    : positions_(positions), parts_(std::move(parts)), boxes_(parts_.size()), rank_(parts_.size()) {
  trees_.resize(parts_.size());
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for (const auto& triangle : parts_[p])
      for (const Index v : triangle) boxes_[p].extend(positions_[v]);
  std::vector<Index> by_size = ascending_indices(parts_.size());
  std::stable_sort(by_size.begin(), by_size.end(), [&](Index a, Index b) {
    return boxes_[a].sizes().squaredNorm() > boxes_[b].sizes().squaredNorm();
  });
  for (Index k = 0; k < by_size.size(); ++k) rank_[by_size[k]] = k;
  std::vector<Eigen::AlignedBox3d> held_boxes;
  std::vector<Vector3> middles;
  for (Index p = 0; p < parts_.size(); ++p) {
    if (parts_[p].empty()) continue;
    held_.push_back(p);
    held_boxes.push_back(boxes_[p]);
    middles.push_back(boxes_[p].center());
  }
  tree_of_boxes_ = BoxTree(held_boxes, middles, 4);
}

std::vector<Index> PartNesting::around(Index part) {
  std::vector<Index> out;
  if (parts_[part].empty()) return out;
  const auto& [a, b, c] = parts_[part][0];
  const Vector3 point = (positions_[a] + positions_[b] + positions_[c]) / 3;
  const auto outside = [&](const Eigen::AlignedBox3d& box) { return box.contains(boxes_[part]) ? 0.0 : 1.0; };
  tree_of_boxes_.visit_near(
      outside, [](double away) { return away < 0.5; },
      [&](Index k) {
        const Index outer = held_[k];
        if (outer != part && boxes_[outer].contains(boxes_[part]) && encloses(outer, point))
          out.push_back(outer);
      });
  std::sort(out.begin(), out.end(), [&](Index first, Index second) { return rank_[first] < rank_[second]; });
  return out;
}

bool PartNesting::encloses(Index outer, const Vector3& point) {
  if (!trees_[outer]) trees_[outer] = std::make_unique<WindingTree>(positions_, parts_[outer]);
  return std::abs(trees_[outer]->winding(point)) > 0.5;
}

}  // namespace hariko

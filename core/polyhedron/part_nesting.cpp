#include "core/polyhedron/part_nesting.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hariko {

PartNesting::PartNesting(std::span<const Vector3> positions, std::vector<Triangles> parts)
    : positions_(positions), parts_(std::move(parts)), boxes_(parts_.size()), by_size_(parts_.size()) {
  trees_.resize(parts_.size());
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for (const auto& triangle : parts_[p])
      for (const Index v : triangle) boxes_[p].extend(positions_[v]);
  std::iota(by_size_.begin(), by_size_.end(), Index{0});
  std::stable_sort(by_size_.begin(), by_size_.end(), [&](Index a, Index b) {
    return boxes_[a].sizes().squaredNorm() > boxes_[b].sizes().squaredNorm();
  });
}

std::vector<Index> PartNesting::around(Index part) {
  std::vector<Index> out;
  if (parts_[part].empty()) return out;
  const auto& [a, b, c] = parts_[part][0];
  const Vector3 point = (positions_[a] + positions_[b] + positions_[c]) / 3;
  for (const Index outer : by_size_) {
    if (outer == part || parts_[outer].empty() || !boxes_[outer].contains(boxes_[part])) continue;
    if (encloses(outer, point)) out.push_back(outer);
  }
  return out;
}

bool PartNesting::encloses(Index outer, const Vector3& point) {
  if (!trees_[outer]) trees_[outer] = std::make_unique<WindingTree>(positions_, parts_[outer]);
  return std::abs(trees_[outer]->winding(point)) > 0.5;
}

}  // namespace hariko

#include "core/geometry/box_tree.hpp"

#include <algorithm>

#include "core/base/index_list.hpp"

namespace hariko {

BoxTree::BoxTree(std::span<const Eigen::AlignedBox3d> boxes, std::span<const Vector3> middles,
                 Index leaf_size)
    : order_(ascending_indices(boxes.size())) {
  HARIKO_ASSERT(boxes.size() == middles.size() && leaf_size > 0, "one middle a box");
  if (order_.empty()) return;
  nodes_.reserve(4 * order_.size() / leaf_size + 1);
  build(0, Index(order_.size()), boxes, middles, leaf_size);
}

Index BoxTree::build(Index begin, Index end, std::span<const Eigen::AlignedBox3d> boxes,
                     std::span<const Vector3> middles, Index leaf_size) {
  const Index own = Index(nodes_.size());
  Node& node = nodes_.emplace_back();
  node.begin = begin;
  node.end = end;
  Eigen::AlignedBox3d centres;
  for (Index k = begin; k < end; ++k) {
    node.box.extend(boxes[order_[k]]);
    centres.extend(middles[order_[k]]);
  }
  if (end - begin <= leaf_size) return own;
  int axis = 0;
  centres.sizes().maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(
      order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](Index a, Index b) {
        return middles[a][axis] < middles[b][axis] || (middles[a][axis] == middles[b][axis] && a < b);
      });
  build(begin, middle, boxes, middles, leaf_size);
  const Index right = build(middle, end, boxes, middles, leaf_size);
  nodes_[own].right = right;
  return own;
}

BoxTree box_tree_of(std::span<const Vector3> positions, std::span<const std::array<Index, 3>> triangles,
                    Index leaf_size) {
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<Vector3> middles;
  boxes.reserve(triangles.size());
  middles.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    Eigen::AlignedBox3d box(positions[a]);
    box.extend(positions[b]);
    box.extend(positions[c]);
    boxes.push_back(box);
    middles.push_back((positions[a] + positions[b] + positions[c]) / 3);
  }
  return BoxTree(boxes, middles, leaf_size);
}

}  // namespace hariko

#pragma once

// BoxTree: a bounding volume hierarchy, a binary tree of axis-aligned boxes over items with boxes of their
// own.

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "core/base/assert.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Bounding volume hierarchy by median splits across the widest extent of the items' midpoints. Parents come
/// before their children, and the left child right behind its parent, so a sum over subtrees visits the nodes
/// backwards. The same result for the same input.
class BoxTree {
 public:
  struct Node {
    Eigen::AlignedBox3d box;
    Index begin = 0, end = 0;  ///< range of its items in `order`
    Index right = no_index;    ///< no_index for a leaf
    bool is_leaf() const { return right == no_index; }
  };

  BoxTree() = default;
  /// Builds the tree with at most `leaf_size` items per leaf. O(n log n).
  BoxTree(std::span<const Eigen::AlignedBox3d> boxes, std::span<const Vector3> middles, Index leaf_size);

  const std::vector<Node>& nodes() const { return nodes_; }
  /// Items in the order of the leaves; the items of a node are consecutive.
  const std::vector<Index>& order() const { return order_; }
  Index left(Index node) const { return node + 1; }

  /// Traversal that calls visit(item) for all items of nearby leaves: keep(distance(box)) is evaluated for a
  /// node's box only when its turn comes, so it may become stricter on the way. The nearer child goes first.
  template <class Distance, class Keep, class Visit>
  void visit_near(const Distance& distance, const Keep& keep, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::array<std::pair<Index, double>, deepest> stack;
    std::size_t size = 0;
    stack[size++] = {0, distance(nodes_[0].box)};
    while (size > 0) {
      const auto [at, away] = stack[--size];
      if (!keep(away)) continue;
      const Node& node = nodes_[at];
      if (node.is_leaf()) {
        for (Index k = node.begin; k < node.end; ++k) visit(order_[k]);
        continue;
      }
      const Index left = at + 1, right = node.right;
      const double to_left = distance(nodes_[left].box), to_right = distance(nodes_[right].box);
      const bool left_first = to_left <= to_right;
      stack[size++] = left_first ? std::pair{right, to_right} : std::pair{left, to_left};
      stack[size++] = left_first ? std::pair{left, to_left} : std::pair{right, to_right};
    }
  }

 private:
  /// Depth limit: median splits make no more levels than an index has bits.
  static constexpr std::size_t deepest = 64;
  Index build(Index begin, Index end, std::span<const Eigen::AlignedBox3d> boxes,
              std::span<const Vector3> middles, Index leaf_size);

  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

/// Tree over triangles, split by their centroids.
BoxTree box_tree_of(std::span<const Vector3> positions, std::span<const std::array<Index, 3>> triangles,
                    Index leaf_size);

}  // namespace hariko

#pragma once

// Samples of a surface's patches in a tree of boxes: the nearest one to a point, and those near a solid.

#include <span>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/vector.hpp"

namespace hariko {

class SampleTree {
 public:
  /// `per_patch` consecutive positions a patch; they must outlive the tree. O(n log n).
  SampleTree(std::span<const Vector3> positions, std::size_t per_patch);

  /// Number of the nearest position, the lowest one where several are equally near. O(log n).
  std::size_t nearest(const Vector3& point) const;

  /// Calls use(patch) for the patches that no ball with skip(centre, radius) contains.
  template <class Skip, class Use>
  void visit(const Skip& skip, const Use& use) const {
    if (!nodes_.empty()) visit(0, skip, use);
  }

 private:
  struct Node {
    Vector3 low, high;
    Index begin = 0, end = 0, right = no_index;  ///< leaf: right is none; the left child follows its parent
  };
  struct Best {
    double square = 1e300;
    std::size_t sample = 0;
  };
  Index build(Index begin, Index end, std::span<const Vector3> low, std::span<const Vector3> high);
  void nearest(Index node, const Vector3& point, Best& best) const;
  template <class Skip, class Use>
  void visit(Index at, const Skip& skip, const Use& use) const {
    const Node& node = nodes_[at];
    if (skip(Vector3(0.5 * (node.low + node.high)), 0.5 * (node.high - node.low).norm())) return;
    if (node.right == no_index) {
      for (Index i = node.begin; i < node.end; ++i) use(order_[i]);
      return;
    }
    visit(at + 1, skip, use);
    visit(node.right, skip, use);
  }

  std::span<const Vector3> positions_;
  std::size_t per_patch_;
  std::vector<Index> order_;  ///< patches, leaf by leaf
  std::vector<Node> nodes_;
};

}  // namespace hariko

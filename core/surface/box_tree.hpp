#pragma once

// BoxTree: boxes by where they are, to find those round another one.

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// A tree that halves the boxes by their middles, each time along the longest side of what is left. O(boxes
/// log boxes) to make.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Eigen::AlignedBox3d> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), Index{0});
    if (!boxes_.empty()) make(0, order_.size());
  }

  /// Numbers of the boxes that contain `box`, ascending. Typically O(log boxes + found).
  std::vector<Index> containing(const Eigen::AlignedBox3d& box) const {
    std::vector<Index> out;
    if (!nodes_.empty()) collect(0, box, out);
    std::sort(out.begin(), out.end());
    return out;
  }

 private:
  static constexpr std::size_t leaf_size = 4;
  struct Node {
    Eigen::AlignedBox3d box;          ///< round all of its boxes
    std::size_t begin = 0, end = 0;   ///< of a leaf, in order_; empty otherwise
    std::size_t left = 0, right = 0;  ///< of a node that is no leaf
  };

  std::size_t make(std::size_t begin, std::size_t end) {
    const std::size_t own = nodes_.size();
    nodes_.emplace_back();
    Eigen::AlignedBox3d all;
    for (std::size_t i = begin; i < end; ++i) all.extend(boxes_[order_[i]]);
    nodes_[own].box = all;
    if (end - begin <= leaf_size) {
      nodes_[own].begin = begin;
      nodes_[own].end = end;
      return own;
    }
    Eigen::Index axis = 0;
    all.sizes().maxCoeff(&axis);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](Index a, Index b) {
      const double x = boxes_[a].center()[axis], y = boxes_[b].center()[axis];
      return x != y ? x < y : a < b;
    });
    const std::size_t left = make(begin, middle), right = make(middle, end);
    nodes_[own].left = left;
    nodes_[own].right = right;
    return own;
  }

  void collect(std::size_t at, const Eigen::AlignedBox3d& box, std::vector<Index>& out) const {
    const Node& node = nodes_[at];
    if (!node.box.contains(box)) return;
    for (std::size_t i = node.begin; i < node.end; ++i)
      if (boxes_[order_[i]].contains(box)) out.push_back(order_[i]);
    if (node.right == 0) return;
    collect(node.left, box, out);
    collect(node.right, box, out);
  }

  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

}  // namespace hariko

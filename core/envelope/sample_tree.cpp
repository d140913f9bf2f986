#include "core/envelope/sample_tree.hpp"

#include <algorithm>
#include <numeric>

#include "core/envelope/box_distance.hpp"

namespace hariko {

SampleTree::SampleTree(std::span<const Vector3> positions, std::size_t per_patch)
    : positions_(positions), per_patch_(per_patch), order_(positions.size() / per_patch) {
  std::iota(order_.begin(), order_.end(), Index{0});
  std::vector<Vector3> low, high;
  for (std::size_t p = 0; p < order_.size(); ++p) {
    const auto points = positions.subspan(p * per_patch, per_patch);
    low.push_back(points[0]);
    high.push_back(points[0]);
    for (const Vector3& x : points) low[p] = low[p].cwiseMin(x), high[p] = high[p].cwiseMax(x);
  }
  if (!order_.empty()) build(0, Index(order_.size()), low, high);
}

Index SampleTree::build(Index begin, Index end, std::span<const Vector3> low, std::span<const Vector3> high) {
  const Index at = Index(nodes_.size());
  Node node;
  node.begin = begin;
  node.end = end;
  node.low = low[order_[begin]];
  node.high = high[order_[begin]];
  for (Index i = begin; i < end; ++i) {
    node.low = node.low.cwiseMin(low[order_[i]]);
    node.high = node.high.cwiseMax(high[order_[i]]);
  }
  nodes_.push_back(node);
  if (end - begin == 1) return at;
  Eigen::Index axis;
  (node.high - node.low).maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  const auto key = [&](Index p) { return std::pair(low[p][axis] + high[p][axis], p); };
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](Index a, Index b) { return key(a) < key(b); });
  build(begin, middle, low, high);
  const Index right = build(middle, end, low, high);
  nodes_[at].right = right;
  return at;
}

std::size_t SampleTree::nearest(const Vector3& point) const {
  Best best;
  if (!nodes_.empty()) nearest(0, point, best);
  return best.sample;
}

void SampleTree::nearest(Index at, const Vector3& point, Best& best) const {
  const Node& node = nodes_[at];
  if (node.right == no_index) {
    const std::size_t first = order_[node.begin] * per_patch_;
    for (std::size_t i = first; i < first + per_patch_; ++i) {
      const double square = (positions_[i] - point).squaredNorm();
      if (square < best.square || (square == best.square && i < best.sample)) best = {square, i};
    }
    return;
  }
  const Index left = at + 1, right = node.right;
  const double a = box_square_distance(point, nodes_[left].low, nodes_[left].high),
               b = box_square_distance(point, nodes_[right].low, nodes_[right].high);
  const bool left_first = a <= b;
  if (std::min(a, b) <= best.square) nearest(left_first ? left : right, point, best);
  if (std::max(a, b) <= best.square) nearest(left_first ? right : left, point, best);
}

}  // namespace hariko

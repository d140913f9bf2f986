#include "core/approximation/triangle_tree.hpp"

#include <algorithm>
#include <numeric>

namespace hariko {

namespace {

constexpr Index leaf_size = 4;
/// Halves of halves: more levels than indices have bits do not occur.
constexpr std::size_t deepest_tree = 64;

}  // namespace

TriangleTree::TriangleTree(std::span<const Vector3> positions,
                           std::span<const std::array<Index, 3>> triangles)
    : order_(triangles.size()) {
  closed_.reserve(triangles.size());
  std::vector<Vector3> middles;
  middles.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    closed_.emplace_back(TriangleCorners{positions[a], positions[b], positions[c]});
    middles.push_back((positions[a] + positions[b] + positions[c]) / 3);
  }
  std::iota(order_.begin(), order_.end(), Index{0});
  if (!order_.empty()) build(0, Index(order_.size()), positions, triangles, middles);
}

void TriangleTree::build(Index begin, Index end, std::span<const Vector3> positions,
                         std::span<const std::array<Index, 3>> triangles, std::span<const Vector3> middles) {
  const std::size_t own = nodes_.size();
  nodes_.emplace_back();
  Eigen::AlignedBox3d box, centres;
  for (Index k = begin; k < end; ++k) {
    for (const Index v : triangles[order_[k]]) box.extend(positions[v]);
    centres.extend(middles[order_[k]]);
  }
  nodes_[own].box = box;
  if (end - begin <= leaf_size) {
    nodes_[own].first = begin;
    nodes_[own].count = end - begin;
    return;
  }
  int axis = 0;
  centres.sizes().maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(
      order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](Index a, Index b) {
        return middles[a][axis] < middles[b][axis] || (middles[a][axis] == middles[b][axis] && a < b);
      });
  build(begin, middle, positions, triangles, middles);
  nodes_[own].first = Index(nodes_.size());
  build(middle, end, positions, triangles, middles);
}

TriangleTree::Nearest TriangleTree::nearest(const Vector3& point, double limit) const {
  Nearest best;
  if (nodes_.empty()) return best;
  double square = limit * limit;
  std::array<std::pair<Index, double>, deepest_tree> stack;
  std::size_t size = 0;
  stack[size++] = {0, nodes_[0].box.squaredExteriorDistance(point)};
  while (size > 0) {
    const auto [at, away] = stack[--size];
    if (away > square) continue;
    const Node& node = nodes_[at];
    if (node.count > 0) {
      for (Index k = node.first; k < node.first + node.count; ++k) {
        const Index t = order_[k];
        const double d = closed_[t].squared_distance(point);
        if (d > square || (d == square && best.triangle != no_index && t > best.triangle)) continue;
        square = d;
        best.triangle = t;
      }
      continue;
    }
    const Index left = at + 1, right = node.first;
    const double to_left = nodes_[left].box.squaredExteriorDistance(point),
                 to_right = nodes_[right].box.squaredExteriorDistance(point);
    // The nearer one is looked at first.
    const bool left_first = to_left <= to_right;
    stack[size++] = left_first ? std::pair{right, to_right} : std::pair{left, to_left};
    stack[size++] = left_first ? std::pair{left, to_left} : std::pair{right, to_right};
  }
  if (best.triangle != no_index) best.distance = std::sqrt(square);
  return best;
}

}  // namespace hariko

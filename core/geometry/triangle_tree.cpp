#include "core/geometry/triangle_tree.hpp"

#include <cmath>

namespace hariko {

namespace {

constexpr Index triangles_a_leaf = 4;

}  // namespace

TriangleTree::TriangleTree(std::span<const Vector3> positions,
                           std::span<const std::array<Index, 3>> triangles)
    : tree_(box_tree_of(positions, triangles, triangles_a_leaf)) {
  closed_.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles)
    closed_.emplace_back(TriangleCorners{positions[a], positions[b], positions[c]});
}

TriangleTree::Nearest TriangleTree::nearest(const Vector3& point, double limit) const {
  Nearest best;
  double square = limit * limit;
  tree_.visit_near([&](const Eigen::AlignedBox3d& box) { return box.squaredExteriorDistance(point); },
                   [&](double away) { return !(away > square); },
                   [&](Index t) {
                     const double d = closed_[t].squared_distance(point);
                     if (d > square || (d == square && best.triangle != no_index && t > best.triangle))
                       return;
                     square = d;
                     best.triangle = t;
                   });
  if (best.triangle != no_index) best.distance = std::sqrt(square);
  return best;
}

}  // namespace hariko

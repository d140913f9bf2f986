#include "core/geometry/triangle_tree.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

constexpr Index triangles_a_leaf = 4;
constexpr double infinite = std::numeric_limits<double>::infinity();
/// Enlargement of triangles relative to their size, and of boxes relative to that of all of them.
constexpr double rim = 1e-8;
/// Slope of a ray to a triangle below which it runs along it.
constexpr double grazing = 1e-6;

/// Distance along a ray to where it enters a box that is enlarged by `margin`; infinite where it misses.
double entry(const Vector3& begin, const Vector3& direction, const Eigen::AlignedBox3d& box, double margin) {
  double low = 0, high = infinite;
  for (int i = 0; i < 3; ++i) {
    const double from = box.min()[i] - margin - begin[i], to = box.max()[i] + margin - begin[i];
    if (direction[i] == 0) {
      if (from > 0 || to < 0) return infinite;
      continue;
    }
    const double a = from / direction[i], b = to / direction[i];
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  return low <= high ? low : infinite;
}

}  // namespace

TriangleTree::TriangleTree(std::span<const Vector3> positions,
                           std::span<const std::array<Index, 3>> triangles)
    : tree_(box_tree_of(positions, triangles, triangles_a_leaf)) {
  closed_.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles)
    closed_.emplace_back(TriangleCorners{positions[a], positions[b], positions[c]});
  if (!tree_.nodes().empty()) size_ = tree_.nodes().front().box.diagonal().norm();
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

double TriangleTree::side(const Vector3& point, const Nearest& nearest) const {
  const double limit = nearest.distance * (1 + 1e-9) + 1e-12 * size_, square = limit * limit;
  double height = 0;
  Index decides = no_index;
  tree_.visit_near([&](const Eigen::AlignedBox3d& box) { return box.squaredExteriorDistance(point); },
                   [&](double away) { return !(away > square); },
                   [&](Index t) {
                     if (closed_[t].squared_distance(point) > square) return;
                     const double own = closed_[t].height(point), gain = std::abs(own) - std::abs(height);
                     if (gain < 0 || (gain == 0 && t > decides)) return;
                     height = own;
                     decides = t;
                   });
  return height < 0 ? -1 : 1;
}

double TriangleTree::first_crossing(const Vector3& begin, const Vector3& direction, Crossing crossing,
                                    double least) const {
  const double sign = crossing == Crossing::leaving ? 1 : -1, margin = rim * size_;
  double best = infinite;
  tree_.visit_near([&](const Eigen::AlignedBox3d& box) { return entry(begin, direction, box, margin); },
                   [&](double away) { return away < best; },
                   [&](Index t) {
                     if (!(sign * closed_[t].normal().dot(direction) > grazing)) return;
                     const auto along = closed_[t].meets(begin, direction, rim);
                     if (along && *along >= least && *along < best) best = *along;
                   });
  return best;
}

}  // namespace hariko

#include "core/geometry/winding_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/triangle.hpp"

namespace hariko {

namespace {

constexpr Index winding_leaf_size = 8;
/// Distance, in radii of a node, from which its area vector replaces its triangles.
constexpr double far_factor = 3;

double square_distance_to_box(const Vector3& p, const Eigen::AlignedBox3d& box) {
  return (box.min() - p).cwiseMax(p - box.max()).cwiseMax(Vector3::Zero()).squaredNorm();
}

double solid_angle(const Vector3& a, const Vector3& b, const Vector3& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2 * std::atan2(a.dot(b.cross(c)), denominator);
}

double square_distance(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
  const auto to_segment = [&](const Vector3& x, const Vector3& y) {
    const Vector3 e = y - x;
    const double length = e.squaredNorm();
    const double t = length > 0 ? std::clamp((p - x).dot(e) / length, 0.0, 1.0) : 0;
    return (x + t * e - p).squaredNorm();
  };
  const Vector3 n = (b - a).cross(c - a);
  const double area = n.squaredNorm();
  if (area > 0 && n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 &&
      n.dot((a - c).cross(p - c)) >= 0) {
    const double height = n.dot(p - a);
    return height * height / area;
  }
  return std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)});
}

}  // namespace

WindingTree::WindingTree(std::span<const Vector3> positions, std::span<const std::array<Index, 3>> triangles)
    : positions_(positions),
      triangles_(triangles),
      tree_(box_tree_of(positions, triangles, winding_leaf_size)),
      moments_(tree_.nodes().size()) {
  for (Index at = Index(moments_.size()); at-- > 0;) {
    const BoxTree::Node& node = tree_.nodes()[at];
    Moments& moments = moments_[at];
    moments = node.is_leaf() ? moments_of_leaf(node) : moments_of_both(at);
    moments.radius = (node.box.max() - moments.centre).cwiseMax(moments.centre - node.box.min()).norm();
  }
}

WindingTree::Moments WindingTree::moments_of_leaf(const BoxTree::Node& leaf) const {
  Moments out;
  for (Index k = leaf.begin; k < leaf.end; ++k) {
    const auto& [i, j, l] = triangles_[tree_.order()[k]];
    const Vector3 &a = positions_[i], &b = positions_[j], &c = positions_[l];
    const Vector3 area = 0.5 * area_vector(a, b, c);
    out.area += area;
    out.centre += area.norm() * Vector3((a + b + c) / 3);
    out.total += area.norm();
  }
  out.centre =
      out.total > 0 ? Vector3(out.centre / out.total) : Vector3(0.5 * (leaf.box.min() + leaf.box.max()));
  return out;
}

WindingTree::Moments WindingTree::moments_of_both(Index at) const {
  const BoxTree::Node& node = tree_.nodes()[at];
  const Moments &one = moments_[tree_.left(at)], &other = moments_[node.right];
  Moments out;
  out.area = one.area + other.area;
  out.total = one.total + other.total;
  out.centre = out.total > 0 ? Vector3((one.total * one.centre + other.total * other.centre) / out.total)
                             : Vector3(0.5 * (node.box.min() + node.box.max()));
  return out;
}

double WindingTree::square_distance(Index triangle, const Vector3& point) const {
  const auto& t = triangles_[triangle];
  return hariko::square_distance(point, positions_[t[0]], positions_[t[1]], positions_[t[2]]);
}

double WindingTree::winding(const Vector3& point) const {
  return moments_.empty() ? 0 : winding(0, point) / (4 * std::numbers::pi);
}

double WindingTree::winding(Index at, const Vector3& point) const {
  const Moments& moments = moments_[at];
  const Vector3 offset = moments.centre - point;
  const double distance = offset.norm();
  if (distance > far_factor * moments.radius)
    return moments.area.dot(offset) / (distance * distance * distance);
  const BoxTree::Node& node = tree_.nodes()[at];
  if (!node.is_leaf()) return winding(tree_.left(at), point) + winding(node.right, point);
  double sum = 0;
  for (Index k = node.begin; k < node.end; ++k) {
    const auto& t = triangles_[tree_.order()[k]];
    sum += solid_angle(positions_[t[0]] - point, positions_[t[1]] - point, positions_[t[2]] - point);
  }
  return sum;
}

WindingTree::Nearest WindingTree::nearest(const Vector3& point) const {
  Nearest best;  // holds the squared distance
  tree_.visit_near([&](const Eigen::AlignedBox3d& box) { return square_distance_to_box(point, box); },
                   [&](double away) { return away < best.distance; },
                   [&](Index t) {
                     if (const double square = square_distance(t, point); square < best.distance)
                       best = {square, t};
                   });
  best.distance = std::sqrt(best.distance);
  return best;
}

bool WindingTree::is_clear(const Vector3& point, double radius) const {
  const double square = radius * radius;
  bool clear = true;
  tree_.visit_near([&](const Eigen::AlignedBox3d& box) { return square_distance_to_box(point, box); },
                   [&](double away) { return clear && away < square; },
                   [&](Index t) { clear = clear && !(square_distance(t, point) < square); });
  return clear;
}

}  // namespace hariko

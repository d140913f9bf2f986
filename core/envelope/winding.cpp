#include "core/envelope/winding.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/envelope/box_distance.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

namespace {

constexpr Index leaf_size = 8;
constexpr double far_factor = 3;  ///< radii away, the area vector stands for the triangles

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

WindingTree::WindingTree(const TriangleMesh& mesh) : mesh_(&mesh) {
  items_.reserve(mesh.triangles.size());
  for (Index i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    items_.push_back({(mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3, i});
  }
  nodes_.reserve(4 * items_.size() / leaf_size + 1);
  if (!items_.empty()) build(0, Index(items_.size()));
}

WindingTree::Node WindingTree::leaf(Index begin, Index end) const {
  Node node;
  node.low = Vector3::Constant(1e300);
  node.high = -node.low;
  node.centre = node.area = Vector3::Zero();
  for (Index i = begin; i < end; ++i) {
    const auto& t = mesh_->triangles[items_[i].triangle];
    for (const Index v : t) {
      node.low = node.low.cwiseMin(mesh_->positions[v]);
      node.high = node.high.cwiseMax(mesh_->positions[v]);
    }
    const Vector3& a = mesh_->positions[t[0]];
    const Vector3 area = 0.5 * area_vector(a, mesh_->positions[t[1]], mesh_->positions[t[2]]);
    node.area += area;
    node.centre += area.norm() * items_[i].middle;
    node.total += area.norm();
  }
  node.centre = node.total > 0 ? Vector3(node.centre / node.total) : Vector3(0.5 * (node.low + node.high));
  return node;
}

Index WindingTree::build(Index begin, Index end) {
  const Index at = Index(nodes_.size());
  nodes_.emplace_back();
  Node node;
  if (end - begin <= leaf_size) {
    node = leaf(begin, end);
  } else {
    Vector3 low = items_[begin].middle, high = low;
    for (Index i = begin; i < end; ++i) {
      low = low.cwiseMin(items_[i].middle);
      high = high.cwiseMax(items_[i].middle);
    }
    Eigen::Index axis;
    (high - low).maxCoeff(&axis);
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [&](const Item& a, const Item& b) {
                       return std::pair(a.middle[axis], a.triangle) < std::pair(b.middle[axis], b.triangle);
                     });
    build(begin, middle);
    node.right = build(middle, end);
    const Node &one = nodes_[at + 1], &other = nodes_[node.right];
    node.low = one.low.cwiseMin(other.low);
    node.high = one.high.cwiseMax(other.high);
    node.area = one.area + other.area;
    node.total = one.total + other.total;
    node.centre = node.total > 0 ? Vector3((one.total * one.centre + other.total * other.centre) / node.total)
                                 : Vector3(0.5 * (node.low + node.high));
  }
  node.begin = begin;
  node.end = end;
  node.radius = (node.high - node.centre).cwiseMax(node.centre - node.low).norm();
  nodes_[at] = node;
  return at;
}

double WindingTree::square_distance(const Item& item, const Vector3& point) const {
  const auto& t = mesh_->triangles[item.triangle];
  return hariko::square_distance(point, mesh_->positions[t[0]], mesh_->positions[t[1]],
                                 mesh_->positions[t[2]]);
}

double WindingTree::winding(const Vector3& point) const {
  return nodes_.empty() ? 0 : winding(0, point) / (4 * std::numbers::pi);
}

double WindingTree::winding(Index at, const Vector3& point) const {
  const Node& node = nodes_[at];
  const Vector3 offset = node.centre - point;
  const double distance = offset.norm();
  if (distance > far_factor * node.radius) return node.area.dot(offset) / (distance * distance * distance);
  if (node.right != no_index) return winding(at + 1, point) + winding(node.right, point);
  double sum = 0;
  for (Index i = node.begin; i < node.end; ++i) {
    const auto& t = mesh_->triangles[items_[i].triangle];
    sum += solid_angle(mesh_->positions[t[0]] - point, mesh_->positions[t[1]] - point,
                       mesh_->positions[t[2]] - point);
  }
  return sum;
}

WindingTree::Nearest WindingTree::nearest(const Vector3& point) const {
  Nearest best;
  if (!nodes_.empty()) nearest(0, point, best);
  best.distance = std::sqrt(best.distance);
  return best;
}

void WindingTree::nearest(Index at, const Vector3& point, Nearest& best) const {
  const Node& node = nodes_[at];
  if (box_square_distance(point, node.low, node.high) >= best.distance) return;
  if (node.right == no_index) {
    for (Index i = node.begin; i < node.end; ++i)
      if (const double square = square_distance(items_[i], point); square < best.distance)
        best = {square, items_[i].triangle};
    return;
  }
  const Node &left = nodes_[at + 1], &right = nodes_[node.right];
  const bool left_first =
      box_square_distance(point, left.low, left.high) <= box_square_distance(point, right.low, right.high);
  nearest(left_first ? at + 1 : node.right, point, best);
  nearest(left_first ? node.right : at + 1, point, best);
}

bool WindingTree::is_clear(const Vector3& point, double radius) const {
  return nodes_.empty() || is_clear_by_square(0, point, radius * radius);
}

bool WindingTree::is_clear_by_square(Index at, const Vector3& point, double square) const {
  const Node& node = nodes_[at];
  if (box_square_distance(point, node.low, node.high) >= square) return true;
  if (node.right != no_index)
    return is_clear_by_square(at + 1, point, square) && is_clear_by_square(node.right, point, square);
  for (Index i = node.begin; i < node.end; ++i)
    if (square_distance(items_[i], point) < square) return false;
  return true;
}

}  // namespace hariko

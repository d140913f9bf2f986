#include "core/envelope/winding.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/envelope/box_distance.hpp"

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

WindingTree::WindingTree(const TriangleMesh& mesh) : mesh_(&mesh), order_(mesh.triangles.size()) {
  for (Index i = 0; i < order_.size(); ++i) {
    const auto& t = mesh.triangles[i];
    order_[i] = i;
    middle_.push_back((mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3);
  }
  if (!order_.empty()) build(0, Index(order_.size()));
}

Index WindingTree::build(Index begin, Index end) {
  const Index at = Index(nodes_.size());
  nodes_.emplace_back();
  Node node;
  node.begin = begin;
  node.end = end;
  node.low = Vector3::Constant(1e300);
  node.high = -node.low;
  node.centre = node.area = Vector3::Zero();
  double total = 0;
  for (Index i = begin; i < end; ++i) {
    const auto& t = mesh_->triangles[order_[i]];
    for (const Index v : t) {
      node.low = node.low.cwiseMin(mesh_->positions[v]);
      node.high = node.high.cwiseMax(mesh_->positions[v]);
    }
    const Vector3& a = mesh_->positions[t[0]];
    const Vector3 area = 0.5 * (mesh_->positions[t[1]] - a).cross(mesh_->positions[t[2]] - a);
    node.area += area;
    node.centre += area.norm() * middle_[order_[i]];
    total += area.norm();
  }
  node.centre = total > 0 ? Vector3(node.centre / total) : Vector3(0.5 * (node.low + node.high));
  node.radius = (node.high - node.centre).cwiseMax(node.centre - node.low).norm();
  if (end - begin > leaf_size) {
    Eigen::Index axis;
    (node.high - node.low).maxCoeff(&axis);
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(
        order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
        [&](Index a, Index b) { return std::pair(middle_[a][axis], a) < std::pair(middle_[b][axis], b); });
    build(begin, middle);
    node.right = build(middle, end);
  }
  nodes_[at] = node;
  return at;
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
    const auto& t = mesh_->triangles[order_[i]];
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
    for (Index i = node.begin; i < node.end; ++i) {
      const auto& t = mesh_->triangles[order_[i]];
      const double square =
          square_distance(point, mesh_->positions[t[0]], mesh_->positions[t[1]], mesh_->positions[t[2]]);
      if (square < best.distance) best = {square, order_[i]};
    }
    return;
  }
  const Node &left = nodes_[at + 1], &right = nodes_[node.right];
  const bool left_first =
      box_square_distance(point, left.low, left.high) <= box_square_distance(point, right.low, right.high);
  nearest(left_first ? at + 1 : node.right, point, best);
  nearest(left_first ? node.right : at + 1, point, best);
}

}  // namespace hariko

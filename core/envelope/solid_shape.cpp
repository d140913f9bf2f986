#include "core/envelope/solid_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/equal_bits.hpp"
#include "core/base/index_list.hpp"
#include "core/envelope/ellipsoid_distance.hpp"
#include "core/geometry/edge_key.hpp"
#include "core/geometry/rotation.hpp"
#include "core/geometry/tolerant_hull.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

namespace {

/// Largest distance of a hull's vertices from its faces relative to its size.
constexpr double hull_tolerance = 1e-9;

/// Position relative to an outside point: `nearest` is the solid's nearest point, `normal` the direction used
/// at distance 0.
SolidPlace place_outside(const Vector3& point, const Vector3& nearest, const Vector3& normal) {
  const Vector3 away = point - nearest;
  const double distance = away.norm();
  return {distance, distance > 0 ? Vector3(away / distance) : normal, nearest, 0};
}
SolidPlace place_inside(const Vector3& point, double distance, const Vector3& normal) {
  return {distance, normal, point, -distance};
}

/// Angle at which a function of period 2 pi with few minima is least. Inside solids minima may be kinks,
/// whose angle counts to the last digit; about smooth ones the function is flat, and the search ends sooner.
template <class Function>
double least_angle(const Function& value) {
  constexpr int samples = 32;
  constexpr double spacing = 2 * std::numbers::pi / samples;
  constexpr double rounding = 4e-16;  ///< relative
  constexpr int most_rounds = 74;     ///< an interval of rounding's size is left
  std::array<double, samples> all;
  for (int k = 0; k < samples; ++k) all[std::size_t(k)] = value(k * spacing);
  const int best = int(std::ranges::min_element(all) - all.begin());
  constexpr double golden = 1 / std::numbers::phi;
  double low = (best - 1) * spacing, high = (best + 1) * spacing;
  double at_low = all[std::size_t((best + samples - 1) % samples)],
         at_high = all[std::size_t((best + 1) % samples)];
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double fa = value(a), fb = value(b);
  for (int round = 0; round < most_rounds; ++round) {
    const double least = std::min(fa, fb);
    if (std::max(at_low, at_high) - least <= rounding * std::abs(least)) break;
    if (fa < fb) {
      high = b, at_high = fb, b = a, fb = fa;
      fa = value(a = high - golden * (high - low));
    } else {
      low = a, at_low = fa, a = b, fa = fb;
      fb = value(b = low + golden * (high - low));
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

Vector3 SolidShape::Hull::nearest(const Face& face, const Vector3& p, double height) const {
  // Only sides beyond which the point lies can hold the nearest point.
  Vector3 best = p - height * face.normal;
  double least = 1e300;
  for (std::size_t i = face.first_side; i < face.end_of_sides; ++i) {
    const Side& side = sides[i];
    if (side.inwards.dot(p - side.a) >= 0) continue;
    const Vector3 q = nearest_point_of_segment(p, side.a, side.b);
    if (const double square = (p - q).squaredNorm(); square < least) least = square, best = q;
  }
  return best;
}

SolidShape SolidShape::capsule(const Vector3& a, const Vector3& b, double radius) {
  SolidShape out;
  out.form_ = Form::capsule;
  out.centre_ = 0.5 * (a + b);
  out.along_ = 0.5 * (b - a).norm();
  if (out.along_ > 0) out.rotation_ = least_rotation(Vector3::UnitZ(), b - a).toRotationMatrix();
  out.half_ = Vector3::Constant(radius);
  out.reach_ = out.along_ + radius;
  out.extremes_ = {{0, 0, out.along_ + radius}, {radius, 0, 0}};
  return out;
}

SolidShape::SolidShape(const Solid& solid, const Vector3& origin)
    : centre_(solid.position - origin), rotation_(solid_rotation(solid.rotation)) {
  make(solid);
}

/// Adds points of the rim at a height, one of each kind.
void SolidShape::add_rim(double height) {
  constexpr double turn = std::numbers::pi / 8;
  const int count = half_.x() == half_.y() ? 2 : 5;
  for (int k = 0; k < count; ++k)
    extremes_.emplace_back(half_.x() * std::cos(k * turn), half_.y() * std::sin(k * turn), height);
}

void SolidShape::make(const Solid& s) {
  const Vector3 scale = s.scale;
  std::vector<Vector3> points;  // points of hulls
  switch (s.kind) {
    case SolidKind::box:
      form_ = Form::box;
      half_ = s.size.cwiseProduct(scale) / 2;
      reach_ = half_.norm();
      extremes_ = {half_};
      face_middles_ = {{half_.x(), 0, 0}, {0, half_.y(), 0}, {0, 0, half_.z()}};
      break;
    case SolidKind::sphere:
    case SolidKind::capsule:
      form_ = Form::capsule;
      half_ = s.radius * scale;
      along_ = s.kind == SolidKind::sphere ? 0 : s.length / 2 * scale.z();
      reach_ = half_.maxCoeff() + along_;
      extremes_ = {{half_.x(), 0, 0}, {0, half_.y(), 0}, {0, 0, half_.z() + along_}};
      break;
    case SolidKind::cylinder:
      form_ = Form::cylinder;
      half_ = Vector3(s.radius, s.radius, s.height / 2).cwiseProduct(scale);
      reach_ = std::hypot(half_.head<2>().maxCoeff(), half_.z());
      add_rim(half_.z());
      face_middles_ = {{0, 0, half_.z()}};
      break;
    case SolidKind::cone:
      form_ = Form::cone;
      half_ = Vector3(s.radius, s.radius, s.height / 2).cwiseProduct(scale);
      reach_ = std::max(1.5 * half_.z(), std::hypot(half_.head<2>().maxCoeff(), 0.5 * half_.z()));
      add_rim(-0.5 * half_.z());
      extremes_.emplace_back(0, 0, 1.5 * half_.z());
      face_middles_ = {{0, 0, -0.5 * half_.z()}};
      break;
    case SolidKind::torus:
      form_ = Form::torus;
      half_ = s.tube * scale;
      ring_ = s.radius * scale.head<2>();
      reach_ = ring_.maxCoeff() + half_.maxCoeff();
      extremes_ = {{ring_.x() + half_.x(), 0, 0}, {ring_.x() - half_.x(), 0, 0}, {ring_.x(), 0, half_.z()},
                   {0, ring_.y() + half_.y(), 0}, {0, ring_.y() - half_.y(), 0}, {0, ring_.y(), half_.z()}};
      break;
    case SolidKind::prism:
      add_polygon(points, s.sides, s.radius, -s.height / 2);
      add_polygon(points, s.sides, s.radius, s.height / 2);
      break;
    case SolidKind::pyramid:
      add_polygon(points, s.sides, s.radius, -s.height / 4);
      points.emplace_back(0, 0, 0.75 * s.height);
      break;
    case SolidKind::polyhedron:
      points = s.points;
      break;
  }
  if (points.empty()) return;
  for (Vector3& p : points) p = p.cwiseProduct(scale);
  make_hull(points);
}

void SolidShape::make_hull(std::span<const Vector3> points) {
  form_ = Form::hull;
  double size = 0;
  for (const Vector3& p : points) size = std::max(size, p.norm());
  const TolerantHull hull = tolerant_hull(points, hull_tolerance * size);
  auto made = std::make_shared<Hull>();
  for (const Index v : hull.vertices) {
    made->middle += points[v] / double(hull.vertices.size());
    extremes_.push_back(points[v]);
    reach_ = std::max(reach_, points[v].norm());
  }
  const auto& triangles = hull.triangles;
  std::map<std::uint64_t, Index> beyond;  // triangles by the half-edges of their neighbours
  std::vector<Vector3> areas;
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    areas.push_back((points[b] - points[a]).cross(points[c] - points[a]));
    beyond[half_edge_key(b, a)] = beyond[half_edge_key(c, b)] = beyond[half_edge_key(a, c)] = t;
  }
  // Faces grow from their largest triangles to those that lie in the plane of these.
  std::vector<Index> face_of(triangles.size(), no_index);
  for (const Index largest :
       stable_order(triangles.size(), [&](Index a, Index b) { return areas[a].norm() > areas[b].norm(); })) {
    if (face_of[largest] != no_index) continue;
    const auto number = Index(made->faces.size());
    Hull::Face face{areas[largest].stableNormalized(), 0, made->sides.size(), 0};
    face.offset = face.normal.dot(points[triangles[largest][0]]);
    const auto is_in_plane = [&](Index v) {
      return std::abs(face.normal.dot(points[v]) - face.offset) <= hull_tolerance * size;
    };
    Vector3 sum = Vector3::Zero();
    double area = 0;
    face_of[largest] = number;
    std::vector<Index> found{largest};
    std::vector<std::array<Index, 3>> ends;  // ends of sides, and the triangles beyond
    for (std::size_t k = 0; k < found.size(); ++k) {
      const auto& t = triangles[found[k]];
      const double own = areas[found[k]].norm();
      sum += own / 3 * (points[t[0]] + points[t[1]] + points[t[2]]);
      area += own;
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = t[i], b = t[(i + 1) % 3], next = beyond.at(half_edge_key(a, b));
        if (face_of[next] == no_index && std::ranges::all_of(triangles[next], is_in_plane)) {
          face_of[next] = number;
          found.push_back(next);
        }
        ends.push_back({a, b, next});
      }
    }
    for (const auto& [a, b, next] : ends)
      if (face_of[next] != number)
        made->sides.push_back({points[a], points[b], face.normal.cross(points[b] - points[a])});
    face.end_of_sides = made->sides.size();
    made->faces.push_back(face);
    if (area > 0) face_middles_.push_back(sum / area);
  }
  hull_ = std::move(made);
}

Vector3 SolidShape::middle() const {
  // Only the torus has a path: its tube has a middle there, and the others at their centre.
  return hull_ ? hull_->middle : Vector3(ring_.x(), 0, 0);
}

bool SolidShape::is_same(const SolidShape& other) const {
  return form_ == other.form_ && equal_bits(centre_, other.centre_) &&
         equal_bits(rotation_, other.rotation_) && equal_bits(half_, other.half_) &&
         equal_bits(along_, other.along_) && equal_bits(ring_, other.ring_) &&
         equal_bits(reach_, other.reach_) && hull_ == other.hull_;
}

double SolidShape::distance(const Vector3& point) const {
  return own_distance(rotation_.transpose() * (point - centre_));
}

double SolidShape::own_distance(const Vector3& p) const {
  if (form_ == Form::box) {
    const Vector3 d = p.cwiseAbs() - half_;
    return d.cwiseMax(0).norm() + std::min(d.maxCoeff(), 0.0);
  }
  if (form_ == Form::capsule && is_ball_swept())
    return Vector3(p.x(), p.y(), p.z() - std::clamp(p.z(), -along_, along_)).norm() - half_.x();
  if (form_ == Form::torus && is_ball_swept())
    return std::hypot(std::hypot(p.x(), p.y()) - ring_.x(), p.z()) - half_.x();
  return own_place(p).distance;
}

SolidPlace SolidShape::place(const Vector3& point) const {
  SolidPlace out = own_place(rotation_.transpose() * (point - centre_));
  out.gradient = rotation_ * out.gradient;
  out.core = from_own_axes(out.core);
  return out;
}

Vector3 SolidShape::ring_point(double angle) const {
  return {ring_.x() * std::cos(angle), ring_.y() * std::sin(angle), 0};
}

/// Angle of the swept ball that is nearest to a point.
double SolidShape::torus_angle(const Vector3& p) const {
  if (ring_.x() == ring_.y()) return std::atan2(p.y(), p.x());
  return least_angle([&](double a) { return axes_place<3>(half_, p - ring_point(a)).distance; });
}

SolidPlace SolidShape::own_place(const Vector3& p) const {
  switch (form_) {
    case Form::box: {
      const Vector3 nearest = p.cwiseMax(-half_).cwiseMin(half_), away = p - nearest;
      if (const double distance = away.norm(); distance > 0) return {distance, away / distance, nearest, 0};
      Eigen::Index axis;
      const double most = (p.cwiseAbs() - half_).maxCoeff(&axis);
      return place_inside(p, most, Vector3::Unit(axis) * (p[axis] < 0 ? -1 : 1));
    }
    case Form::cylinder:
      return cylinder_place(p);
    case Form::cone:
      return cone_place(p);
    case Form::capsule:
    case Form::torus: {
      const Vector3 middle = form_ == Form::capsule ? Vector3(0, 0, std::clamp(p.z(), -along_, along_))
                                                    : ring_point(torus_angle(p));
      const AxesPlace<3> at = axes_place<3>(half_, p - middle);
      // For a ball the best inner ball is the ball itself.
      if (is_ball_swept()) return {at.distance, at.normal, middle, half_.x()};
      if (at.distance <= 0) return place_inside(p, at.distance, at.normal);
      return {at.distance, at.normal, middle + at.nearest, 0};
    }
    case Form::hull:
      break;
  }
  const Hull::Face* top = nullptr;
  double height = -1e300;
  for (const Hull::Face& face : hull_->faces)
    if (const double h = face.normal.dot(p) - face.offset; h > height) height = h, top = &face;
  if (height <= 0) return place_inside(p, height, top->normal);
  Vector3 nearest = hull_->nearest(*top, p, height);
  double square = (p - nearest).squaredNorm();
  // Directly below the highest plane there is nothing nearer. Triangles of one face may differ by rounding in
  // the side on which the point lies.
  const double rounding = 1e-12 * reach_;
  if (square > height * height * (1 + 1e-12))
    for (const Hull::Face& face : hull_->faces) {
      const double h = face.normal.dot(p) - face.offset;
      if (h < -rounding || (h > 0 && h * h >= square) || &face == top) continue;
      const Vector3 q = hull_->nearest(face, p, h);
      if (const double s = (p - q).squaredNorm(); s < square) square = s, nearest = q;
    }
  return place_outside(p, nearest, top->normal);
}

SolidPlace SolidShape::cylinder_place(const Vector3& p) const {
  const AxesPlace<2> side = axes_place<2>(half_.head<2>(), p.head<2>());
  const double end = std::abs(p.z()) - half_.z(), sign = p.z() < 0 ? -1 : 1;
  const Vector3 side_normal(side.normal.x(), side.normal.y(), 0), end_normal(0, 0, sign);
  if (side.distance <= 0 && end <= 0)
    return side.distance > end ? place_inside(p, side.distance, side_normal)
                               : place_inside(p, end, end_normal);
  Vector3 nearest = p;
  if (side.distance > 0) nearest.head<2>() = side.nearest;
  if (end > 0) nearest.z() = sign * half_.z();
  return place_outside(p, nearest, side.distance > 0 ? side_normal : end_normal);
}

/// Position relative to the cone, which is the convex hull of its tip and of the ellipse of its base.
SolidPlace SolidShape::cone_place(const Vector3& p) const {
  const double low = -0.5 * half_.z(), high = 1.5 * half_.z();
  const Vector3 tip(0, 0, high);
  // Functions of a unit vector in the base's plane: a point of the rim, and the normal of the tangent plane
  // along the line from the tip to it.
  const auto rim = [&](const Vector2& d) { return Vector3(half_.x() * d.x(), half_.y() * d.y(), low); };
  const auto normal = [&](const Vector2& d) -> Vector3 {
    return Vector3(d.x() / half_.x(), d.y() / half_.y(), 1 / (high - low)).normalized();
  };
  const auto least = [](const auto& value) {
    const auto at = [](double a) { return Vector2(std::cos(a), std::sin(a)); };
    return at(least_angle([&](double a) { return value(at(a)); }));
  };
  const bool upright = half_.x() == half_.y();
  const double radius = p.head<2>().norm();
  const Vector2 round = radius > 0 ? Vector2(p.head<2>() / radius) : Vector2(Vector2::UnitX());
  const Vector2 steep = upright ? round : least([&](const Vector2& d) { return -normal(d).dot(p - tip); });
  const double side = normal(steep).dot(p - tip), base = low - p.z();
  if (side <= 0 && base <= 0)
    return side > base ? place_inside(p, side, normal(steep)) : place_inside(p, base, -Vector3::UnitZ());
  const auto square_to_line = [&](const Vector2& d) {
    return (p - nearest_point_of_segment(p, rim(d), tip)).squaredNorm();
  };
  Vector3 nearest = nearest_point_of_segment(p, rim(upright ? round : least(square_to_line)), tip);
  if (base > 0) {
    const AxesPlace<2> edge = axes_place<2>(half_.head<2>(), p.head<2>());
    const Vector2 foot = edge.distance > 0 ? edge.nearest : Vector2(p.head<2>());
    const Vector3 below(foot.x(), foot.y(), low);
    if ((p - below).squaredNorm() < (p - nearest).squaredNorm()) nearest = below;
  }
  return place_outside(p, nearest, side > 0 ? normal(steep) : Vector3(-Vector3::UnitZ()));
}

}  // namespace hariko

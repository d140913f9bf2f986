#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/envelope/solid_shape.hpp"

namespace hariko {

namespace {

constexpr double pi = std::numbers::pi;
/// Lines on a cone from the tip to the rim, on a capsule between its ends.
constexpr int straight_lines = 16;

/// Directions distributed evenly over the sphere.
std::vector<Vector3> spread_directions(int count) {
  std::vector<Vector3> out;
  const double turn = pi * (3 - std::sqrt(5.0));
  for (int k = 0; k < count; ++k) {
    const double z = 1 - (2 * k + 1.0) / count, r = std::sqrt(std::max(0.0, 1 - z * z));
    out.emplace_back(r * std::cos(turn * k), r * std::sin(turn * k), z);
  }
  return out;
}

}  // namespace

Vector3 SharpCurve::at(double share) const {
  if (!across) return base + share * along;
  const double turn = 2 * pi * share;
  return base + std::cos(turn) * along + std::sin(turn) * *across;
}

double SharpCurve::length() const {
  return across ? 2 * pi * std::max(along.norm(), across->norm()) : along.norm();
}

double SolidShape::extent(const Vector3& direction) const {
  const Vector3 way = rotation_.transpose() * direction;
  const double round = way.head<2>().cwiseProduct(half_.head<2>()).norm();
  switch (form_) {
    case Form::box:
      return way.cwiseAbs().dot(half_);
    case Form::cylinder:
      return round + std::abs(way.z()) * half_.z();
    case Form::cone:
      return std::max(1.5 * half_.z() * way.z(), round - 0.5 * half_.z() * way.z());
    case Form::capsule:
      return way.cwiseProduct(half_).norm() + along_ * std::abs(way.z());
    case Form::torus:
      return way.cwiseProduct(half_).norm() + way.head<2>().cwiseProduct(ring_).norm();
    case Form::hull:
      break;
  }
  double out = -reach_;
  for (const Vector3& p : extremes_) out = std::max(out, way.dot(p));
  return out;
}

Vector3 SolidShape::half_extent() const {
  if (form_ == Form::capsule) return half_ + Vector3(0, 0, along_);
  if (form_ != Form::hull) return half_;
  Vector3 out = Vector3::Zero();
  for (const Vector3& corner : extremes_) out = out.cwiseMax((corner - hull_->middle).cwiseAbs());
  return out;
}

std::vector<Vector3> SolidShape::surface_points(int count) const {
  std::vector<Vector3> out;
  if (form_ == Form::torus) {
    // Uses both angles of the torus, because rays from the centre miss most of it.
    for (const Vector3& d : spread_directions(count)) {
      const double a = std::atan2(d.y(), d.x()), b = pi * d.z();
      const Vector3 round(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
      out.push_back(from_own_axes(ring_point(a) + half_.cwiseProduct(round)));
    }
    return out;
  }
  const Vector3 middle = form_ == Form::hull ? hull_->middle : Vector3(Vector3::Zero());
  const Vector3 extent = half_extent();
  for (const Vector3& d : spread_directions(count)) {
    // Convex: the ray leaves the solid once.
    const Vector3 way = extent.cwiseProduct(d);
    double low = 0, high = 1;
    while (own_distance(middle + high * way) < 0 && high < 1e6) high *= 2;
    for (int round = 0; round < 52; ++round) {
      const double share = 0.5 * (low + high);
      (own_distance(middle + share * way) < 0 ? low : high) = share;
    }
    out.push_back(from_own_axes(middle + low * way));
  }
  return out;
}

std::vector<SharpCurve> SolidShape::sharp_curves() const {
  std::vector<SharpCurve> out;
  const auto line = [&](const Vector3& a, const Vector3& b) {
    out.push_back({from_own_axes(a), rotation_ * (b - a)});
  };
  const auto rim = [&](double z) {
    out.push_back({from_own_axes({0, 0, z}), rotation_ * Vector3(half_.x(), 0, 0),
                   Vector3(rotation_ * Vector3(0, half_.y(), 0))});
  };
  const auto at_rim = [&](int k, double z) {
    const double a = 2 * pi * k / straight_lines;
    return Vector3(half_.x() * std::cos(a), half_.y() * std::sin(a), z);
  };
  switch (form_) {
    case Form::box:
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        for (int k = 0; k < 4; ++k) {
          Vector3 a = half_;
          if (k & 1) a[(axis + 1) % 3] *= -1;
          if (k & 2) a[(axis + 2) % 3] *= -1;
          Vector3 b = a;
          b[axis] *= -1;
          line(a, b);
        }
      break;
    case Form::hull:
      for (const Hull::Side& side : hull_->sides)
        if (std::lexicographical_compare(side.a.begin(), side.a.end(), side.b.begin(), side.b.end()))
          line(side.a, side.b);  // the other face has it the other way round
      break;
    case Form::cylinder:
      rim(-half_.z());
      rim(half_.z());
      break;
    case Form::cone:
      rim(-0.5 * half_.z());
      for (int k = 0; k < straight_lines; ++k) line({0, 0, 1.5 * half_.z()}, at_rim(k, -0.5 * half_.z()));
      break;
    case Form::capsule:
      if (along_ > 0)
        for (int k = 0; k < straight_lines; ++k) line(at_rim(k, -along_), at_rim(k, along_));
      break;
    case Form::torus:
      break;
  }
  return out;
}

}  // namespace hariko

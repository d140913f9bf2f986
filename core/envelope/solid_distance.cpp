#include "core/envelope/solid_distance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "core/base/rotation.hpp"

namespace hariko {

namespace {

/// Distance to a box in the plane: half sizes a, b.
double rectangle(double x, double y, double a, double b) {
  const double dx = std::abs(x) - a, dy = std::abs(y) - b;
  return std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) + std::min(std::max(dx, dy), 0.0);
}

/// Distance to the triangle (-, low), (radius, low), (0, high) turned round the axis.
double cone_profile(double r, double z, double radius, double low, double high) {
  const double height = high - low, slant = std::hypot(radius, height);
  const double side = (r * height + (z - high) * radius) / slant;  // outside of the slant
  const double base = low - z;
  if (side <= 0 && base <= 0) return std::max(side, base);
  const auto to_segment = [&](double ax, double ay, double bx, double by) {
    const double ex = bx - ax, ey = by - ay;
    const double t = std::clamp(((r - ax) * ex + (z - ay) * ey) / (ex * ex + ey * ey), 0.0, 1.0);
    return std::hypot(r - ax - t * ex, z - ay - t * ey);
  };
  return std::min(to_segment(0, low, radius, low), to_segment(radius, low, 0, high));
}

/// From the nearest point of a triangle with the unit normal n to p.
Vector3 from_triangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c,
                      const Vector3& n) {
  const auto segment = [&](const Vector3& x, const Vector3& y) -> Vector3 {
    const Vector3 e = y - x;
    return p - x - std::clamp((p - x).dot(e) / e.squaredNorm(), 0.0, 1.0) * e;
  };
  if (n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 &&
      n.dot((a - c).cross(p - c)) >= 0)
    return n.dot(p - a) * n;
  Vector3 best = segment(a, b);
  for (const Vector3& other : {segment(b, c), segment(c, a)})
    if (other.squaredNorm() < best.squaredNorm()) best = other;
  return best;
}

struct HullPlace {
  double plane;  ///< largest height above the triangles' planes, positive outside
  Vector3 from;  ///< outside: from the nearest point of the hull
};
HullPlace place_at_hull(const Vector3& p, std::span<const Vector3> points,
                        std::span<const std::array<Index, 3>> triangles, std::span<const Vector3> normals) {
  HullPlace out{-1e300, Vector3::Zero()};
  for (std::size_t i = 0; i < triangles.size(); ++i)
    out.plane = std::max(out.plane, normals[i].dot(p - points[triangles[i][0]]));
  if (out.plane <= 0) return out;
  double square = 1e300;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    const double height = normals[i].dot(p - points[t[0]]);
    if (height <= 0 || height * height >= square) continue;
    const Vector3 from = from_triangle(p, points[t[0]], points[t[1]], points[t[2]], normals[i]);
    if (const double s = from.squaredNorm(); s < square) square = s, out.from = from;
  }
  return out;
}

/// What central differences make of a maximum of functions: for each coordinate the mean of the largest and
/// the smallest derivative among those that reach it.
class SteepestOf {
 public:
  void add(const Vector3& gradient) {
    low_ = low_.cwiseMin(gradient);
    high_ = high_.cwiseMax(gradient);
  }
  Vector3 gradient() const { return (0.5 * (low_ + high_)).stableNormalized(); }

 private:
  Vector3 low_ = Vector3::Constant(1e300), high_ = Vector3::Constant(-1e300);
};

constexpr double tied = 1e-6;  ///< of the solid's reach: faces are equally near

double sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

std::vector<Vector3> ring(std::uint32_t count, double radius, double z) {
  std::vector<Vector3> out;
  for (std::uint32_t k = 0; k < count; ++k) {
    const double a = 2 * std::numbers::pi * k / count;
    out.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
  }
  return out;
}

}  // namespace

SolidDistance SolidDistance::capsule(const Vector3& a, const Vector3& b, double radius) {
  SolidDistance out;
  out.shape_ = Shape::capsule;
  out.centre_ = 0.5 * (a + b);
  const double length = (b - a).norm();
  if (length > 0) out.rotation_ = least_rotation(Vector3::UnitZ(), b - a).toRotationMatrix();
  out.half_ = {radius, radius, length / 2};
  out.reach_ = length / 2 + radius;
  out.thickness_ = 2 * radius;
  return out;
}

SolidDistance::SolidDistance(const Solid& s, double clearance, const Vector3& origin)
    : clearance_(clearance) {
  centre_ = s.position - origin;
  rotation_ = solid_rotation(s.rotation);
  const bool even = s.scale.x() == s.scale.y() && s.scale.y() == s.scale.z();
  const double f = s.scale.x();
  const bool upright = s.scale.x() == s.scale.y();
  const auto round = [&](std::vector<Vector3> points) {
    for (Vector3& p : points) p = p.cwiseProduct(s.scale);
    make_hull(std::move(points));
  };
  std::vector<Vector3> points;
  switch (s.kind) {
    case SolidKind::box:
      shape_ = Shape::box;
      half_ = s.size.cwiseProduct(s.scale) / 2;
      reach_ = half_.norm();
      break;
    case SolidKind::sphere:
      half_ = Vector3::Constant(s.radius * f);
      reach_ = s.radius * f;
      if (even) break;
      for (int k = -7; k <= 7; ++k) {
        const double a = k * std::numbers::pi / 16;
        const auto r = ring(32, s.radius * std::cos(a), s.radius * std::sin(a));
        points.insert(points.end(), r.begin(), r.end());
      }
      points.emplace_back(0, 0, s.radius);
      points.emplace_back(0, 0, -s.radius);
      round(std::move(points));
      break;
    case SolidKind::cylinder:
      shape_ = Shape::cylinder;
      half_ = {s.radius * f, s.radius * f, s.height / 2 * s.scale.z()};
      reach_ = half_.tail<2>().norm();
      if (upright) break;
      points = ring(32, s.radius, -s.height / 2);
      for (const Vector3& p : ring(32, s.radius, s.height / 2)) points.push_back(p);
      round(std::move(points));
      break;
    case SolidKind::cone:
      shape_ = Shape::cone;
      half_ = {s.radius * f, s.radius * f, s.height / 2 * s.scale.z()};
      reach_ = std::max(1.5 * half_.z(), std::hypot(half_.x(), 0.5 * half_.z()));
      if (upright) break;
      points = ring(32, s.radius, -s.height / 4);
      points.emplace_back(0, 0, 0.75 * s.height);
      round(std::move(points));
      break;
    case SolidKind::prism:
      points = ring(s.sides, s.radius, -s.height / 2);
      for (const Vector3& p : ring(s.sides, s.radius, s.height / 2)) points.push_back(p);
      round(std::move(points));
      break;
    case SolidKind::pyramid:
      points = ring(s.sides, s.radius, -s.height / 4);
      points.emplace_back(0, 0, 0.75 * s.height);
      round(std::move(points));
      break;
    case SolidKind::capsule:
      // As two balls: they are stretched with the solid, the way between them is straight.
      shape_ = Shape::capsule;
      half_ = {s.radius * s.scale.maxCoeff(), s.radius * s.scale.maxCoeff(), s.length / 2 * s.scale.z()};
      reach_ = half_.x() + half_.z();
      break;
    case SolidKind::torus:
      shape_ = Shape::torus;
      half_ = Vector3(s.radius, s.radius, s.tube) * s.scale.maxCoeff();
      tube_ = s.tube * s.scale.maxCoeff();
      reach_ = half_.x() + tube_;
      break;
    case SolidKind::polyhedron:
      round(s.points);
      break;
  }
  if (shape_ == Shape::hull) {
    Vector3 low = hull_->points[0], high = low;
    for (const Vector3& p : hull_->points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    half_ = (high - low) / 2;
    for (const Vector3& p : hull_->points) reach_ = std::max(reach_, p.norm());
  }
  thickness_ = 2 * (shape_ == Shape::capsule ? half_.x() : half_.minCoeff());
  if (s.kind == SolidKind::cone || s.kind == SolidKind::pyramid)
    thickness_ = std::min(thickness_, 1.2 * s.radius * s.scale.minCoeff());
  thickness_ += 2 * clearance;
  reach_ += clearance;
}

SolidDistance SolidDistance::in_frame(const Matrix3& axes, const Vector3& origin) const {
  SolidDistance out = *this;
  out.centre_ = axes.transpose() * (centre_ - origin);
  out.rotation_ = axes.transpose() * rotation_;
  return out;
}

void SolidDistance::make_hull(std::vector<Vector3> points) {
  shape_ = Shape::hull;
  double size = 0;
  for (const Vector3& p : points) size = std::max(size, p.norm());
  const ConvexHull hull = convex_hull(points, 1e-9 * size);
  auto made = std::make_shared<Hull>();
  made->triangles = hull.triangles;
  for (const auto& t : hull.triangles)
    made->normals.push_back(
        (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).stableNormalized());
  made->points = std::move(points);
  hull_ = std::move(made);
}

double SolidDistance::operator()(const Vector3& point) const {
  return local(rotation_.transpose() * (point - centre_)) - clearance_;
}

double SolidDistance::local(const Vector3& p) const {
  const double r = std::hypot(p.x(), p.y());
  switch (shape_) {
    case Shape::box: {
      const Vector3 d = p.cwiseAbs() - half_;
      return d.cwiseMax(0).norm() + std::min(d.maxCoeff(), 0.0);
    }
    case Shape::ball:
      return p.norm() - half_.x();
    case Shape::cylinder:
      return rectangle(r, p.z(), half_.x(), half_.z());
    case Shape::cone:
      return cone_profile(r, p.z(), half_.x(), -0.5 * half_.z(), 1.5 * half_.z());
    case Shape::capsule:
      return std::hypot(r, p.z() - std::clamp(p.z(), -half_.z(), half_.z())) - half_.x();
    case Shape::torus:
      return std::hypot(r - half_.x(), p.z()) - tube_;
    case Shape::hull:
      break;
  }
  const HullPlace at = place_at_hull(p, hull_->points, hull_->triangles, hull_->normals);
  return at.plane <= 0 ? at.plane : at.from.norm();
}

Vector3 SolidDistance::gradient(const Vector3& point) const {
  const Vector3 p = rotation_.transpose() * (point - centre_);
  const double near = tied * reach_, r = std::hypot(p.x(), p.y());
  const Vector3 radial = r > 0 ? Vector3(p.x() / r, p.y() / r, 0) : Vector3::Zero();
  /// In a plane through the axis: `x` along the radius, `z` along the axis.
  const auto profile = [&](double x, double z) -> Vector3 {
    return (x * radial + z * Vector3::UnitZ()).stableNormalized();
  };
  SteepestOf steepest;
  Vector3 out = Vector3::Zero();
  switch (shape_) {
    case Shape::box: {
      const Vector3 d = p.cwiseAbs() - half_;
      out = d.cwiseMax(0);
      if (out.isZero(0))
        for (int i = 0; i < 3; ++i) out[i] = d[i] >= d.maxCoeff() - near ? 1 : 0;
      for (int i = 0; i < 3; ++i) out[i] *= sign_of(p[i]);
      break;
    }
    case Shape::ball:
      out = p;
      break;
    case Shape::cylinder: {
      const double x = r - half_.x(), z = std::abs(p.z()) - half_.z(), s = sign_of(p.z());
      if (x > 0 && z > 0)
        out = profile(x, s * z);
      else
        out = profile(x >= z - near ? 1 : 0, z >= x - near ? s : 0);
      break;
    }
    case Shape::cone: {
      const double low = -0.5 * half_.z(), high = 1.5 * half_.z(), height = high - low;
      const double slant = std::hypot(half_.x(), height);
      const double side = (r * height + (p.z() - high) * half_.x()) / slant, base = low - p.z();
      // On the solid the vector to the nearest point has no direction but that of rounding.
      if (side <= near && base <= near) {
        if (side >= base - near) steepest.add(profile(height, half_.x()));
        if (base >= side - near) steepest.add(-Vector3::UnitZ());
        out = steepest.gradient();
        break;
      }
      const auto from_segment = [&](double ax, double az, double bx, double bz) {
        const double ex = bx - ax, ez = bz - az;
        const double t = std::clamp(((r - ax) * ex + (p.z() - az) * ez) / (ex * ex + ez * ez), 0.0, 1.0);
        return Vector3((r - ax - t * ex) * radial + (p.z() - az - t * ez) * Vector3::UnitZ());
      };
      const Vector3 a = from_segment(0, low, half_.x(), low), b = from_segment(half_.x(), low, 0, high);
      out = a.squaredNorm() <= b.squaredNorm() ? a : b;
      break;
    }
    case Shape::capsule:
      out = p - std::clamp(p.z(), -half_.z(), half_.z()) * Vector3::UnitZ();
      break;
    case Shape::torus:
      out = profile(r - half_.x(), p.z());
      break;
    case Shape::hull: {
      const HullPlace at = place_at_hull(p, hull_->points, hull_->triangles, hull_->normals);
      out = at.from;
      if (at.plane > 0 && out.norm() > near) break;
      for (std::size_t i = 0; i < hull_->normals.size(); ++i)
        if (hull_->normals[i].dot(p - hull_->points[hull_->triangles[i][0]]) >= at.plane - near)
          steepest.add(hull_->normals[i]);
      out = steepest.gradient();
      break;
    }
  }
  return rotation_ * out.stableNormalized();
}

double SolidDistance::support(const Vector3& direction) const {
  const Vector3 d = rotation_.transpose() * direction;
  const double flat = std::hypot(d.x(), d.y());
  double out = 0;
  switch (shape_) {
    case Shape::box:
      out = d.cwiseAbs().dot(half_);
      break;
    case Shape::ball:
      out = half_.x() * d.norm();
      break;
    case Shape::cylinder:
      out = half_.x() * flat + half_.z() * std::abs(d.z());
      break;
    case Shape::cone:
      out = std::max(1.5 * half_.z() * d.z(), half_.x() * flat - 0.5 * half_.z() * d.z());
      break;
    case Shape::capsule:
      out = half_.x() * d.norm() + half_.z() * std::abs(d.z());
      break;
    case Shape::torus:
      out = half_.x() * flat + tube_ * d.norm();
      break;
    case Shape::hull:
      out = -1e300;
      for (const Vector3& p : hull_->points) out = std::max(out, d.dot(p));
  }
  return direction.dot(centre_) + out;
}

std::pair<Index, double> nearest_solid(std::span<const SolidDistance> solids, const Vector3& point) {
  std::pair<Index, double> best{0, 1e300};
  for (Index s = 0; s < solids.size(); ++s) {
    const SolidDistance& solid = solids[s];
    if ((point - solid.centre()).norm() - solid.reach() > best.second) continue;
    if (const double d = solid(point); d < best.second) best = {s, d};
  }
  return best;
}

UnionField::UnionField(std::vector<SolidDistance> solids, double fillet, Factors factors)
    : solids_(std::move(solids)), fillet_(fillet), largest_fillet_(fillet), factors_(std::move(factors)) {
  for (const auto& [pair, factor] : factors_) largest_fillet_ = std::max(largest_fillet_, factor * fillet);
}

double UnionField::fillet_of(Index a, Index b) const {
  if (factors_.empty()) return fillet_;
  const auto found = factors_.find(std::minmax(a, b));
  return found == factors_.end() ? fillet_ : found->second * fillet_;
}

double UnionField::operator()(const Vector3& point) const {
  struct Near {
    double distance;
    Index solid;
  };
  std::array<Near, 4> near;
  near.fill({1e300, no_index});
  for (Index s = 0; s < solids_.size(); ++s) {
    const SolidDistance& solid = solids_[s];
    // Beyond the fillet's reach a solid means nothing.
    const double bound = (point - solid.centre()).norm() - solid.reach();
    if (bound > near[3].distance || (bound > largest_fillet_ && bound > near[0].distance)) continue;
    const double d = solid(point);
    if (d >= near[3].distance) continue;
    std::size_t at = 3;
    while (at > 0 && near[at - 1].distance > d) near[at] = near[at - 1], --at;
    near[at] = {d, s};
  }
  double out = near[0].distance;
  if (!(near[1].distance < largest_fillet_) || !(near[0].distance > -largest_fillet_)) return out;
  std::array<Vector3, 4> gradient;
  std::array<bool, 4> known{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double a = near[i].distance, b = near[j].distance;
      const double fillet = b < largest_fillet_ ? fillet_of(near[i].solid, near[j].solid) : 0;
      if (!(a < fillet) || !(b < fillet)) continue;
      for (const std::size_t m : {i, j})
        if (!known[m]) gradient[m] = solids_[near[m].solid].gradient(point), known[m] = true;
      const double x = std::clamp((1 - gradient[i].dot(gradient[j])) / 0.7, 0.0, 1.0);
      const double k = fillet * (3 * x * x - 2 * x * x * x);
      out =
          std::min(out, std::max(k, std::min(a, b)) - std::hypot(std::max(k - a, 0.0), std::max(k - b, 0.0)));
    }
  return out;
}

int UnionField::side(const Vector3& centre, double radius, double above) const {
  double nearest = 1e300, second = 1e300;
  for (const SolidDistance& solid : solids_) {
    if ((centre - solid.centre()).norm() - solid.reach() > second) continue;
    const double d = solid(centre);
    if (d < nearest)
      second = std::exchange(nearest, d);
    else if (d < second)
      second = d;
  }
  // Distances change by no more than the way. What lies within rounding of the surface is looked at.
  const double way = (1 + 1e-9) * radius, least = nearest - way, k = largest_fillet_;
  if (nearest < -way) return -1;
  // The fillet of two solids as near as the nearest is the lowest.
  const bool alone = second - way > k || least > k;
  const double bound = alone ? least : k - std::numbers::sqrt2 * (k - least);
  return bound >= above ? 1 : 0;
}

Vector3 UnionField::gradient(const Vector3& point) const {
  const double step = 1e-4 * std::max(fillet_, 1e-3);
  Vector3 out;
  for (int i = 0; i < 3; ++i) {
    Vector3 a = point, b = point;
    a[i] -= step;
    b[i] += step;
    out[i] = ((*this)(b) - (*this)(a)) / (2 * step);
  }
  return out;
}

Vector3 UnionField::projected(Vector3 point, int steps, double step) const {
  for (int k = 0; k < steps; ++k) {
    const double f = (*this)(point);
    if (f == 0) break;
    const Vector3 g = gradient(point);
    const double square = g.squaredNorm();
    if (!(square > 1e-12)) break;
    Vector3 move = -0.9 * f / square * g;
    if (const double length = move.norm(); length > step) move *= step / length;
    point += move;
  }
  return point;
}

}  // namespace hariko

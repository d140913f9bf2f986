#include "ui/view/axis_lock.hpp"

#include <cmath>

namespace hariko {

namespace {

constexpr double least_angle =
    0.06;  ///< radians between an axis and the ray, below which its point is ill-conditioned

/// Parameter of the point of the axis that is nearest to a ray.
std::optional<double> along_axis(const Ray& ray, const Vector3& anchor, const Vector3& axis) {
  const Vector3 cross = ray.direction.cross(axis);
  if (cross.norm() < least_angle) return std::nullopt;
  const Vector3 normal = ray.direction.cross(cross);
  return (ray.origin - anchor).dot(normal) / axis.dot(normal);
}

std::optional<Vector3> on_plane(const Ray& ray, const Vector3& anchor, const Vector3& normal) {
  const double slope = ray.direction.dot(normal);
  if (std::abs(slope) < least_angle) return std::nullopt;
  const double t = (anchor - ray.origin).dot(normal) / slope;
  if (t <= 0) return std::nullopt;
  return ray.at(t);
}

Vector3 axis_drag(const Projector& projector, const Vector3& axis, const Vector3& anchor, const Vector2& from,
                  const Vector2& to) {
  const double limit = 1e4 * projector.camera().distance;
  const auto begin = along_axis(projector.ray(from), anchor, axis);
  const auto end = along_axis(projector.ray(to), anchor, axis);
  // Beyond the horizon of the axis the nearest point jumps behind the viewer.
  if (begin && end && projector.project(anchor + *end * axis) && std::abs(*end - *begin) < limit)
    return (*end - *begin) * axis;
  const double up = (from - to).y() * projector.pixel_length_at(anchor);
  return axis.dot(projector.camera().forward()) > 0 ? Vector3(up * axis) : Vector3(-up * axis);
}

}  // namespace

bool AxisLock::key(const KeyPress& press) {
  const KeyChord& chord = press.chord;
  if (chord.control || chord.alt || chord.key < Key::x || chord.key > Key::z) return false;
  const Kind wanted = chord.shift ? Kind::plane : Kind::axis;
  const int pressed = chord.key - Key::x;
  if (kind != wanted || axis != pressed)
    *this = {wanted, pressed, false};
  else if (!local)
    local = true;
  else
    *this = {};
  return true;
}

int AxisLock::component_axis(std::size_t i) const {
  const int index = static_cast<int>(i);
  if (kind == Kind::axis) return axis;
  return kind == Kind::plane && index >= axis ? index + 1 : index;
}

Vector3 drag_vector(const Projector& projector, const AxisLock& lock, const Matrix3& frame,
                    const Vector3& anchor, const Vector2& from, const Vector2& to) {
  if (lock.kind == AxisLock::Kind::axis) {
    // Drags along a coordinate axis leave nothing in the others, whatever the rounding.
    return axis_drag(projector, frame.col(lock.axis), anchor, from, to);
  }
  if (lock.kind == AxisLock::Kind::plane) {
    const Vector3 normal = frame.col(lock.axis);
    const auto begin = on_plane(projector.ray(from), anchor, normal);
    const auto end = on_plane(projector.ray(to), anchor, normal);
    const double limit = 1e4 * projector.camera().distance;
    Vector3 by =
        begin && end && (*end - *begin).norm() < limit
            ? Vector3(*end - *begin)
            : Vector3(projector.on_facing_plane(to, anchor) - projector.on_facing_plane(from, anchor));
    // Exactly within the plane.
    Vector3 local = frame.transpose() * by;
    local[lock.axis] = 0;
    return frame * local;
  }
  return projector.on_facing_plane(to, anchor) - projector.on_facing_plane(from, anchor);
}

}  // namespace hariko

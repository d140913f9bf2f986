#include "render/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double least_distance = 1e-9, greatest_distance = 1e12;
constexpr double frame_margin = 1.08;
constexpr double greatest_clip_ratio = 20'000;
constexpr double greatest_lean = pi / 3;  ///< radians; steeper views lean less, down to nothing

/// Orientation with a level horizon: azimuth 0 looks along +y and grows as the eye moves to +x; elevation is
/// the angle of the eye above the horizon.
Eigen::Quaterniond level_orientation(double azimuth, double elevation) {
  const Vector3 right(std::cos(azimuth), std::sin(azimuth), 0);
  const Vector3 back(std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                     std::sin(elevation));
  Matrix3 axes;
  axes << right, back.cross(right), back;
  return Eigen::Quaterniond(axes).normalized();
}

std::array<Vector3, 8> corners(const Box3& box) {
  std::array<Vector3, 8> out;
  for (int i = 0; i < 8; ++i) out[std::size_t(i)] = box.corner(static_cast<Box3::CornerType>(i));
  return out;
}

Camera turned(const Camera& camera, const Eigen::Quaterniond& orientation, const Vector3& pivot) {
  Camera out = camera;
  out.orientation = orientation.normalized();
  out.target = pivot + out.orientation * (camera.orientation.conjugate() * (camera.target - pivot));
  return out;
}

}  // namespace

std::optional<StandardView> standard_view_from(std::string_view name) {
  return enum_value<StandardView>(name);
}

std::string_view to_string(StandardView view) {
  return enum_word(view);
}

Camera Camera::standard(StandardView view) {
  Camera camera;
  switch (view) {
    case StandardView::iso:
      camera.orientation = level_orientation(pi / 4, std::asin(1 / std::sqrt(3.0)));
      break;
    case StandardView::front:
      camera.orientation = level_orientation(0, 0);
      break;
    case StandardView::back:
      camera.orientation = level_orientation(pi, 0);
      break;
    case StandardView::left:
      camera.orientation = level_orientation(-pi / 2, 0);
      break;
    case StandardView::right:
      camera.orientation = level_orientation(pi / 2, 0);
      break;
    case StandardView::top:
      camera.orientation = level_orientation(0, pi / 2);
      break;
    case StandardView::bottom:
      camera.orientation = level_orientation(0, -pi / 2);
      break;
  }
  return camera;
}

Vector3 Camera::towards_eye() const {
  Vector3 out = orientation * Vector3::UnitZ();
  for (double& part : out)
    if (std::abs(part) < 1e-12) part = 0;
  return out.normalized();
}

double Camera::view_height() const {
  return 2 * distance * std::tan(field_of_view / 2);
}

double focal_length_of(double field_of_view) {
  return film_height / 2 / std::tan(field_of_view / 2);
}

double field_of_view_of(double focal_length) {
  return 2 * std::atan(film_height / 2 / focal_length);
}

double Camera::lean() const {
  if (!two_point || orthographic) return 0;
  const double back = (orientation * Vector3::UnitZ()).z(), above = up().z();
  if (back == 0 || above == 0) return 0;
  const double upright = std::atan(back / above), steep = std::abs(upright);
  if (steep <= greatest_lean) return upright;
  const double left = greatest_lean * (pi / 2 - steep) / (pi / 2 - greatest_lean);
  return std::copysign(std::max(0.0, left), upright);
}

Eigen::Quaterniond Camera::picture_orientation() const {
  const double angle = lean();
  if (angle == 0) return orientation;
  return orientation * Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector3::UnitX()));
}

double Camera::half_slope() const {
  const double slope = std::tan(field_of_view / 2), angle = lean();
  return angle == 0 ? slope : slope / std::cos(angle);
}

double Camera::middle_slope() const {
  const double angle = lean();
  return angle == 0 ? 0 : -std::tan(angle);
}

Matrix4 Camera::view_matrix() const {
  const double angle = lean();
  const Matrix3 to_camera = picture_orientation().conjugate().toRotationMatrix();
  Matrix4 view = Matrix4::Identity();
  view.topLeftCorner<3, 3>() = to_camera;
  // Target first, then the distance: keeps the precision of targets far from the world's origin.
  const Vector3 back = angle == 0 ? Vector3(0, 0, distance)
                                  : Vector3(0, distance * std::sin(angle), distance * std::cos(angle));
  view.topRightCorner<3, 1>() = to_camera * -target - back;
  return view;
}

Matrix4 Camera::projection_matrix(PixelSize size, ClipRange clip) const {
  Matrix4 m = Matrix4::Zero();
  const double n = clip.near_plane, f = clip.far_plane;
  if (orthographic) {
    const double half = view_height() / 2;
    m(0, 0) = 1 / (half * size.aspect());
    m(1, 1) = 1 / half;
    m(2, 2) = -2 / (f - n);
    m(2, 3) = -(f + n) / (f - n);
    m(3, 3) = 1;
  } else {
    const double cot = 1 / half_slope();
    m(0, 0) = cot / size.aspect();
    m(1, 1) = cot;
    m(1, 2) = cot * middle_slope();
    m(2, 2) = -(f + n) / (f - n);
    m(2, 3) = -2 * f * n / (f - n);
    m(3, 2) = -1;
  }
  return m;
}

ClipRange Camera::clip_range(const Box3& box) const {
  double least = distance * 0.5, greatest = distance * 2;
  if (!box.isEmpty()) {
    least = 1e300, greatest = -1e300;
    const Vector3 eye_point = eye(), across = picture_forward();
    for (const Vector3& corner : corners(box)) {
      const double depth = (corner - eye_point).dot(across);
      least = std::min(least, depth);
      greatest = std::max(greatest, depth);
    }
  }
  const double margin = 0.02 * std::max(greatest - least, 0.01 * distance);
  ClipRange range{least - margin, greatest + margin};
  if (!orthographic) {
    range.far_plane = std::max(range.far_plane, distance * 1e-3);
    range.near_plane = std::max(range.near_plane, range.far_plane / greatest_clip_ratio);
  }
  return range;
}

Camera Camera::orbit(double yaw, double pitch, const Vector3& pivot) const {
  const Vector3 x = right();
  const Vector3 back = -forward();
  const double azimuth = std::atan2(x.y(), x.x()) - yaw;
  const double elevation = std::clamp(std::asin(std::clamp(back.z(), -1.0, 1.0)) + pitch, -pi / 2, pi / 2);
  return turned(*this, level_orientation(azimuth, elevation), pivot);
}

Camera Camera::trackball(double yaw, double pitch, const Vector3& pivot) const {
  const Eigen::Quaterniond turn =
      Eigen::AngleAxisd(-yaw, Vector3::UnitY()) * Eigen::AngleAxisd(-pitch, Vector3::UnitX());
  return turned(*this, orientation * turn, pivot);
}

Camera Camera::pan(double dx, double dy, PixelSize size) const {
  Camera out = *this;
  out.target += pixel_length(size) * (-dx * right() + dy * picture_up());
  return out;
}

Camera Camera::zoom(double factor, const Vector2& pixel, PixelSize size) const {
  HARIKO_ASSERT(factor > 0, "zoom factor must be positive");
  Camera out = *this;
  out.distance = std::clamp(distance * factor, least_distance, greatest_distance);
  const Vector2 offset = pixel - Vector2(size.width, size.height) / 2;
  const double moved = pixel_length(size) - out.pixel_length(size);
  out.target += moved * (offset.x() * right() - offset.y() * picture_up());
  return out;
}

Camera Camera::frame(std::span<const Vector3> points, PixelSize size) const {
  const double tan_y = half_slope() / frame_margin, tan_x = tan_y * size.aspect();
  const double slope_x = orthographic ? 0 : tan_x, slope_y = orthographic ? 0 : tan_y;
  // In the picture's axes a point (x, y, z) is inside when |x - eye.x| <= tan_x (eye.z - z), and the same for
  // y, after a shear that takes the picture's middle to the axis: each of the four planes gives a bound from
  // its own farthest point.
  const double shear = middle_slope();
  double right_most = -1e300, left_most = -1e300, top_most = -1e300, bottom_most = -1e300;
  double nearest = -1e300, farthest = 1e300;
  const Eigen::Quaterniond axes = picture_orientation();
  const Matrix3 to_camera = axes.conjugate().toRotationMatrix();
  for (const Vector3& point : points) {
    if (!point.allFinite()) continue;
    Vector3 p = to_camera * (point - target);
    p.y() += shear * p.z();
    right_most = std::max(right_most, p.x() + slope_x * p.z());
    left_most = std::max(left_most, -p.x() + slope_x * p.z());
    top_most = std::max(top_most, p.y() + slope_y * p.z());
    bottom_most = std::max(bottom_most, -p.y() + slope_y * p.z());
    nearest = std::max(nearest, p.z());
    farthest = std::min(farthest, p.z());
  }
  if (nearest < farthest) return *this;  // no points
  const double depth = (nearest + farthest) / 2;
  double needed = std::max((right_most + left_most) / (2 * tan_x), (top_most + bottom_most) / (2 * tan_y));
  if (!orthographic) needed = std::max(needed, nearest + 0.05 * (nearest - farthest)) - depth;
  Camera out = *this;
  out.target = target + axes * Vector3((right_most - left_most) / 2,
                                       (top_most - bottom_most) / 2 - shear * depth, depth);
  if (shear != 0) needed *= std::hypot(1.0, shear);  // from a depth to a length along the viewing direction
  out.distance =
      needed > least_distance ? std::min(needed, greatest_distance) : 1;  // a single point has no extent
  return out;
}

Camera Camera::frame(const Box3& box, PixelSize size) const {
  if (box.isEmpty()) return *this;
  return frame(corners(box), size);
}

Camera Camera::with_focal_length(double millimetres) const {
  HARIKO_ASSERT(millimetres > 0, "focal length must be positive");
  Camera out = *this;
  out.field_of_view = field_of_view_of(millimetres);
  const double longer = std::tan(field_of_view / 2) / std::tan(out.field_of_view / 2);
  out.distance = std::clamp(distance * longer, least_distance, greatest_distance);
  return out;
}

Camera Camera::mix(const Camera& from, const Camera& to, double x) {
  if (x <= 0) return from;
  if (x >= 1) return to;
  Camera out = to;
  out.target = from.target + x * (to.target - from.target);
  out.orientation = from.orientation.slerp(x, to.orientation).normalized();
  out.distance = from.distance * std::pow(to.distance / from.distance, x);
  out.field_of_view = from.field_of_view + x * (to.field_of_view - from.field_of_view);
  return out;
}

Projector::Projector(const Camera& camera, PixelSize size)
    : camera_(camera),
      size_(size),
      to_camera_(camera.picture_orientation().conjugate().toRotationMatrix()),
      eye_(camera.eye()),
      focal_(camera.orthographic ? size.height / camera.view_height()
                                 : size.height / (2 * camera.half_slope())),
      middle_(camera.middle_slope()) {}

std::optional<Vector3> Projector::project(const Vector3& world) const {
  Vector3 local = to_camera_ * (world - camera_.target);
  // The eye's depth; after the shear that takes the picture's middle to the axis the eye lies on that axis.
  const double back = middle_ == 0 ? camera_.distance : camera_.distance / std::hypot(1.0, middle_);
  local.y() += middle_ * local.z();
  const double depth = back - local.z();
  double scale = focal_;
  if (!camera_.orthographic) {
    if (!(depth > camera_.distance * 1e-9)) return std::nullopt;
    scale /= depth;
  }
  return Vector3(size_.width / 2.0 + scale * local.x(), size_.height / 2.0 - scale * local.y(), depth);
}

Ray Projector::ray(const Vector2& pixel) const {
  const Vector2 offset = (pixel - Vector2(size_.width, size_.height) / 2) / focal_;
  if (camera_.orthographic)
    return {eye_ + offset.x() * camera_.right() - offset.y() * camera_.up(), camera_.forward()};
  return {eye_, (camera_.picture_forward() + offset.x() * camera_.right() +
                 (middle_ - offset.y()) * camera_.picture_up())
                    .normalized()};
}

Vector3 Projector::on_facing_plane(const Vector2& pixel, const Vector3& anchor) const {
  const Ray r = ray(pixel);
  const Vector3 forward = camera_.picture_forward();
  return r.at((anchor - r.origin).dot(forward) / r.direction.dot(forward));
}

double Projector::pixel_length_at(const Vector3& world) const {
  if (camera_.orthographic) return 1 / focal_;
  const double depth = (world - eye_).dot(camera_.picture_forward());
  return std::max(depth, camera_.distance * 1e-9) / focal_;
}

}  // namespace hariko

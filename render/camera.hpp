#pragma once

// Camera: the eye as a value, with the mapping between the world and pixels. No GL.

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/text/enum_words.hpp"
#include "core/base/vector.hpp"

namespace hariko {

using Box3 = Eigen::AlignedBox3d;
using Matrix4 = Eigen::Matrix4d;

/// Film of 36 x 24 mm that focal lengths belong to: its height is that of the picture, however wide that is.
inline constexpr double film_height = 24;
/// Focal length, in millimetres, of a vertical field of view in (0, pi), and back.
double focal_length_of(double field_of_view);
double field_of_view_of(double focal_length);

/// Standard viewing directions.
enum class StandardView { iso, front, back, left, right, top, bottom };
template <>
inline constexpr auto enum_words<StandardView> = all_words<StandardView>({{StandardView::iso, "iso"},
                                                                          {StandardView::front, "front"},
                                                                          {StandardView::back, "back"},
                                                                          {StandardView::left, "left"},
                                                                          {StandardView::right, "right"},
                                                                          {StandardView::top, "top"},
                                                                          {StandardView::bottom, "bottom"}});

/// View by its name "iso", "front", ...; nothing for other words.
std::optional<StandardView> standard_view_from(std::string_view name);
/// Inverse of `standard_view_from`.
std::string_view to_string(StandardView view);

/// Half-line in the world.
struct Ray {
  Vector3 origin, direction;  ///< direction is unit
  Vector3 at(double t) const { return origin + t * direction; }
};

/// Size of a viewport in pixels of the framebuffer.
struct PixelSize {
  int width = 1, height = 1;
  double aspect() const { return static_cast<double>(width) / static_cast<double>(height); }
  friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// Distances from the eye along the viewing direction.
struct ClipRange {
  double near_plane = 0.1, far_plane = 1000;
};

/// Perspective or orthographic camera in a right-handed world with z up; the front view looks along +y.
/// Camera axes: x right, y up, z towards the viewer. In two-point perspective the picture's plane leans
/// against them about x, so that it is upright and verticals of the world are parallel in the picture.
/// Pixels: x to the right, y down, (0, 0) is the upper left corner of the upper left pixel.
struct Camera {
  Vector3 target = Vector3::Zero();                                 ///< centre of rotation
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< camera axes to world axes, unit
  double distance = 10;        ///< eye to target, > 0, in the document's unit
  double field_of_view = 0.5;  ///< vertical, radians, in (0, pi)
  bool orthographic = false;   ///< orthographic; the target's plane has the same size as in perspective
  bool two_point = false;      ///< two-point perspective, where not orthographic

  /// Camera with the orientation of a standard view.
  static Camera standard(StandardView view);
  /// Unit direction from the target to the eye. Where rounding alone tilts it from an axis it is the axis.
  Vector3 towards_eye() const;

  Vector3 right() const { return orientation * Vector3::UnitX(); }
  Vector3 up() const { return orientation * Vector3::UnitY(); }
  Vector3 forward() const { return -(orientation * Vector3::UnitZ()); }
  Vector3 eye() const { return target - distance * forward(); }
  /// Angle from the plane across the viewing direction to the picture's plane, about the camera's x, in
  /// (-pi/2, pi/2); 0 unless the camera is in two-point perspective. Up to 60 degrees the plane is upright;
  /// towards views from above and below, which have no upright plane, the angle goes back to 0.
  double lean() const;
  /// Axes of the picture: right, up, and towards the viewer across its plane.
  Eigen::Quaterniond picture_orientation() const;
  Vector3 picture_up() const { return picture_orientation() * Vector3::UnitY(); }
  /// Direction in which depths are measured, across the picture's plane.
  Vector3 picture_forward() const { return -(picture_orientation() * Vector3::UnitZ()); }
  /// Slope from the eye to the upper border of the picture against that to its middle, in the picture's axes.
  double half_slope() const;
  /// Slope from the eye to the picture's middle in the picture's axes; 0 unless the plane leans.
  double middle_slope() const;
  /// Height of the visible part of the target's plane.
  double view_height() const;
  /// Length that one pixel covers in the target's plane.
  double pixel_length(PixelSize size) const { return view_height() / size.height; }

  /// Matrix from the world to the picture's axes at the eye (rigid).
  Matrix4 view_matrix() const;
  /// Matrix from the picture's axes to GL clip space.
  Matrix4 projection_matrix(PixelSize size, ClipRange clip) const;
  /// Near and far planes that enclose a box with a margin. Near is at least far / 20,000, so that a 24-bit
  /// depth buffer separates neighbouring surfaces. An empty box gives planes round the target.
  ClipRange clip_range(const Box3& box) const;

  /// Turntable: yaw about the world's z, pitch about the camera's x (radians, positive turns the model to the
  /// right and towards the viewer), about `pivot`. The horizon stays level; pitch stops at the poles.
  Camera orbit(double yaw, double pitch, const Vector3& pivot) const;
  Camera orbit(double yaw, double pitch) const { return orbit(yaw, pitch, target); }
  /// Trackball: turns about the camera's own axes, the horizon may tilt.
  Camera trackball(double yaw, double pitch, const Vector3& pivot) const;
  /// Moves the camera so that the target's plane follows a cursor moved by (dx, dy) pixels.
  Camera pan(double dx, double dy, PixelSize size) const;
  /// Scales the distance by `factor` (> 0; < 1 comes closer) and keeps the point of the target's plane under
  /// the pixel fixed.
  Camera zoom(double factor, const Vector2& pixel, PixelSize size) const;
  /// Same orientation with all points visible, as large as possible with a margin of 8 %; the target lies at
  /// the middle of their depths. Points that are not finite are ignored; without points the camera is
  /// unchanged. O(points).
  Camera frame(std::span<const Vector3> points, PixelSize size) const;
  /// Same as above for the corners of a box.
  Camera frame(const Box3& box, PixelSize size) const;
  /// Same picture of the target's plane through a lens of another focal length, in millimetres, > 0: the eye
  /// comes closer or goes away.
  Camera with_focal_length(double millimetres) const;
  /// Interpolation between two cameras, x in [0, 1], for eased view changes: target and logarithm of the
  /// distance linearly, orientation by slerp.
  static Camera mix(const Camera& from, const Camera& to, double x);

  friend bool operator==(const Camera& a, const Camera& b) {
    return a.target == b.target && a.orientation.coeffs() == b.orientation.coeffs() &&
           a.distance == b.distance && a.field_of_view == b.field_of_view &&
           a.orthographic == b.orthographic && a.two_point == b.two_point;
  }
};

/// Projection between world points and pixels, for a camera with a viewport. Cheap to make; a snapshot.
class Projector {
 public:
  Projector(const Camera& camera, PixelSize size);

  /// Pixel of a world point and its distance from the eye's plane, which is parallel to the picture (z);
  /// nothing at or behind the eye.
  std::optional<Vector3> project(const Vector3& world) const;
  /// Ray through a pixel; orthographic rays start on the eye's plane.
  Ray ray(const Vector2& pixel) const;
  /// Point under a pixel on the plane through `anchor` that is parallel to the view plane, for dragging.
  Vector3 on_facing_plane(const Vector2& pixel, const Vector3& anchor) const;
  /// Length of one pixel at a world point.
  double pixel_length_at(const Vector3& world) const;

  PixelSize size() const { return size_; }
  const Camera& camera() const { return camera_; }

 private:
  Camera camera_;
  PixelSize size_;
  Matrix3 to_camera_;  ///< to the picture's axes
  Vector3 eye_;
  double focal_;   ///< pixels per unit of slope (perspective) or per unit of length (orthographic)
  double middle_;  ///< slope of the picture's middle
};

}  // namespace hariko

#pragma once

// PlaneFrame: a plane with a zero and axes of its own, in which one draws.

#include <optional>
#include <span>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

inline constexpr Code e_plane_in_line{"E_PLANE_IN_LINE"};

struct PlaneFrame {
  Vector3 point = Vector3::Zero();     ///< zero of its coordinates, in the document's space
  Matrix3 axes = Matrix3::Identity();  ///< orthonormal and right-handed, as columns: x, y, normal

  Vector3 normal() const { return axes.col(2); }
  /// Coordinates of a point; the third is its height over the plane.
  Vector3 local(const Vector3& place) const { return axes.transpose() * (place - point); }
  Vector3 at(const Vector3& local) const { return point + axes * local; }
  /// The point of the plane that lies at right angles below another one.
  Vector3 foot(const Vector3& place) const { return at({local(place).x(), local(place).y(), 0}); }
  friend bool operator==(const PlaneFrame&, const PlaneFrame&) = default;
};

/// Parameter of a ray's point in the plane, negative before its origin; nothing where it runs along the
/// plane: its slope against it is below `least_slope` (the sine of the angle between them). `direction`:
/// unit.
std::optional<double> where_ray_meets(const PlaneFrame& plane, const Vector3& origin,
                                      const Vector3& direction, double least_slope);

/// Plane with a unit normal and upright axes: x is level, y goes up as seen from the tip of the normal. Level
/// planes have the axes of the document, as far as their side allows.
PlaneFrame upright_plane(const Vector3& point, const Vector3& normal);

/// Plane through three points: the first is its zero, the second lies on its x axis, the third on the side of
/// positive y. Error: E_PLANE_IN_LINE where they lie in a line, within 1e-9 of their distances.
Result<PlaneFrame> plane_through(const Vector3& zero, const Vector3& on_x, const Vector3& third);

/// Mean plane of a polygon through its centre, upright, with the polygon's own side up. Error:
/// E_PLANE_IN_LINE where the corners lie in a line.
Result<PlaneFrame> plane_of_polygon(std::span<const Vector3> corners);

/// Plane of a section through the point of the path where it stands, upright, seen as the section is drawn;
/// in the object's space.
PlaneFrame plane_of_section(const Skin& skin, const SkinSection& section);

}  // namespace hariko

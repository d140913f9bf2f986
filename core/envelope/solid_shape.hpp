#pragma once

// SolidShape: exact signed distances to solids of all kinds in every placement and scale (docs/envelope.md).

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/envelope/solid.hpp"

namespace hariko {

/// Position of a solid relative to a point.
struct SolidPlace {
  double distance = 0;                  ///< negative inside
  Vector3 gradient = Vector3::UnitZ();  ///< unit, away from the solid
  /// Ball inside the solid that is as far from the point as the solid: gives an upper bound of the distance
  /// at other points.
  Vector3 core = Vector3::Zero();
  double core_radius = 0;
};

/// Line or closed ellipse on the surface of a solid where it is sharp or straight, and where surface points
/// may miss protruding parts.
struct SharpCurve {
  Vector3 base;                        ///< start of a line; centre of an ellipse
  Vector3 along;                       ///< vector to the line's end; to the ellipse's point of share 0
  std::optional<Vector3> across = {};  ///< ellipses: vector to the point of share 1/4
  /// Point at share 0 .. 1, from end to end or once round.
  Vector3 at(double share) const;
  /// Length of the curve; for ellipses an upper bound: no part is longer than its share of this.
  double length() const;
};

/// Signed distance to one solid. Distances are 1-Lipschitz, inside and outside. All solids but the torus are
/// convex, and so are their distance functions.
class SolidShape {
 public:
  /// Makes the shape, with positions relative to `origin`. `solid` passes `check_solid`.
  SolidShape(const Solid& solid, const Vector3& origin);
  /// Capsule: a ball swept from a to b.
  static SolidShape capsule(const Vector3& a, const Vector3& b, double radius);

  double distance(const Vector3& point) const;
  SolidPlace place(const Vector3& point) const;

  const Vector3& centre() const { return centre_; }
  double reach() const { return reach_; }  ///< no point of the solid is farther from the centre
  /// Largest way of a point of the solid from the centre along a unit vector.
  double extent(const Vector3& direction) const;
  bool is_convex() const { return form_ != Form::torus; }
  /// Whether distances are exact to rounding, and so 1-Lipschitz. On stretched cones and rings the nearest
  /// place is searched for, and a distance may be too large.
  bool is_exact() const {
    return (form_ != Form::cone || half_.x() == half_.y()) &&
           (form_ != Form::torus || ring_.x() == ring_.y());
  }
  /// Whether another shape has the same distances, bit for bit. Hulls count as the same where one is a copy
  /// of the other. O(1).
  bool is_same(const SolidShape& other) const;
  /// Points of the solid, one of each kind of corner, rim and side, in its own axes about its centre:
  /// candidates for the largest mean of the distance over a neighbourhood.
  const std::vector<Vector3>& extremes() const { return extremes_; }
  /// One point of each kind of flat face, in its own axes about its centre: candidates for the least mean of
  /// the distance over a neighbourhood. Empty where no face is flat.
  const std::vector<Vector3>& face_middles() const { return face_middles_; }
  /// Point deep inside the solid, in its own axes about its centre.
  Vector3 middle() const;
  /// `count` points distributed over the surface; on convex solids without gaps.
  std::vector<Vector3> surface_points(int count) const;
  /// Edges, rims, and lines on the sides of cones and along the bodies of capsules.
  std::vector<SharpCurve> sharp_curves() const;
  Vector3 from_own_axes(const Vector3& point) const { return centre_ + rotation_ * point; }
  /// Distance of a point given in the solid's own axes about its centre.
  double own_distance(const Vector3& point) const;

 private:
  SolidShape() = default;
  enum class Form : std::uint8_t { box, cylinder, cone, capsule, torus, hull };
  struct Hull;

  void make(const Solid& solid);
  void make_hull(std::span<const Vector3> points);
  void add_rim(double height);
  Vector3 half_extent() const;  ///< in the solid's own axes, of forms that are round about their centre
  /// Whether the ellipsoid that makes a capsule or a torus is a ball.
  bool is_ball_swept() const { return half_.x() == half_.y() && half_.x() == half_.z(); }
  SolidPlace own_place(const Vector3& point) const;
  SolidPlace cylinder_place(const Vector3& point) const;
  SolidPlace cone_place(const Vector3& point) const;
  double torus_angle(const Vector3& point) const;
  Vector3 ring_point(double angle) const;

  Form form_ = Form::box;
  Vector3 centre_ = Vector3::Zero();
  Matrix3 rotation_ = Matrix3::Identity();
  /// Box: half sizes. Round forms: half axes of the cross-section, half height. Capsule and torus: half axes
  /// of the swept ball.
  Vector3 half_ = Vector3::Ones();
  double along_ = 0;                ///< capsule: half the length of the sweep
  Vector2 ring_ = Vector2::Zero();  ///< torus: half axes of the path of the sweep
  double reach_ = 0;
  std::vector<Vector3> extremes_, face_middles_;
  std::shared_ptr<const Hull> hull_;
};

/// Convex hull of a polyhedron, with planes: a point is inside where its height over every plane is at most
/// 0.
struct SolidShape::Hull {
  /// Side of a face, from a to b; `inwards` is its normal in the face's plane.
  struct Side {
    Vector3 a, b, inwards;
  };
  struct Face {
    Vector3 normal;
    double offset;
    std::size_t first_side, end_of_sides;
  };
  std::vector<Face> faces;
  std::vector<Side> sides;           ///< those of the first face, then of the second ...
  Vector3 middle = Vector3::Zero();  ///< an inner point

  /// Nearest point of a face to a point at this height over its plane.
  Vector3 nearest(const Face& face, const Vector3& point, double height) const;
};

}  // namespace hariko

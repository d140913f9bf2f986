#pragma once

// A solid in its place, ready for computing: unit frame, inside function, points to test (spec sections 1,
// 6).

#include <optional>
#include <span>
#include <vector>

#include "core/envelope/solid.hpp"

namespace hariko {

/// A point lies inside of the solid in its unit frame: x with every normal . x <= offset.
struct HalfSpace {
  Vector3 normal;
  double offset;
};

/// A line or a closed ellipse on the surface of a solid where it is sharp, or straight: what spread points
/// miss first. World.
struct SharpCurve {
  Vector3 base;                   ///< where a line begins; the centre of an ellipse
  Vector3 along;                  ///< to the line's end; to the ellipse's point of share 0
  std::optional<Vector3> across;  ///< of ellipses: to the point of share 1/4
  /// share: 0 .. 1 from end to end, or once round.
  Vector3 at(double share) const;
  /// Of ellipses a bound: no part is longer than its share of this.
  double length() const;
};

/// One centre of curvature: a capsule makes two of them. World points are centre + sigma A u for points u of
/// the unit frame, in which the solid's centroid is 0 and its sizes are equal.
class PlacedSolid {
 public:
  enum class Shape : std::uint8_t { half_spaces, ball, cylinder, cone, torus };

  Index owner = 0;         ///< number of the authored solid
  std::uint32_t id = 0;    ///< its stable name
  std::uint32_t part = 0;  ///< 1: the second ball of a capsule
  SolidKind kind = SolidKind::box;
  double roundness = 0.5;
  Vector3 centre = Vector3::Zero();
  Matrix3 to_world = Matrix3::Identity(), to_unit = Matrix3::Identity();
  Matrix3 rotation = Matrix3::Identity();  ///< of the solid's own axes
  double least_stretch = 1;                ///< smallest singular value of to_world
  double reach = 0;                        ///< no point is farther from the centre
  Vector3 body = Vector3::Zero();  ///< of one of a capsule's balls: from its centre to that of the other
  std::vector<Vector3> unit_vertices;
  std::vector<Vector3> test_points;  ///< world; on the solid's surface

  /// Positive inside, in units of the unit frame; times `least_stretch` a lower bound of the depth.
  double inside(const Vector3& unit) const;
  /// At least the depth at points inside, negative outside; length.
  double depth(const Vector3& world) const {
    const Vector3 offset = world - centre;
    if (offset.squaredNorm() > reach * reach) return -least_stretch;
    return inside(to_unit * offset) * least_stretch;
  }
  /// As `depth`, but between the balls of a capsule it is positive too.
  double depth_with_body(const Vector3& world) const;
  /// As `depth_with_body`, and outside it falls with the distance, without a step: for searches of what is
  /// between points.
  double level(const Vector3& world) const;
  Vector3 world(const Vector3& unit, double sigma = 1) const { return centre + to_world * (sigma * unit); }
  bool is_round() const { return shape_ == Shape::ball || shape_ == Shape::torus; }
  /// `count` points spread over the surface, of which convex solids have no empty parts.
  std::vector<Vector3> surface_points(int count) const;
  /// Edges, rims, and lines down the sides of cones and along the bodies of capsules.
  std::vector<SharpCurve> sharp_curves() const;

  Shape shape_ = Shape::half_spaces;
  std::vector<HalfSpace> half_spaces_;
  double tube_ = 0;  ///< torus: of the unit frame
};

/// Capsules become two, all others one; in the order of the solids. `input` passes `check_envelope`.
std::vector<PlacedSolid> place_solids(const EnvelopeInput& input);

/// Directions spread evenly over the sphere: unit vectors.
std::vector<Vector3> spread_directions(int count);

}  // namespace hariko

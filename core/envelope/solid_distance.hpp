#pragma once

// Signed distances to solids, and the rounded union of them (docs/envelope.md, spec 16.2).

#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/envelope/convex_hull.hpp"
#include "core/envelope/solid.hpp"

namespace hariko {

/// Negative inside. Exact outside; inside of polyhedra the largest plane value, which is a bound.
class SolidDistance {
 public:
  /// `clearance` is subtracted. Positions relative to `origin`.
  SolidDistance(const Solid& solid, double clearance, const Vector3& origin);
  /// A round bar between two points.
  static SolidDistance capsule(const Vector3& a, const Vector3& b, double radius);

  /// The same solid in a frame with these axes and origin.
  SolidDistance in_frame(const Matrix3& axes, const Vector3& origin) const;

  double operator()(const Vector3& point) const;
  /// Unit, away from the solid, by central differences.
  Vector3 gradient(const Vector3& point) const;
  /// Largest value of direction . x over the solid, without clearance.
  double support(const Vector3& direction) const;

  const Vector3& centre() const { return centre_; }
  const Matrix3& rotation() const { return rotation_; }
  double reach() const { return reach_; }          ///< no point of the solid is farther from the centre
  double thickness() const { return thickness_; }  ///< twice the smallest half size
  const Vector3& half() const { return half_; }

 private:
  SolidDistance() = default;
  double local(const Vector3& p) const;
  void make_hull(std::vector<Vector3> points);

  enum class Shape : std::uint8_t { box, ball, cylinder, cone, capsule, torus, hull };
  Shape shape_ = Shape::ball;
  Vector3 centre_ = Vector3::Zero();
  Matrix3 rotation_ = Matrix3::Identity();
  Vector3 half_ = Vector3::Ones();  ///< box: half sizes; round ones: radius, radius, half height
  double tube_ = 0, clearance_ = 0, reach_ = 0, thickness_ = 0;
  struct Hull {
    std::vector<Vector3> points;
    std::vector<std::array<Index, 3>> triangles;
    std::vector<Vector3> normals;
  };
  std::shared_ptr<const Hull> hull_;
};

/// The number of the first of the nearest solids, and how far it is; {0, 1e300} of none.
std::pair<Index, double> nearest_solid(std::span<const SolidDistance> solids, const Vector3& point);

/// Zero on a surface round the solids that fills their notches with fillets of radius `fillet`.
class UnionField {
 public:
  /// Of two solids, by their numbers, with the lower one first: their fillet's radius over that of the
  /// others.
  using Factors = std::map<std::pair<Index, Index>, double>;

  UnionField(std::vector<SolidDistance> solids, double fillet, Factors factors = {});

  /// Never above the least of the distances.
  double operator()(const Vector3& point) const;
  Vector3 gradient(const Vector3& point) const;
  /// -1 where it is negative in all of a ball, 1 where it is nowhere below `above`, 0 where that would take a
  /// closer look.
  int side(const Vector3& centre, double radius, double above = 0) const;
  /// Newton steps towards the zero, none longer than `step`.
  Vector3 projected(Vector3 point, int steps, double step) const;

 private:
  double fillet_of(Index a, Index b) const;

  std::vector<SolidDistance> solids_;
  double fillet_, largest_fillet_;
  Factors factors_;
};

}  // namespace hariko

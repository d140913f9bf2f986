#pragma once

// The ways from edges of the hull down into the notch between two solids (docs/envelope.md, spec 3.1b).

#include <span>
#include <vector>

#include "core/envelope/placed_solid.hpp"
#include "core/envelope/solid_distance.hpp"

namespace hariko {

/// Distances to the authored solids, clearance included, as the search for enclosure has grown them. A torus
/// is its hull.
class GrownSolids {
 public:
  /// `placed`: of the input, relative to `origin`.
  GrownSolids(const EnvelopeInput& input, std::span<const PlacedSolid> placed, const Vector3& origin);

  /// One factor a placed solid; parts of one solid grow by the largest of theirs.
  void grow(std::span<const PlacedSolid> placed, std::span<const double> sigma);

  Index count() const { return Index(distances_.size()); }
  double distance(Index solid, const Vector3& x) const;
  /// Unit, away from the solid.
  Vector3 gradient(Index solid, const Vector3& x) const;
  const Vector3& centre(Index solid) const { return distances_[solid].centre(); }

 private:
  Vector3 ungrown(Index solid, const Vector3& x) const;

  std::vector<SolidDistance> distances_;
  std::vector<double> sigma_;
};

/// A way along the surface of equal distances from two solids.
struct ValleyPath {
  enum class Stop : std::uint8_t { landed, third, open };
  std::vector<Vector3> points;   ///< the first one lies on the edge
  std::vector<Vector3> outward;  ///< unit, one a point: against the way
  Stop stop = Stop::open;
  Index third = no_index;  ///< the solid that stopped it
  double length = 0;
};

/// From the edge a-b, a on solid A and b on solid B, down to where both touch, a third solid is in the way,
/// or the solids face each other. At most 90 steps.
ValleyPath valley_path(const GrownSolids& solids, Index solid_a, Index solid_b, const Vector3& a,
                       const Vector3& b, double diagonal);

/// The point at a share of the way's length, and the direction outwards there.
std::pair<Vector3, Vector3> along(const ValleyPath& path, double share);

/// Where a ray from `from` first meets a solid other than the two; no_index where none is within `reach`.
struct RayHit {
  Index solid = no_index;
  Vector3 point = Vector3::Zero();
  double distance = 0;
};
RayHit hit_third_solid(const GrownSolids& solids, Index solid_a, Index solid_b, const Vector3& from,
                       const Vector3& direction, double reach, double diagonal);

}  // namespace hariko

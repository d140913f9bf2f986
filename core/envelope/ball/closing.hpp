#pragma once

// Closing by a rolling ball: signed distance of a point from the region that a ball reaches without touching
// a solid (docs/envelope.md).

#include "core/envelope/ball/grown_solids.hpp"

namespace hariko {

/// Value of the closing at a point.
struct ClosedDistance {
  double value = 0;                  ///< negative inside
  Vector3 centre = Vector3::Zero();  ///< centre of the ball nearest to the point
  bool crease = false;               ///< the nearest solid alone does not determine the value
};

/// Evaluates R - |x - y| for the nearest y with e(y) >= R, where e is the least distance to the grown solids
/// and R the ball's radius; e(x) where that is at least R. For any such y the value is at most the distance
/// of x from every solid, because distances are 1-Lipschitz: a search that ends early errs on the safe side
/// and fills more.
class Closing {
 public:
  /// Prepares the evaluation. `accuracy`: length to which values are computed.
  Closing(const GrownUnion& solids, double radius, double accuracy)
      : solids_(solids), radius_(radius), accuracy_(accuracy) {}

  double radius() const { return radius_; }
  /// Closing of the solids `among`, which must include all that a ball near x may touch. `start`: the centre
  /// of a ball near the solution, from which it is then found by local steps alone.
  ClosedDistance at(const Vector3& x, std::span<const Index> among, const Vector3* start = nullptr) const;
  /// Returns the better of `known` and the result from another start.
  ClosedDistance improved(const Vector3& x, const ClosedDistance& known, const Vector3& start,
                          std::span<const Index> among) const;

 private:
  struct Search;
  ClosedDistance search(const Vector3& x, const Vector3& start, std::span<const Index> among) const;

  const GrownUnion& solids_;
  double radius_, accuracy_;
};

}  // namespace hariko

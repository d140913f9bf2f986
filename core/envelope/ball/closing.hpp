#pragma once

// Closing by a rolling ball: how far a point is from what a ball that touches no solid can reach
// (docs/envelope.md).

#include "core/envelope/ball/grown_solids.hpp"

namespace hariko {

struct ClosedDistance {
  double value = 0;                  ///< negative inside
  Vector3 centre = Vector3::Zero();  ///< of the ball that is nearest to the point
  bool crease = false;               ///< the nearest solid alone does not decide
};

/// R - |x - y| for the nearest y with e(y) >= R, e the least distance to the grown solids, R the ball's
/// radius; e(x) where that is R at least. Whatever such y is found, the value is no larger than any solid's
/// distance at x, as distances change by no more than the way: a search that ends early errs on the safe
/// side, and fills more.
class Closing {
 public:
  /// `accuracy`: length to which values are sought.
  Closing(const GrownUnion& solids, double radius, double accuracy)
      : solids_(solids), radius_(radius), accuracy_(accuracy) {}

  double radius() const { return radius_; }
  /// The closing of solids `among`, which must have all that a ball near x may touch. `start`: the centre of
  /// a ball near the one that is sought, which is then found by steps from there alone.
  ClosedDistance at(const Vector3& x, std::span<const Index> among, const Vector3* start = nullptr) const;
  /// The better of `known` and what is found from another start.
  ClosedDistance improved(const Vector3& x, const ClosedDistance& known, const Vector3& start,
                          std::span<const Index> among) const;

 private:
  struct Search;
  ClosedDistance search(const Vector3& x, const Vector3& start, std::span<const Index> among) const;

  const GrownUnion& solids_;
  double radius_, accuracy_;
};

}  // namespace hariko

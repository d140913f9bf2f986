#pragma once

// Closing by a rolling ball: signed distance of a point from the region that a ball reaches without touching
// a solid (docs/envelope.md).

#include "core/base/equal_bits.hpp"
#include "core/base/index_list.hpp"
#include "core/envelope/ball/grown_solids.hpp"

namespace hariko {

/// Value of the closing at a point.
struct ClosedDistance {
  double value = 0;                  ///< negative inside
  Vector3 centre = Vector3::Zero();  ///< centre of the ball nearest to the point
  bool crease = false;               ///< the nearest solid alone does not determine the value
};

inline bool equal_bits(const ClosedDistance& a, const ClosedDistance& b) {
  return a.crease == b.crease && equal_bits(a.value, b.value) && equal_bits(a.centre, b.centre);
}

/// Part of space that a result depends on. A solid other than `blocker` does not change the result by being
/// farther from `about` than `reach`, wherever it is there.
struct ClosingReach {
  Vector3 about = Vector3::Zero();
  double reach = -1e300;     ///< by default the result depends on no solid
  Index blocker = no_index;  ///< a solid that the ball at the nearest solid penetrates

  /// Enlarges the ball to the smallest one that also holds another ball, of radius `within` about `other`.
  /// Radii may be negative: distances inside solids are.
  void include(const Vector3& other, double within);
};

/// Evaluates R - |x - y| for the nearest y with e(y) >= R, where e is the least distance to the grown solids
/// and R the ball's radius; e(x) where that is at least R. For any such y the value is at most the distance
/// of x from every solid, because distances are 1-Lipschitz: a search that ends early errs on the safe side
/// and fills more.
class Closing {
 public:
  /// Prepares the evaluation. `accuracy`: length to which values are computed.
  Closing(const GrownUnion& solids, double radius, double accuracy)
      : solids_(solids), radius_(radius), accuracy_(accuracy), all_(ascending_indices(solids.size())) {}

  double radius() const { return radius_; }
  /// Closing at x. `start`: the centre of a ball near the solution, from which it is then found by local
  /// steps alone, or, if `thorough`, also without it where these do not end. `reach`, if not null: receives
  /// what the result depends on.
  ClosedDistance at(const Vector3& x, const Vector3* start = nullptr, ClosingReach* reach = nullptr,
                    bool thorough = false) const;
  /// Returns the better of `known` and the result from another start. `reach` as above, `known` being given.
  ClosedDistance improved(const Vector3& x, const ClosedDistance& known, const Vector3& start,
                          ClosingReach* reach = nullptr) const;

 private:
  struct Search;

  const GrownUnion& solids_;
  double radius_, accuracy_;
  std::vector<Index> all_;  ///< numbers of all solids
};

/// Fraction of the radius by which the smallest ball reaches deeper than the largest in a slot, a place that
/// a smaller ball enters and a larger one does not. In the corner of a box it is 0.42.
inline constexpr double no_slot = 0.45;

/// Depth of a place in a slot, with the searches that tell.
struct SlotTest {
  double share = 0;  ///< 0 .. 1
  ClosingReach smaller, larger;
  bool known = false;
};

/// Tests a place at which the usual ball, whose radius is `radius`, has the value `here`.
SlotTest slot_test(const Closing& smaller, const Closing& larger, double radius, const Vector3& x,
                   const ClosedDistance& here);

}  // namespace hariko

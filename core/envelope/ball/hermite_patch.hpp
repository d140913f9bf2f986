#pragma once

// HermitePatch: Gregory patch with quintic sides and given fields of cross-boundary derivatives and
// curvatures (docs/envelope.md).

#include <array>
#include <span>
#include <vector>

#include "core/envelope/gregory.hpp"

namespace hariko {

/// Control points of a Bezier curve of degree 5, or of a vector field along one.
using Quintic = std::array<Vector3, 6>;

/// Value at t, bit-identical from either end; likewise `derivative_at`.
Vector3 value_at(const Quintic& curve, double t);
Vector3 derivative_at(const Quintic& curve, double t);
/// Same curve with the opposite direction.
Quintic reversed(const Quintic& curve);

/// Bicubically blended Coons patch with Gregory's variable twists. Sides c0 (v = 0) and c1 (v = 1) run with
/// u, e0 (u = 0) and e1 (u = 1) with v; `cross` are the derivatives by v, u, v, u along them.
struct HermitePatch {
  Quintic c0, e1, c1, e0;
  Quintic cross_c0, cross_e1, cross_c1, cross_e0;
  /// Polynomial added to the second derivative across side k at its fraction t, counter-clockwise, times 64
  /// t^3 (1 - t)^3. It changes no side, no tangent plane, and no second derivative at other sides.
  std::array<std::array<Vector3, 3>, 4> bend = {};

  HermitePatch() {
    for (auto& side : bend) side.fill(Vector3::Zero());
  }
  /// Makes a patch from four sides, counter-clockwise seen from outside, and the derivative fields into the
  /// patch along them. At corners the fields equal the derivatives of the neighbouring sides.
  static HermitePatch from_loop(const std::array<Quintic, 4>& sides, const std::array<Quintic, 4>& inwards);
};

class HermitePatchSet final : public gregory::GridPatchSet {
 public:
  explicit HermitePatchSet(std::vector<HermitePatch> patches) : patches_(std::move(patches)) {}

  Index patch_count() const override { return Index(patches_.size()); }
  PatchPoint evaluate(Index patch, const Vector2& parameter, Order order) const override;

 private:
  void for_grid(std::span<const Index> patches, const GridPattern& pattern, Order order,
                const EachPoint& each) const override;
  std::vector<HermitePatch> patches_;
};

/// Fractions of a side at which the second derivative across it is given.
inline constexpr std::array<double, 3> bend_places{0.2, 0.5, 0.8};
/// Second derivatives by v along the side v = 0 of a patch without bends, at these places.
std::array<Vector3, 3> seconds_across(const HermitePatch& patch);
/// Bend of a side that changes the second derivative across it by `changes` at these places.
std::array<Vector3, 3> bend_through(const std::array<Vector3, 3>& changes);

}  // namespace hariko

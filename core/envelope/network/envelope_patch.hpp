#pragma once

// EnvelopePatchSet: rational Gregory-Coons patches with derivative fields across their four sides
// (docs/envelope.md).

#include <optional>

#include "core/envelope/gregory.hpp"
#include "core/envelope/network/rational_curve.hpp"

namespace hariko {

/// Homogeneous patch S = H(u) . (e0, Eu0, Eu1, e1)(v) + H(v) . (c0, Cv0, Cv1, c1)(u) - H(u) M H(v) with
/// Gregory's variable twists. Sides c0 (v = 0) and c1 (v = 1) run with u, e0 (u = 0) and e1 (u = 1) with v.
struct EnvelopePatch {
  HomogeneousCubic c0, e1, c1, e0;
  HomogeneousSextic cross_c0, cross_e1, cross_c1, cross_e0;  ///< derivatives by v, u, v, u

  /// Makes a patch from the four sides of a loop, counter-clockwise seen from outside: each has its face to
  /// the left.
  static EnvelopePatch from_loop(const std::array<RibbonCurve, 4>& loop);
};

/// Part of an envelope patch over u0 .. u0 + size, v0 .. v0 + size.
struct EnvelopePart {
  Index patch = 0;
  double u0 = 0, v0 = 0, size = 1;
  /// Curves of its sides, bit-identical to the neighbours' reversed ones; nothing where a side lies inside
  /// the patch.
  std::array<std::optional<HomogeneousCubic>, 4> sides = {};
};

/// Parts of envelope patches on the unit square.
class EnvelopePatchSet final : public gregory::GridPatchSet {
 public:
  EnvelopePatchSet(std::vector<EnvelopePatch> patches, std::vector<EnvelopePart> parts);

  Index patch_count() const override { return Index(parts_.size()); }
  PatchPoint evaluate(Index patch, const Vector2& parameter, Order order) const override;
  /// Exact at corners of parts inside whole patches.
  CornerSecondOrder second_order_at_corner(Index patch, int corner) const override;

 private:
  void for_grid(std::span<const Index> patches, const GridPattern& pattern, Order order,
                const EachPoint& each) const override;
  std::vector<EnvelopePatch> patches_;
  std::vector<EnvelopePart> parts_;
};

}  // namespace hariko

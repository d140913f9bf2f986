#pragma once

// EnvelopePatchSet: rational Gregory-Coons patches with derivative fields across their four sides
// (docs/envelope.md).

#include <array>
#include <memory>
#include <vector>

#include "core/envelope/network/rational_curve.hpp"
#include "core/surface/surface.hpp"

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
};

/// Parts of envelope patches on the unit square.
class EnvelopePatchSet final : public PatchSet {
 public:
  /// Side of a part: its curve, bit-identical to the neighbour's reversed one; unused where the side lies
  /// inside a patch (`outer` false).
  struct Side {
    HomogeneousCubic curve;
    bool outer = false;
  };
  struct Part {
    EnvelopePart part;
    std::array<Side, 4> sides;
  };
  EnvelopePatchSet(std::vector<EnvelopePatch> patches, std::vector<Part> parts);

  const std::vector<EnvelopePatch>& whole_patches() const { return patches_; }
  const EnvelopePart& part(Index patch) const { return parts_[patch].part; }

  Domain domain() const override { return Domain::square; }
  Index patch_count() const override { return Index(parts_.size()); }
  PatchPoint evaluate(Index patch, const Vector2& parameter, Order order) const override;
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern, std::span<Vector3> positions,
                     std::span<Vector3> normals) const override;
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                     std::span<PatchPoint> points) const override;
  /// Undefined: Gregory's twists depend on the direction at the corners of whole patches.
  CornerSecondOrder second_order_at_corner(Index patch, int corner) const override;

 private:
  struct Frame;
  template <class Each>
  void for_grid(std::span<const Index> patches, const GridPattern& pattern, Order order,
                const Each& each) const;
  std::vector<EnvelopePatch> patches_;
  std::vector<Part> parts_;
};

}  // namespace hariko

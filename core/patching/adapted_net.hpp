#pragma once

// A net of bicubic patches that adapts: the second row of points behind its sides takes the tangent planes of
// the surfaces joined there (Kuriyama 1991, appendix 2, read the other way; kuriyama.md section 8).

#include <array>
#include <vector>

#include "core/base/message.hpp"
#include "core/g2/g2_patch_set.hpp"
#include "core/patching/quartic_patch.hpp"
#include "core/surface/bicubic_patch.hpp"

namespace hariko {

inline constexpr Code w_join_refused{"W_JOIN_REFUSED"};
inline constexpr Code w_join_kink{"W_JOIN_KINK"};

/// D(i,4-i,0) - D(i,3-i,1), i = 0 .. 3, along a patch's side, from its end to its start if `reversed`.
using CrossRow = std::array<Vector3, 4>;
CrossRow cross_row(const QuarticPatch& patch, bool reversed = false);
/// Along the outer side of a patch of a polyhedron's surface, whatever its mode. In mode G2 the quarter of
/// the ribbon's cross derivative, which must be cubic (`Join::patch_follows`), outwards.
CrossRow cross_row(const PatchSet& patches, Index patch, bool reversed = false);

/// A side whose row adapts. `row`: of the surface beyond it, in the side's own direction and the net's space.
struct AdaptingSide {
  NetSide side;
  CrossRow row;
};

struct AdaptedNet {
  BicubicNet net;
  /// One entry a side, in order: false where it was refused, since a point is claimed by two sides that want
  /// it in different places.
  std::vector<bool> adapted;
  /// One entry a side: it was accepted, but an inner side of the grid that ends on it, next to a side before
  /// it, was smooth and is no more.
  std::vector<bool> kinked;
};

/// The net with second rows P(i,1) = P(i,0) + (4 row_i - B_i) / (3 lambda), whose lambda > 0, l1, l2 bring
/// them nearest to where they were. Points of `held` sides stay: others are joined to their curves. Where the
/// net was smooth across an inner side that ends on an adapting one, the point beyond follows; between two
/// adapting sides it is theirs, and smoothness is one more condition. Where that has no solution (surfaces of
/// mode G2 always leave one) the inner side loses it. Sides are taken in order; one that has no solution
/// together with those before it is refused.
AdaptedNet adapted_net(const BicubicNet& net, const std::vector<AdaptingSide>& sides,
                       const std::vector<NetSide>& held = {});

}  // namespace hariko

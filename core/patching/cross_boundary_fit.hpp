#pragma once

// Adapted nets of bicubic patches: the second row of control points behind a side takes the tangent planes of
// the surface joined there (Kuriyama 1991, appendix 2, solved for the bicubic patch; kuriyama.md section 8).

#include <array>
#include <vector>

#include "core/base/message.hpp"
#include "core/surface/bicubic_patch.hpp"

namespace hariko {

inline constexpr Code w_join_refused{"W_JOIN_REFUSED"};
inline constexpr Code w_join_kink{"W_JOIN_KINK"};

/// Cross-boundary row D(i,4-i,0) - D(i,3-i,1), i = 0 .. 3, along a patch's side, from its end to its start if
/// `reversed`.
using CrossRow = std::array<Vector3, 4>;
/// Cross-boundary row along the outer side of a patch of a polyhedron's surface, in any mode. In mode G2 it
/// is a quarter of the ribbon's cross derivative, which must be cubic (`Join::patch_follows`), pointing
/// outwards.
CrossRow cross_row(const PatchSet& patches, Index patch, bool reversed = false);

/// Side whose second row adapts. `row`: cross-boundary row of the surface beyond it, in the side's own
/// direction and the net's space.
struct AdaptingSide {
  NetSide side;
  CrossRow row;
};

/// Net after adaptation, with the outcome per side.
struct AdaptedNet {
  BicubicNet net;
  /// Acceptance per side, in order: false where the side was refused, because it has no solution together
  /// with the earlier ones (as when two sides require different positions of a common point).
  std::vector<bool> adapted;
  /// Kinks per side: true where it was accepted, but an inner side of the grid that ends on it, next to an
  /// earlier side, was smooth and is no longer.
  std::vector<bool> kinked;
};

/// Adapts a net: second rows P(i,1) = P(i,0) + (4 row_i - B_i) / (3 lambda), with lambda > 0, l1, l2 that
/// keep them nearest to their former positions. Points of `held` sides stay, as other surfaces are joined to
/// their curves. Where the net was smooth across an inner side that ends on an adapting one, the point beyond
/// follows; between two adapting sides they determine it, and smoothness is one more condition. Where that
/// has no solution (surfaces of mode G2 always have one) the inner side loses its smoothness. Sides are taken
/// in order; a side that has no solution together with the earlier ones is refused.
AdaptedNet adapted_net(const BicubicNet& net, const std::vector<AdaptingSide>& sides,
                       const std::vector<NetSide>& held = {});

}  // namespace hariko

#pragma once

// Join: a border edge of a polyhedron's surface takes the curve, and optionally the tangent planes, of a side
// of a bicubic patch (Kuriyama 1991, appendix 2; kuriyama.md section 8).

#include <array>

#include "core/base/ids.hpp"
#include "core/base/message.hpp"
#include "core/base/vector.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

inline constexpr Code e_join_gap{"E_JOIN_GAP"};
inline constexpr Code e_join_degenerate{"E_JOIN_DEGENERATE"};
inline constexpr Code e_join_corner{"E_JOIN_CORNER"};
inline constexpr Code e_join_angle{"E_JOIN_ANGLE"};
inline constexpr Code e_join_twist{"E_JOIN_TWIST"};
inline constexpr Code e_join_pinned{"E_JOIN_PINNED"};
inline constexpr Code w_join_scale{"W_JOIN_SCALE"};

/// Join of a border edge, with the control points P(i, 0) and P(i, 1) of the bicubic patch, from the
/// half-edge's origin to its target, relative to the origin of the polyhedron's positions. With G0 only the
/// curve counts.
struct Join {
  Index half_edge = no_index;  ///< a border half-edge
  Continuity continuity = Continuity::g1;
  std::array<Vector3, 4> curve, row;
  /// With G0: the patch's second row will follow the surface. Mode G2 then keeps the cross derivative cubic
  /// along the edge, since a bicubic patch can follow no other.
  bool patch_follows = false;
  friend bool operator==(const Join&, const Join&) = default;
};

/// Tolerance to which sides must fit each other at a corner: positions relative to the size of the object,
/// tangents relative to their lengths, angles in radians, ratios relative.
inline constexpr double join_tolerance = 1e-9;

}  // namespace hariko

#pragma once

// A polygon that need not be planar, cut by diagonals: into triangles, or into convex pieces (kuriyama.md
// section 11).

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Whether two corners (numbers into `corners`) that are not neighbours may be joined by a diagonal. On a
/// manifold they may not where an edge joins them already.
using MayJoin = std::function<bool(Index, Index)>;

/// Polygons with more corners are not cut: the time is quadratic.
inline constexpr std::size_t largest_cut_polygon = 2000;

/// Triangles over the polygon's own corners, same orientation, corners - 2 of them. Ears are cut off in the
/// projection along the mean normal, the one with the best area / longest side^2 first. Where the projection
/// crosses itself no cut is right; then as few triangles as possible are turned over. None when `may_join`
/// leaves no way, or above the limit. O(n^2) expected.
std::optional<std::vector<std::array<Index, 3>>> triangles_of(std::span<const Vector3> corners,
                                                              const MayJoin& may_join);

/// The triangles joined over their longest diagonals first, as long as `classify_face` calls the pieces
/// convex (Hertel and Mehlhorn). Each piece lists its corners in order, the first piece holds corner 0. One
/// piece for a convex polygon; none when the projection crosses itself, when `may_join` leaves no way, or
/// above the limit.
std::optional<std::vector<std::vector<Index>>> convex_pieces(std::span<const Vector3> corners,
                                                             const MayJoin& may_join);

}  // namespace hariko

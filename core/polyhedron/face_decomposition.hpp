#pragma once

// Decomposition of a polygon that need not be planar, by diagonals: into triangles, or into convex pieces
// (kuriyama.md section 11).

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Predicate whether a diagonal may join two corners (numbers into `corners`) that are not neighbours. On a
/// manifold it may not where an edge joins them already.
using MayJoin = std::function<bool(Index, Index)>;

/// Limit of the number of corners: larger polygons are not cut, as the time is quadratic.
inline constexpr std::size_t largest_cut_polygon = 2000;

/// Triangulation over the polygon's own corners: corners - 2 triangles of the same orientation. Ears are cut
/// off in the projection along the mean normal, the one with the best area / longest side^2 first. Where the
/// projection crosses itself no triangulation is right; then as few triangles as possible are inverted.
/// Nothing when `may_join` allows no triangulation, or above the limit. O(n^2) expected.
std::optional<std::vector<std::array<Index, 3>>> triangles_of(std::span<const Vector3> corners,
                                                              const MayJoin& may_join);

/// Pieces of a triangulation by diagonals: joined across their longest diagonals first, as long as
/// `classify_face` calls them convex. Each piece lists its corners in order.
std::vector<std::vector<Index>> joined_to_convex(std::span<const Vector3> corners,
                                                 std::span<const std::array<Index, 3>> triangles);

/// Convex decomposition: the triangles joined across their longest diagonals first, as long as
/// `classify_face` calls the pieces convex (Hertel and Mehlhorn). Each piece lists its corners in order; the
/// first piece holds corner 0. One piece for a convex polygon; nothing when the projection crosses itself,
/// when `may_join` allows no triangulation, or above the limit.
std::optional<std::vector<std::vector<Index>>> convex_pieces(std::span<const Vector3> corners,
                                                             const MayJoin& may_join);

}  // namespace hariko

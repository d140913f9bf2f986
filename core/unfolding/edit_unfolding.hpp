#pragma once

// Manual edits of a paper model. Pure functions: each returns a changed copy.

#include "core/unfolding/unfolding.hpp"

namespace hariko {

inline constexpr Code e_edge_on_border{"E_EDGE_ON_BORDER"};
inline constexpr Code e_same_piece{"E_SAME_PIECE"};
inline constexpr Code e_already_folded{"E_ALREADY_FOLDED"};
inline constexpr Code e_already_cut{"E_ALREADY_CUT"};
inline constexpr Code e_inside_face{"E_INSIDE_FACE"};

/// Joins two pieces: the cut edge becomes a fold, and the smaller piece moves to the larger one. The result
/// may overlap; `overlaps_of` tells. Errors: E_EDGE_ON_BORDER, E_ALREADY_FOLDED, E_SAME_PIECE (another fold
/// would close a ring of facets). O(facets).
Result<Unfolding> join_at(const Unfolding& unfolding, Index edge);

/// Splits a piece: the fold becomes a cut, and both parts stay in place. Errors: E_EDGE_ON_BORDER,
/// E_ALREADY_CUT, E_INSIDE_FACE (flat faces stay whole). O(facets).
Result<Unfolding> split_at(const Unfolding& unfolding, Index edge);

/// Splits a piece and moves the smaller part to free room. Errors: those of `split_at`.
Result<Unfolding> split_aside(const Unfolding& unfolding, Index edge);

/// Moves a piece with its tabs to a page, shifted by `shift` (mm).
Unfolding move_piece(const Unfolding& unfolding, Index piece, Index page, const Vector2& shift);
/// Rotates a piece counter-clockwise by `angle` (radians) about the centre of its box.
Unfolding turn_piece(const Unfolding& unfolding, Index piece, double angle);
/// Rotates a piece by the least angle that makes its smallest box parallel to the page.
Unfolding straighten_piece(const Unfolding& unfolding, Index piece);

/// Chooses the side of a cut edge for its tab, or a strip instead. A tab that does not fit becomes a strip.
Unfolding choose_tab(const Unfolding& unfolding, Index edge, TabChoice choice);

/// Packs all pieces and strips anew.
Unfolding rearrange(const Unfolding& unfolding);

/// Divides a piece so that its parts fit the page; other pieces keep their folds and places.
Unfolding split_to_fit(const Unfolding& unfolding, Index piece);

/// Pairs of items that overlap on a page. Numbers below the facet count are facets; the others are tabs and
/// strips of joints (facet count + joint).
std::vector<std::pair<Index, Index>> overlaps_of(const Unfolding& unfolding);

/// Pieces that extend, with their tabs, beyond the margins. Ascending.
std::vector<Index> pieces_off_page(const Unfolding& unfolding);

}  // namespace hariko

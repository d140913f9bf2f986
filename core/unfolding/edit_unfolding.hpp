#pragma once

// What a designer does to a paper model by hand. Pure functions: each gives a changed copy.

#include "core/unfolding/unfolding.hpp"

namespace hariko {

inline constexpr Code e_edge_on_border{"E_EDGE_ON_BORDER"};
inline constexpr Code e_same_piece{"E_SAME_PIECE"};
inline constexpr Code e_already_folded{"E_ALREADY_FOLDED"};
inline constexpr Code e_already_cut{"E_ALREADY_CUT"};
inline constexpr Code e_inside_face{"E_INSIDE_FACE"};

/// The cut edge becomes a fold: the smaller piece moves to the larger one. It may overlap then;
/// `overlaps_of` tells. Errors: E_EDGE_ON_BORDER, E_ALREADY_FOLDED, E_SAME_PIECE (a fold more would close a
/// ring of facets). O(facets).
Result<Unfolding> join_at(const Unfolding& unfolding, Index edge);

/// The fold becomes a cut. Both parts stay where they are. Errors: E_EDGE_ON_BORDER, E_ALREADY_CUT,
/// E_INSIDE_FACE (flat faces stay whole).
Result<Unfolding> split_at(const Unfolding& unfolding, Index edge);

/// The same, and the smaller part goes where there is room for it. Errors: those of `split_at`.
Result<Unfolding> split_aside(const Unfolding& unfolding, Index edge);

/// The piece, with its tabs, on this page, shifted by `shift` (mm).
Unfolding move_piece(const Unfolding& unfolding, Index piece, Index page, const Vector2& shift);
/// Counter-clockwise by `angle` (radians) round the middle of its box.
Unfolding turn_piece(const Unfolding& unfolding, Index piece, double angle);
/// Turned the least so that its smallest box is parallel to the page.
Unfolding straighten_piece(const Unfolding& unfolding, Index piece);

/// Where the tab of a cut edge is, or a strip instead. What does not fit becomes a strip.
Unfolding choose_tab(const Unfolding& unfolding, Index edge, TabChoice choice);

/// All pieces and strips packed anew.
Unfolding rearrange(const Unfolding& unfolding);

/// Breaks the piece up so that its parts fit the page; other pieces keep their folds and places.
Unfolding split_to_fit(const Unfolding& unfolding, Index piece);

/// Other settings, the same cuts. Where lengths on paper change, all is packed anew. Errors: those of
/// `check_settings`.
Result<Unfolding> with_settings(const Unfolding& unfolding, const PaperSettings& settings);

/// Two things that overlap on a page. Facets are below the number of facets; the others are tabs and strips
/// of joints (facet count + joint).
std::vector<std::pair<Index, Index>> overlaps_of(const Unfolding& unfolding);

/// Pieces that, with their tabs, pass the margins. Ascending.
std::vector<Index> pieces_off_page(const Unfolding& unfolding);

}  // namespace hariko

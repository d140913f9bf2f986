#pragma once

// Unfolding: a paper model as a value: cut edges, pieces with their places on pages, tabs and joint strips.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/paper_model.hpp"
#include "core/unfolding/cuts/cut_search.hpp"
#include "core/unfolding/cuts/strip_runs.hpp"
#include "core/unfolding/glue_tabs.hpp"
#include "core/unfolding/pages/page_packer.hpp"
#include "core/unfolding/pages/piece_placement.hpp"

namespace hariko {

inline constexpr Code e_piece_too_large{"E_PIECE_TOO_LARGE"};
inline constexpr Code w_unfolding_overlaps{"W_UNFOLDING_OVERLAPS"};
inline constexpr Code w_paper_size{"W_PAPER_SIZE"};
/// Range of a paper model's longest extent that is plausible, mm.
inline constexpr double smallest_paper_model = 10, largest_paper_model = 2000;

/// Piece of a paper model.
struct PaperPiece {
  std::vector<Index> facets;  ///< root first, which has the lowest number; parents before children
  PiecePlacement placement;   ///< places the frame in which the root lies as in `facet_shapes`
};

/// Paper model: the designer's decisions (settings, folds, wishes, choices of tabs, placements) and
/// everything derived from them. Immutable by convention: the functions of edit_unfolding.hpp return changed
/// copies. Joints are numbered from 1 in their order.
struct Unfolding {
  std::shared_ptr<const FacetGraph> graph;
  PaperSettings settings;
  Folds folds;                         ///< by edge
  EdgeRules wishes;                    ///< by edge: cuts and folds that the designer chose
  std::vector<TabChoice> tab_choices;  ///< by edge
  std::vector<PaperPiece> pieces;
  std::vector<Index> piece_of;        ///< by facet
  std::vector<FacetCorners> corners;  ///< by facet: mm on the page of its piece
  std::vector<Joint> joints;          ///< tabs: mm on the page of the facet's piece
  /// Place of each joint's strip; meaningless where the joint has a tab.
  std::vector<PiecePlacement> strips;
  std::vector<StripRun> strip_runs;  ///< strips of a run are packed end to end, as one
  std::vector<Index> run_of;         ///< by joint; no_index where it has a tab
  Index page_count = 0;

  Index page_of(Index facet) const { return pieces[piece_of[facet]].placement.page; }
  /// Joint at an edge; no_index where the edge is folded or a border. O(log joints).
  Index joint_at(Index edge) const;
};

/// Rectangle of the strip of a joint without a tab, mm on its page, counter-clockwise; its centre line, the
/// fold, runs from between the last and the first corner to between the second and the third.
std::array<Vector2, 4> strip_corners(const Unfolding& unfolding, Index joint);

/// All printed shapes, as convex polygons on pages: facets by number, then the tab or the strip of each
/// joint.
std::vector<SheetPolygon> printed_polygons(const Unfolding& unfolding);

/// Penetration that counts as touching on these pages, mm.
double paper_tolerance(const Unfolding& unfolding);

/// Name of a piece: A .. Z, AA, AB ...
std::string piece_name(Index piece);

/// Ratio of the area of all facets to the printable area of all pages; 0 without pages.
double paper_use(const Unfolding& unfolding);
/// Joint whose number is printed at a joint: its own, or the first one of its run.
Index numbered_as(const Unfolding& unfolding, Index joint);
/// Whether the strips of two joints lie end to end, the second after the first.
bool follows(const Unfolding& unfolding, Index first, Index second);

/// Number of joints without a tab.
std::size_t strip_count(const Unfolding& unfolding);

/// Methods of choosing cuts.
enum class CutMethod {
  search,
  reference  ///< the published method, which leaves overlaps (reference_method.hpp)
};

/// Goal, method and constraints of an unfolding.
struct UnfoldOptions {
  CutGoal goal = CutGoal::fewest;
  CutMethod method = CutMethod::search;
  std::uint64_t steps = 300'000;  ///< budget of the search
  EdgeRules wishes = {};          ///< cuts and folds to keep, one for each edge; empty: none
};

/// Unfolds a mesh: chooses cuts, tabs and places. Deterministic: depends on the arguments alone. Errors:
/// those of `check_settings`, E_CANCELLED.
Result<Unfolding> unfold(std::shared_ptr<const FacetGraph> graph, const PaperSettings& settings,
                         const UnfoldOptions& options, const CancelToken& cancel = {},
                         const Progress& progress = {});

/// Messages to read before printing: W_PAPER_SIZE for a model smaller than 10 mm or larger than 2 m;
/// E_PIECE_TOO_LARGE for pieces that fit between the margins in no rotation, with the scale at which they
/// would; W_UNFOLDING_OVERLAPS.
std::vector<Message> unfolding_messages(const Unfolding& unfolding);

/// Scale factor, at most 1, at which every piece fits the page. O(facets).
double fitting_factor(const Unfolding& unfolding);

/// Places that are already known.
struct KnownPlaces {
  /// Place of the piece with this facet; `corners` are the facet's in the frame of the piece.
  std::function<std::optional<PiecePlacement>(Index facet, const FacetCorners& corners)> piece;
  /// Place of the strip of a joint.
  std::function<std::optional<PiecePlacement>(const FacetEdge& edge)> strip;
};

/// Paper model for given folds, which must form a forest (asserted). Finds tabs, and packs everything without
/// a known place, behind the rest where some places are known.
Unfolding assemble(std::shared_ptr<const FacetGraph> graph, const PaperSettings& settings, Folds folds,
                   EdgeRules wishes, std::vector<TabChoice> tab_choices, const KnownPlaces& known = {});

}  // namespace hariko

#pragma once

// Unfolding: a paper model as a value. Which edges are cut, the pieces with their places on pages, tabs and
// joint strips.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/paper_model.hpp"
#include "core/unfolding/cut_search.hpp"
#include "core/unfolding/glue_tabs.hpp"
#include "core/unfolding/page_packer.hpp"
#include "core/unfolding/piece_placement.hpp"
#include "core/unfolding/strip_runs.hpp"

namespace hariko {

inline constexpr Code e_piece_too_large{"E_PIECE_TOO_LARGE"};
inline constexpr Code w_unfolding_overlaps{"W_UNFOLDING_OVERLAPS"};
inline constexpr Code w_paper_size{"W_PAPER_SIZE"};
/// Longest extents of paper models that are likely to be meant, mm.
inline constexpr double smallest_paper_model = 10, largest_paper_model = 2000;

struct PaperPiece {
  std::vector<Index> facets;  ///< the root, which is the lowest, first; parents before children
  PiecePlacement placement;   ///< of the frame in which the root lies as in `facet_shapes`
};

/// What the designer decided (settings, folds, wishes, choices of tabs, placements) and what follows from it.
/// Immutable by custom: the functions of edit_unfolding.hpp give changed copies. Joints are numbered from 1
/// in their order.
struct Unfolding {
  std::shared_ptr<const FacetGraph> graph;
  PaperSettings settings;
  Folds folds;                         ///< of each edge
  EdgeRules wishes;                    ///< of each edge: cuts and folds that the designer chose
  std::vector<TabChoice> tab_choices;  ///< of each edge
  std::vector<PaperPiece> pieces;
  std::vector<Index> piece_of;        ///< of each facet
  std::vector<FacetCorners> corners;  ///< of each facet: mm on the page of its piece
  std::vector<Joint> joints;          ///< tabs: mm on the page of the facet's piece
  std::vector<PiecePlacement>
      strips;  ///< of each joint: where its strip lies; means nothing where it has a tab
  std::vector<StripRun> strip_runs;  ///< strips of a run are packed end to end, as one
  std::vector<Index> run_of;         ///< of each joint; no_index where it has a tab
  Index page_count = 0;

  Index page_of(Index facet) const { return pieces[piece_of[facet]].placement.page; }
  /// The joint at an edge; no_index where the edge is folded or a border. O(log joints).
  Index joint_at(Index edge) const;
};

/// The rectangle of a joint without a tab, mm on its page, counter-clockwise; the fold runs along its middle
/// from between the last and the first corner to between the second and the third.
std::array<Vector2, 4> strip_corners(const Unfolding& unfolding, Index joint);

/// All that is printed, as convex polygons on pages: facets by number, then the tab or the strip of each
/// joint.
std::vector<SheetPolygon> printed_polygons(const Unfolding& unfolding);

/// What counts as touching on these pages, in mm.
double paper_tolerance(const Unfolding& unfolding);

/// Letters that name a piece: A .. Z, AA, AB ...
std::string piece_name(Index piece);

/// Area of all facets over the printable area of all pages; 0 without pages.
double paper_use(const Unfolding& unfolding);
/// The joint whose number stands at a joint: its own, or the first one of its run.
Index numbered_as(const Unfolding& unfolding, Index joint);
/// The strips of the two joints lie end to end, the second behind the first.
bool follows(const Unfolding& unfolding, Index first, Index second);

/// Number of joints without a tab.
std::size_t strip_count(const Unfolding& unfolding);

enum class CutMethod {
  search,
  reference  ///< the paper's own, which leaves overlaps (reference_method.hpp)
};

struct UnfoldOptions {
  CutGoal goal = CutGoal::fewest;
  CutMethod method = CutMethod::search;
  std::uint64_t steps = 300'000;  ///< of the search
  EdgeRules wishes = {};          ///< cuts and folds to keep, one for each edge; empty: none
};

/// Chooses cuts, tabs and places. A function of its arguments alone: the same input gives the same sheet.
/// Errors: those of `check_settings`, E_CANCELLED.
Result<Unfolding> unfold(std::shared_ptr<const FacetGraph> graph, const PaperSettings& settings,
                         const UnfoldOptions& options, const CancelToken& cancel = {},
                         const Progress& progress = {});

/// Messages to read before it is printed: W_PAPER_SIZE for a model smaller than 10 mm or larger than 2 m;
/// E_PIECE_TOO_LARGE for pieces that no turn puts between the
/// margins, with the scale that would; W_UNFOLDING_OVERLAPS.
std::vector<Message> unfolding_messages(const Unfolding& unfolding);

/// By how much all would have to be scaled, at most 1, so that every piece fits the page. O(facets).
double fitting_factor(const Unfolding& unfolding);

/// Where things lie already.
struct KnownPlaces {
  /// Of the piece with this facet, whose corners in the frame of the piece are given.
  std::function<std::optional<PiecePlacement>(Index facet, const FacetCorners& corners)> piece;
  /// Of the strip of a joint.
  std::function<std::optional<PiecePlacement>(const FacetEdge& edge)> strip;
};

/// The value for given folds (a forest): tabs are found, and what has no place is packed, after all else
/// where some places are known. Programmer's error: folds with cycles.
Unfolding assemble(std::shared_ptr<const FacetGraph> graph, const PaperSettings& settings, Folds folds,
                   EdgeRules wishes, std::vector<TabChoice> tab_choices, const KnownPlaces& known = {});

}  // namespace hariko

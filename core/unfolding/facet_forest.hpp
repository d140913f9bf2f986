#pragma once

// FacetForest: pieces while a search grows, joins and breaks them. No two facets of a piece overlap, ever.
// Internal to core/unfolding.

#include <optional>
#include <vector>

#include "core/unfolding/facet_grid.hpp"
#include "core/unfolding/facet_layout.hpp"
#include "core/unfolding/piece_extent.hpp"

namespace hariko {

/// What a search may do with an edge.
enum class EdgeRule : std::uint8_t {
  free,
  folded,  ///< always; the facets that such edges join move as one
  cut      ///< always
};

/// One for each edge; empty means that all are free. Folded edges form a forest.
using EdgeRules = std::vector<EdgeRule>;

/// A facet and where it is going to lie.
struct FacetMove {
  Index facet = no_index, parent_side = no_index;
  FacetCorners corners;
};

class FacetForest {
 public:
  /// `tolerance` in the unit of the shapes. Where `room` is given, pieces stay within it when turned. Borrows
  /// graph, shapes and rules.
  FacetForest(const FacetGraph& graph, const std::vector<FacetCorners>& shapes, const EdgeRules& rules,
              double tolerance, std::optional<PaperSize> room);

  const FacetGraph& graph() const { return *graph_; }
  bool placed(Index facet) const { return piece_[facet] != no_index; }
  Index piece(Index facet) const { return piece_[facet]; }
  /// The side towards the parent; no_index for roots and facets that are not placed.
  Index parent_side(Index facet) const { return parent_side_[facet]; }
  const FacetCorners& corners(Index facet) const { return corners_[facet]; }
  /// Pieces are numbered from 0; some may be empty.
  std::size_t piece_slots() const { return members_.size(); }
  const std::vector<Index>& members(Index piece) const { return members_[piece]; }
  std::size_t piece_count() const;

  EdgeRule rule(Index edge) const { return rules_->empty() ? EdgeRule::free : (*rules_)[edge]; }
  /// The neighbour across a side, where there is one and the edge need not be cut; else no_index.
  Index reachable(Index facet, Index side) const {
    return rule(graph_->edge_at(facet, side)) == EdgeRule::cut ? no_index : graph_->neighbour(facet, side);
  }

  /// A new piece of one facet and what always moves with it.
  Index plant(Index facet);
  /// Where the neighbour across a side of a placed facet would lie, and then what always moves with it.
  void find_moves(Index facet, Index side, std::vector<FacetMove>& out) const;
  bool fits(Index piece, const std::vector<FacetMove>& moves) const;
  /// Whether no facet of the piece overlaps the corners.
  bool is_free(Index piece, const FacetCorners& corners) const;
  bool is_free(Index piece, const std::vector<FacetMove>& moves) const;
  /// Appends the facets of the piece that overlap the corners.
  void find_overlapped(Index piece, const FacetCorners& corners, std::vector<Index>& out) const;
  /// Adds facets that are not placed to the piece; moves of find_moves that are free.
  void attach(Index piece, const std::vector<FacetMove>& moves);
  /// Takes a facet away; its children must be taken too, by the caller.
  void detach(Index facet);
  /// After facets were detached: what the piece covers now. O(piece).
  void shrink_extent(Index piece);

  /// Moves the whole smaller piece over to the larger one across the edge; false when they would overlap or
  /// not fit, and nothing is changed then. The facets at the edge are in different pieces.
  bool join(Index edge);

  /// Calls visit(child) for the children of a placed facet.
  template <class Visit>
  void for_each_child(Index facet, Visit&& visit) const {
    for (Index side = 0; side < 3; ++side) {
      const Index next = graph_->neighbour(facet, side);
      if (next != no_index && side != parent_side_[facet] && placed(next) &&
          parent_side_[next] == graph_->mate_side(facet, side))
        visit(next);
    }
  }

  Folds folds() const;

 private:
  void put(Index piece, const FacetMove& move);
  /// Appends what always moves with moves[k], for all k.
  void add_followers(std::vector<FacetMove>& moves) const;

  const FacetGraph* graph_;
  const std::vector<FacetCorners>* shapes_;
  const EdgeRules* rules_;
  double tolerance_;
  std::optional<PaperSize> room_;
  FacetGrid grid_;
  std::vector<Index> piece_, parent_side_, place_;  ///< place in the list of members
  std::vector<FacetCorners> corners_;
  std::vector<std::vector<Index>> members_;
  std::vector<PieceExtent> extents_;
};

}  // namespace hariko

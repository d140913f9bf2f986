#pragma once

// FacetForest: pieces of an unfolding during a search that grows, joins and divides them. Invariant: no two
// facets of a piece overlap. Internal to core/unfolding.

#include <optional>
#include <vector>

#include "core/unfolding/cuts/facet_grid.hpp"
#include "core/unfolding/cuts/facet_layout.hpp"
#include "core/unfolding/pages/piece_extent.hpp"

namespace hariko {

/// Constraint of a search on an edge.
enum class EdgeRule : std::uint8_t {
  free,
  folded,  ///< always folded; the facets that such edges join move as one
  cut      ///< always cut
};

/// Constraints, one for each edge; empty means that all are free. Folded edges must form a forest.
using EdgeRules = std::vector<EdgeRule>;

/// Facet with its new position.
struct FacetMove {
  Index facet = no_index, parent_side = no_index;
  FacetCorners corners;
};

/// Pieces as trees of facets, with their positions in the plane.
class FacetForest {
 public:
  /// Empty forest. `tolerance` in the unit of the shapes. With `room`, every piece fits it in some rotation.
  /// Borrows graph, shapes and rules.
  FacetForest(const FacetGraph& graph, const std::vector<FacetCorners>& shapes, const EdgeRules& rules,
              double tolerance, std::optional<PaperSize> room);

  const FacetGraph& graph() const { return *graph_; }
  bool placed(Index facet) const { return piece_[facet] != no_index; }
  Index piece(Index facet) const { return piece_[facet]; }
  /// Side towards the parent; no_index for roots and facets that are not placed.
  Index parent_side(Index facet) const { return parent_side_[facet]; }
  const FacetCorners& corners(Index facet) const { return corners_[facet]; }
  /// Upper bound of piece numbers, which begin at 0; some pieces may be empty.
  std::size_t piece_slots() const { return members_.size(); }
  const std::vector<Index>& members(Index piece) const { return members_[piece]; }
  /// Number of pieces that are not empty. O(pieces).
  std::size_t piece_count() const;

  /// Constraint on an edge.
  EdgeRule rule(Index edge) const { return rules_->empty() ? EdgeRule::free : (*rules_)[edge]; }
  /// Neighbour across a side; no_index where there is none or the edge must be cut.
  Index reachable(Index facet, Index side) const {
    return rule(graph_->edge_at(facet, side)) == EdgeRule::cut ? no_index : graph_->neighbour(facet, side);
  }

  /// Starts a piece from one facet and those that always move with it.
  Index plant(Index facet);
  /// Appends the position of the neighbour across a side of a placed facet, and those of the facets that
  /// always move with it.
  void find_moves(Index facet, Index side, std::vector<FacetMove>& out) const;
  /// Whether the piece, with these moves, fits the room.
  bool fits(Index piece, const std::vector<FacetMove>& moves) const;
  /// Whether the corners overlap no facet of the piece.
  bool is_free(Index piece, const FacetCorners& corners) const;
  /// Whether none of the moves overlaps a facet of the piece.
  bool is_free(Index piece, const std::vector<FacetMove>& moves) const;
  /// Appends the facets of the piece that overlap the corners.
  void find_overlapped(Index piece, const FacetCorners& corners, std::vector<Index>& out) const;
  /// Adds facets to the piece by moves of `find_moves` that are free; the facets must not be placed.
  void attach(Index piece, const std::vector<FacetMove>& moves);
  /// Removes a facet; the caller must remove its children too.
  void detach(Index facet);
  /// Recomputes the extent of a piece after facets were detached. O(piece).
  void shrink_extent(Index piece);

  /// Joins two pieces across an edge by moving the smaller one. False, without a change, where they would
  /// overlap or not fit. The facets at the edge must be in different pieces.
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

  /// Folds of the present pieces. O(facets).
  Folds folds() const;

 private:
  void put(Index piece, const FacetMove& move);
  /// Appends the facets that always move with moves[k], for all k.
  void add_followers(std::vector<FacetMove>& moves) const;

  const FacetGraph* graph_;
  const std::vector<FacetCorners>* shapes_;
  const EdgeRules* rules_;
  double tolerance_;
  std::optional<PaperSize> room_;
  FacetGrid grid_;
  std::vector<Index> piece_, parent_side_, place_;  ///< `place_`: position in the list of members
  std::vector<FacetCorners> corners_;
  std::vector<std::vector<Index>> members_;
  std::vector<PieceExtent> extents_;
};

}  // namespace hariko

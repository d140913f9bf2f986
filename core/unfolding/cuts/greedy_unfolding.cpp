#include "core/unfolding/cuts/greedy_unfolding.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "core/base/index_list.hpp"
#include "core/unfolding/cuts/random_sequence.hpp"

namespace hariko {

namespace {

/// Candidate side of a placed facet over which the piece may grow.
struct Offer {
  double rank = 0;  ///< lowest first
  std::uint64_t number = 0;
  Index facet = 0, side = 0;
  friend bool operator>(const Offer& a, const Offer& b) {
    return std::tie(a.rank, a.number) > std::tie(b.rank, b.number);
  }
};

class Grower {
 public:
  Grower(FacetForest& forest, const Growth& growth)
      : forest_(forest), order_(growth.order), random_(growth.seed) {}

  Index first_facet(Index count) { return static_cast<Index>(random_.below(count)); }
  void grow_from(Index root, const CancelToken& cancel) {
    offers_ = {};
    const Index piece = forest_.plant(root);
    centre_ = middle(forest_.corners(root));
    for (const Index facet : forest_.members(piece)) offer_sides(facet);
    while (!offers_.empty() && !cancel.cancelled()) {
      const Offer offer = offers_.top();
      offers_.pop();
      const Index next = forest_.graph().neighbour(offer.facet, offer.side);
      if (forest_.placed(next)) continue;
      forest_.find_moves(offer.facet, offer.side, moves_);
      if (!forest_.is_free(piece, moves_) || !forest_.fits(piece, moves_)) continue;
      forest_.attach(piece, moves_);
      for (const FacetMove& move : moves_) offer_sides(move.facet);
    }
  }

 private:
  static Vector2 middle(const FacetCorners& corners) { return (corners[0] + corners[1] + corners[2]) / 3; }

  double rank(Index facet, Index side) {
    const FacetEdge& edge = forest_.graph().edge(forest_.graph().edge_at(facet, side));
    switch (order_) {
      case GrowthOrder::long_edges:
        return -edge.length;
      case GrowthOrder::flat_edges:
        return std::abs(edge.fold_angle);
      case GrowthOrder::round:
        forest_.find_moves(facet, side, moves_);
        return (middle(moves_.front().corners) - centre_).norm();
      case GrowthOrder::shuffled:
        return random_.unit();
      case GrowthOrder::first_come:
        break;
    }
    return 0;
  }
  void offer_sides(Index facet) {
    for (Index side = 0; side < 3; ++side) {
      const Index next = forest_.reachable(facet, side);
      if (next != no_index && !forest_.placed(next))
        offers_.push({rank(facet, side), ++number_, facet, side});
    }
  }

  FacetForest& forest_;
  GrowthOrder order_;
  RandomSequence random_;
  std::vector<FacetMove> moves_;
  Vector2 centre_ = Vector2::Zero();
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers_;
  std::uint64_t number_ = 0;
};

std::vector<Index> edges_in_order(const FacetGraph& graph, const Growth& growth) {
  RandomSequence random(growth.seed);
  std::vector<double> rank(graph.edge_count(), 0);
  for (Index e = 0; e < rank.size(); ++e) {
    if (growth.order == GrowthOrder::long_edges) rank[e] = -graph.edge(e).length;
    if (growth.order == GrowthOrder::flat_edges) rank[e] = std::abs(graph.edge(e).fold_angle);
    if (growth.order == GrowthOrder::shuffled) rank[e] = random.unit();
  }
  return stable_order(rank.size(), [&](Index a, Index b) { return rank[a] < rank[b]; });
}

}  // namespace

void grow(FacetForest& forest, const Growth& growth, const CancelToken& cancel) {
  const auto count = static_cast<Index>(forest.graph().facet_count());
  Grower grower(forest, growth);
  const Index first = growth.seed == 0 ? 0 : grower.first_facet(count);
  for (Index k = 0; k < count && !cancel.cancelled(); ++k) {
    const Index facet = (first + k) % count;
    if (!forest.placed(facet)) grower.grow_from(facet, cancel);
  }
}

void gather(FacetForest& forest, const Growth& growth, const CancelToken& cancel) {
  for (Index facet = 0; facet < forest.graph().facet_count(); ++facet)
    if (!forest.placed(facet)) forest.plant(facet);
  join_pieces(forest, growth, cancel);
}

void join_pieces(FacetForest& forest, const Growth& growth, const CancelToken& cancel) {
  const std::vector<Index> order = edges_in_order(forest.graph(), growth);
  for (bool joined = true; joined && !cancel.cancelled();) {
    joined = false;
    for (const Index e : order) {
      const FacetEdge& edge = forest.graph().edge(e);
      if (edge.border() || forest.rule(e) == EdgeRule::cut ||
          forest.piece(edge.facets[0]) == forest.piece(edge.facets[1]))
        continue;
      if (cancel.cancelled()) return;
      joined = forest.join(e) || joined;
    }
  }
}

}  // namespace hariko

#include "core/unfolding/cuts/ejection_chain.hpp"

#include <algorithm>

#include "core/unfolding/cuts/greedy_unfolding.hpp"
#include "core/unfolding/cuts/random_sequence.hpp"

namespace hariko {

namespace {

constexpr int looked_at = 4;  ///< facets of the pool that compete for a step
constexpr std::uint64_t tabu_steps = 20;
constexpr double tabu_penalty = 10, noise = 0.5;

class Eliminator {
 public:
  Eliminator(FacetForest& forest, std::uint64_t seed)
      : forest_(forest),
        random_(seed),
        weight_(forest.graph().facet_count(), 1),
        placed_at_(forest.graph().facet_count(), 0),
        seen_(forest.graph().facet_count(), 0),
        pool_place_(forest.graph().facet_count(), no_index),
        stale_(forest.piece_slots(), 0) {}

  /// Removes a piece by placing its facets elsewhere. False where `steps` did not suffice; the forest then
  /// lacks some facets.
  bool eliminate(Index piece, std::uint64_t& steps, const CancelToken& cancel,
                 const std::function<void()>& tick) {
    const std::vector<Index> members = forest_.members(piece);
    for (const Index facet : members) eject(facet);
    best_ = option_ = {};
    while (!pool_.empty()) {
      if (steps == 0 || cancel.cancelled()) return false;
      --steps;
      ++now_;
      if (now_ % 256 == 0) tick();
      const Index facet = choose();
      if (facet == no_index) return false;
      place(facet);
    }
    for (Index each = 0; each < stale_.size(); ++each)
      if (stale_[each]) refresh(each);
    return true;
  }

 private:
  struct Option {
    Index from = no_index;  ///< neighbour that is placed
    std::vector<FacetMove> moves;
    double cost = 0;
    std::vector<Index> ejected;
  };

  void eject(Index facet) {
    forest_.detach(facet);
    pool_place_[facet] = static_cast<Index>(pool_.size());
    pool_.push_back(facet);
  }
  void leave_pool(Index facet) {
    pool_[pool_place_[facet]] = pool_.back();
    pool_place_[pool_.back()] = pool_place_[facet];
    pool_.pop_back();
    pool_place_[facet] = no_index;
  }
  bool ready(Index facet) const {
    for (Index side = 0; side < 3; ++side) {
      const Index next = forest_.reachable(facet, side);
      if (next != no_index && forest_.placed(next)) return true;
    }
    return false;
  }

  /// Heaviest of a few random facets that have a placed neighbour.
  Index choose() {
    Index best = no_index;
    for (int tries = 0, found = 0; tries < 4 * looked_at && found < looked_at; ++tries) {
      const Index facet = pool_[random_.below(pool_.size())];
      if (!ready(facet)) continue;
      ++found;
      if (best == no_index || weight_[facet] > weight_[best]) best = facet;
    }
    if (best != no_index) return best;
    const auto found = std::find_if(pool_.begin(), pool_.end(), [&](Index facet) { return ready(facet); });
    return found == pool_.end() ? no_index : *found;
  }

  /// Places a facet beside the neighbour where that ejects the least weight. A facet that fits nowhere stays
  /// in the pool.
  void place(Index facet) {
    best_.from = no_index;
    for (Index own_side = 0; own_side < 3; ++own_side) {
      const Index from = forest_.reachable(facet, own_side);
      if (from != no_index && forest_.placed(from)) weigh(from, forest_.graph().mate_side(facet, own_side));
    }
    weight_[facet] += 1;
    if (best_.from == no_index) return;
    const Index piece = forest_.piece(best_.from);
    for (const Index other : best_.ejected) eject(other);
    if (!best_.ejected.empty()) stale_[piece] = 1;
    for (const FacetMove& move : best_.moves) {
      leave_pool(move.facet);
      placed_at_[move.facet] = now_;
    }
    forest_.attach(piece, best_.moves);
  }

  /// Whether the piece fits with the moves of `option_`. Its extent is recomputed after it lost facets only
  /// where the old extent does not fit.
  bool fits(Index piece) {
    if (forest_.fits(piece, option_.moves)) return true;
    if (!stale_[piece]) return false;
    refresh(piece);
    return forest_.fits(piece, option_.moves);
  }
  void refresh(Index piece) {
    stale_[piece] = 0;
    forest_.shrink_extent(piece);
  }

  void weigh(Index from, Index side) {
    option_.from = from;
    option_.ejected.clear();
    option_.cost = noise * random_.unit();
    forest_.find_moves(from, side, option_.moves);
    const Index piece = forest_.piece(from);
    if (!fits(piece)) return;
    overlapped_.clear();
    for (const FacetMove& move : option_.moves) forest_.find_overlapped(piece, move.corners, overlapped_);
    ++stamp_;
    for (const Index other : overlapped_)
      if (!add_subtree(top_of_group(other))) return;
    if (best_.from == no_index || option_.cost < best_.cost) std::swap(best_, option_);
  }

  /// Root of the group of facets that move as one with this facet.
  Index top_of_group(Index facet) const {
    const FacetGraph& graph = forest_.graph();
    for (Index side = forest_.parent_side(facet);
         side != no_index && forest_.rule(graph.edge_at(facet, side)) == EdgeRule::folded;
         side = forest_.parent_side(facet))
      facet = graph.neighbour(facet, side);
    return facet;
  }

  /// Adds a facet with its subtree to the ejected ones. False where the new facet itself belongs to that
  /// subtree, or where the cost exceeds that of the best option.
  bool add_subtree(Index top) {
    if (seen_[top] == stamp_) return true;
    std::size_t done = option_.ejected.size();
    seen_[top] = stamp_;
    option_.ejected.push_back(top);
    for (; done < option_.ejected.size(); ++done) {
      const Index facet = option_.ejected[done];
      if (facet == option_.from) return false;
      option_.cost += weight_[facet];
      if (placed_at_[facet] + tabu_steps > now_ && placed_at_[facet] != 0) option_.cost += tabu_penalty;
      if (best_.from != no_index && option_.cost >= best_.cost) return false;
      forest_.for_each_child(facet, [&](Index child) {
        if (seen_[child] == stamp_) return;
        seen_[child] = stamp_;
        option_.ejected.push_back(child);
      });
    }
    return true;
  }

  FacetForest& forest_;
  RandomSequence random_;
  std::vector<double> weight_;
  std::vector<std::uint64_t> placed_at_, seen_;
  std::vector<Index> pool_, pool_place_, overlapped_;
  std::vector<char> stale_;  ///< pieces that lost facets since their extent was computed
  std::uint64_t now_ = 0, stamp_ = 0;
  Option best_, option_;
};

/// Pieces that are not a whole component, smallest first.
std::vector<Index> removable_pieces(const FacetForest& forest) {
  std::vector<std::size_t> component_size(forest.graph().component_count(), 0);
  for (Index f = 0; f < forest.graph().facet_count(); ++f) ++component_size[forest.graph().component(f)];
  std::vector<Index> out;
  for (Index piece = 0; piece < forest.piece_slots(); ++piece) {
    const auto& members = forest.members(piece);
    if (!members.empty() && members.size() < component_size[forest.graph().component(members[0])])
      out.push_back(piece);
  }
  std::stable_sort(out.begin(), out.end(),
                   [&](Index a, Index b) { return forest.members(a).size() < forest.members(b).size(); });
  return out;
}

}  // namespace

std::uint64_t eject_pieces(FacetForest& forest, const EjectionOptions& options, const CancelToken& cancel,
                           const Progress& progress) {
  constexpr std::uint64_t share = 3;  // a single elimination gets this fraction of the remaining budget
  std::uint64_t left = options.steps, seed = options.seed;
  std::size_t failures = 0;
  while (left > 0 && failures < share && !cancel.cancelled()) {
    const std::vector<Index> pieces = removable_pieces(forest);
    if (pieces.empty()) break;
    FacetForest trial = forest;
    std::uint64_t own = failures + 1 < share ? left / (share - failures) : left;
    const std::uint64_t given = own;
    Eliminator eliminator(trial, seed++);
    const auto tick = [&] { progress.report(1 - double(left - (given - own)) / double(options.steps)); };
    const bool done = eliminator.eliminate(pieces[failures % pieces.size()], own, cancel, tick);
    left -= given - own;
    if (!done) {
      ++failures;
      continue;
    }
    failures = 0;
    join_pieces(trial, {GrowthOrder::long_edges}, cancel);
    forest = std::move(trial);
    if (options.improved) options.improved(forest);
  }
  return options.steps - left;
}

}  // namespace hariko

#include "core/unfolding/cuts/facet_forest.hpp"

#include <algorithm>

#include "core/unfolding/cuts/convex_overlap.hpp"

namespace hariko {

namespace {

bool boxes_meet(const FacetCorners& a, const FacetCorners& b) {
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const auto [low_a, high_a] = std::minmax({a[0][axis], a[1][axis], a[2][axis]});
    const auto [low_b, high_b] = std::minmax({b[0][axis], b[1][axis], b[2][axis]});
    if (high_a < low_b || high_b < low_a) return false;
  }
  return true;
}

}  // namespace

FacetForest::FacetForest(const FacetGraph& graph, const std::vector<FacetCorners>& shapes,
                         const EdgeRules& rules, double tolerance, std::optional<PaperSize> room)
    : graph_(&graph),
      shapes_(&shapes),
      rules_(&rules),
      tolerance_(tolerance),
      room_(room),
      grid_(shapes),
      piece_(graph.facet_count(), no_index),
      parent_side_(graph.facet_count(), no_index),
      place_(graph.facet_count(), 0),
      corners_(graph.facet_count()) {}

std::size_t FacetForest::piece_count() const {
  return static_cast<std::size_t>(
      std::count_if(members_.begin(), members_.end(), [](const auto& members) { return !members.empty(); }));
}

void FacetForest::put(Index piece, const FacetMove& move) {
  piece_[move.facet] = piece;
  parent_side_[move.facet] = move.parent_side;
  corners_[move.facet] = move.corners;
  place_[move.facet] = static_cast<Index>(members_[piece].size());
  members_[piece].push_back(move.facet);
  grid_.insert(piece, move.facet, move.corners);
  if (room_) extents_[piece].add(move.corners);
}

Index FacetForest::plant(Index facet) {
  const auto piece = static_cast<Index>(members_.size());
  members_.emplace_back();
  extents_.emplace_back();
  std::vector<FacetMove> moves{{facet, no_index, (*shapes_)[facet]}};
  add_followers(moves);
  attach(piece, moves);
  return piece;
}

void FacetForest::add_followers(std::vector<FacetMove>& moves) const {
  if (rules_->empty()) return;
  for (std::size_t k = 0; k < moves.size(); ++k) {
    const FacetMove move = moves[k];
    for (Index side = 0; side < 3; ++side)
      if (side != move.parent_side && rule(graph_->edge_at(move.facet, side)) == EdgeRule::folded)
        moves.push_back({graph_->neighbour(move.facet, side), graph_->mate_side(move.facet, side),
                         hinge_neighbour(*graph_, *shapes_, move.facet, move.corners, side)});
  }
}

void FacetForest::find_moves(Index facet, Index side, std::vector<FacetMove>& out) const {
  out.clear();
  out.push_back({graph_->neighbour(facet, side), graph_->mate_side(facet, side),
                 hinge_neighbour(*graph_, *shapes_, facet, corners_[facet], side)});
  add_followers(out);
}

bool FacetForest::fits(Index piece, const std::vector<FacetMove>& moves) const {
  if (!room_) return true;
  PieceExtent extent = extents_[piece];
  for (const FacetMove& move : moves) extent.add(move.corners);
  return extent.fits(*room_);
}

bool FacetForest::is_free(Index piece, const std::vector<FacetMove>& moves) const {
  return std::all_of(moves.begin(), moves.end(),
                     [&](const FacetMove& move) { return is_free(piece, move.corners); });
}

bool FacetForest::is_free(Index piece, const FacetCorners& corners) const {
  return grid_.for_each_near(piece, corners, [&](Index other) {
    return !boxes_meet(corners, corners_[other]) || !overlaps(corners, corners_[other], tolerance_);
  });
}

void FacetForest::find_overlapped(Index piece, const FacetCorners& corners, std::vector<Index>& out) const {
  grid_.for_each_near(piece, corners, [&](Index other) {
    if (boxes_meet(corners, corners_[other]) && overlaps(corners, corners_[other], tolerance_))
      out.push_back(other);
    return true;
  });
}

void FacetForest::attach(Index piece, const std::vector<FacetMove>& moves) {
  for (const FacetMove& move : moves) put(piece, move);
}

void FacetForest::detach(Index facet) {
  std::vector<Index>& members = members_[piece_[facet]];
  grid_.remove(piece_[facet], facet, corners_[facet]);
  members[place_[facet]] = members.back();
  place_[members.back()] = place_[facet];
  members.pop_back();
  piece_[facet] = parent_side_[facet] = no_index;
}

void FacetForest::shrink_extent(Index piece) {
  if (!room_) return;
  extents_[piece] = {};
  for (const Index facet : members_[piece]) extents_[piece].add(corners_[facet]);
}

bool FacetForest::join(Index edge) {
  Index from = graph_->edge(edge).facets[0], onto = graph_->edge(edge).facets[1];
  Index side = graph_->edge(edge).sides[1];
  if (members_[piece_[from]].size() > members_[piece_[onto]].size()) {
    std::swap(from, onto);
    side = graph_->edge(edge).sides[0];
  }
  const Index target = piece_[onto], source = piece_[from];
  std::vector<FacetMove> moves{
      {from, graph_->mate_side(onto, side), hinge_neighbour(*graph_, *shapes_, onto, corners_[onto], side)}};
  PieceExtent extent = extents_[target];
  for (std::size_t k = 0; k < moves.size(); ++k) {
    const FacetMove move = moves[k];
    if (room_) {
      extent.add(move.corners);
      if (!extent.fits(*room_)) return false;
    }
    if (!is_free(target, move.corners)) return false;
    // The rest of the moved piece follows over its old folds, in either direction.
    for (Index s = 0; s < 3; ++s) {
      const Index next = graph_->neighbour(move.facet, s);
      if (next == no_index || s == move.parent_side || piece_[next] != source) continue;
      const Index mate = graph_->mate_side(move.facet, s);
      if (parent_side_[move.facet] != s && parent_side_[next] != mate) continue;
      moves.push_back({next, mate, hinge_neighbour(*graph_, *shapes_, move.facet, move.corners, s)});
    }
  }
  for (const FacetMove& move : moves) detach(move.facet);
  attach(target, moves);
  extents_[source] = {};
  return true;
}

Folds FacetForest::folds() const {
  Folds out(graph_->edge_count(), 0);
  for (Index f = 0; f < graph_->facet_count(); ++f)
    if (parent_side_[f] != no_index) out[graph_->edge_at(f, parent_side_[f])] = 1;
  return out;
}

}  // namespace hariko

#include "core/cad/cad_plan.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/base/assert.hpp"
#include "core/base/disjoint_sets.hpp"

namespace hariko {

namespace {

/// Distance, in fractions of a side, below which two places count as one.
constexpr double same_place = 1e-9;

struct ArcUse {
  Index arc = no_index;
  double begin = 0, end = 1;  ///< in the parameter of the piece's side
};

class Planner {
 public:
  Planner(const Surface& surface, const std::vector<CadPiece>& pieces)
      : surface_(surface),
        pieces_(pieces),
        sides_(std::size_t(corner_count(surface.domain()))),
        breaks_(sides_ * surface.patch_count(), {0.0, 1.0}) {}

  CadPlan run() {
    find_breaks();
    number_points();
    number_arcs();
    collect_uses();
    join_arcs();
    number_vertices();
    return std::move(plan_);
  }

 private:
  std::size_t slot(PatchSide side) const { return sides_ * side.patch + side.side; }

  template <class Visit>
  void for_cell_sides(const Visit& visit) const {
    for (const CadPiece& piece : pieces_)
      for (const CadCell& cell : piece.cells)
        for (const CellSide& side : cell.sides) visit(side);
  }

  /// Whether a seam runs the usual way: up the first side and down the second.
  static bool usual(const Seam& seam) {
    return seam.first_begin < seam.first_end && seam.second_begin > seam.second_end;
  }
  static double on_second(const Seam& seam, double x) {
    return seam.second_begin + (x - seam.first_begin) / (seam.first_end - seam.first_begin) *
                                   (seam.second_end - seam.second_begin);
  }
  static double on_first(const Seam& seam, double x) {
    return seam.first_begin + (x - seam.second_begin) / (seam.second_end - seam.second_begin) *
                                  (seam.first_end - seam.first_begin);
  }

  bool add_break(std::size_t at, double x) {
    auto& list = breaks_[at];
    const auto above = std::lower_bound(list.begin(), list.end(), x - same_place);
    if (above != list.end() && *above <= x + same_place) return false;
    list.insert(above, x);
    return true;
  }
  std::size_t place(std::size_t at, double x) const {
    const auto& list = breaks_[at];
    const auto found = std::lower_bound(list.begin(), list.end(), x - same_place);
    HARIKO_ASSERT(found != list.end() && *found <= x + same_place, "every end of a part is a break");
    return std::size_t(found - list.begin());
  }

  /// Collects the ends of parts, carried over the seams until no new one appears.
  void find_breaks() {
    for_cell_sides([&](const CellSide& side) {
      if (side.side.patch == no_index) return;
      add_break(slot(side.side), side.begin);
      add_break(slot(side.side), side.end);
    });
    for (const Seam& seam : surface_.seams()) {
      for (const double x : {seam.first_begin, seam.first_end}) add_break(slot(seam.first), x);
      for (const double x : {seam.second_begin, seam.second_end}) add_break(slot(seam.second), x);
    }
    constexpr int most_rounds = 64;
    bool changed = true;
    for (int round = 0; changed && round < most_rounds; ++round) {
      changed = false;
      for (const Seam& seam : surface_.seams()) {
        if (!usual(seam)) continue;
        for (const double x : std::vector(breaks_[slot(seam.first)]))
          if (x > seam.first_begin && x < seam.first_end)
            changed |= add_break(slot(seam.second), on_second(seam, x));
        for (const double x : std::vector(breaks_[slot(seam.second)]))
          if (x < seam.second_begin && x > seam.second_end)
            changed |= add_break(slot(seam.first), on_first(seam, x));
      }
    }
  }

  Index point(const CellSide& side, bool end) const {
    if (side.side.patch == no_index)
      return first_inner_point_ + 2 * side.inner + Index((side.begin < side.end) == end);
    return first_point_[slot(side.side)] + Index(place(slot(side.side), end ? side.end : side.begin));
  }

  void number_points() {
    Index next = 0;
    for (const auto& list : breaks_) {
      first_point_.push_back(next);
      next += Index(list.size());
    }
    first_inner_point_ = next;
    Index inner = 0;
    for_cell_sides([&](const CellSide& side) {
      if (side.side.patch == no_index) inner = std::max(inner, side.inner + 1);
    });
    points_ = DisjointSets(first_inner_point_ + 2 * inner);
    for (const CadPiece& piece : pieces_)
      for (const CadCell& cell : piece.cells)
        for (std::size_t k = 0; k < 4; ++k)
          points_.join(point(cell.sides[k], true), point(cell.sides[(k + 1) % 4], false));
    for (Index patch = 0; patch < surface_.patch_count(); ++patch)
      for (std::size_t k = 0; k < sides_; ++k) {
        const std::size_t here = sides_ * patch + k, next_side = sides_ * patch + (k + 1) % sides_;
        points_.join(first_point_[here] + Index(breaks_[here].size() - 1), first_point_[next_side]);
      }
    inner_count_ = inner;
  }

  void number_arcs() {
    first_arc_.assign(breaks_.size(), 0);
    for (std::size_t at = 0; at < breaks_.size(); ++at) {
      first_arc_[at] = Index(arcs_.size());
      for (std::size_t i = 0; i + 1 < breaks_[at].size(); ++i)
        arcs_.push_back({first_point_[at] + Index(i), first_point_[at] + Index(i + 1)});
    }
    first_inner_arc_ = Index(arcs_.size());
    for (Index i = 0; i < inner_count_; ++i)
      arcs_.push_back({first_inner_point_ + 2 * i, first_inner_point_ + 2 * i + 1});
    for (Index i = 0; i < arcs_.size(); ++i) arcs_[i].same = i;
    for (const Seam& seam : surface_.seams()) {
      if (!usual(seam)) continue;
      const std::size_t a = slot(seam.first), b = slot(seam.second);
      const std::size_t from = place(a, seam.first_begin), to = place(a, seam.first_end);
      for (std::size_t i = from; i <= to; ++i)
        points_.join(first_point_[a] + Index(i),
                     first_point_[b] + Index(place(b, on_second(seam, breaks_[a][i]))));
      for (std::size_t i = from; i < to; ++i) {
        const std::size_t other = place(b, on_second(seam, breaks_[a][i + 1]));
        arcs_[first_arc_[b] + other].same = first_arc_[a] + Index(i);
        arcs_[first_arc_[a] + i].smooth = seam.intended != Continuity::g0;
      }
    }
  }

  void collect_uses() {
    users_.resize(arcs_.size());
    uses_.resize(pieces_.size());
    for (Index p = 0; p < pieces_.size(); ++p)
      for (int side = 0; side < 4; ++side) {
        const std::vector<double> breaks = pieces_[p].breaks(side);
        for (Index at = 0; at < pieces_[p].cell_count(side); ++at) {
          const CellSide& cell = pieces_[p].cell(side, at).sides[std::size_t(side)];
          auto& list = uses_[p][std::size_t(side)];
          const double low = breaks[at], width = breaks[at + 1] - low;
          const auto add = [&](Index arc, double begin, double end) {
            users_[arc].push_back({p, side, Index(list.size())});
            list.push_back({arc, low + begin * width, end == 1 ? breaks[at + 1] : low + end * width});
          };
          if (cell.side.patch == no_index) {
            add(first_inner_arc_ + cell.inner, 0, 1);
            continue;
          }
          const std::size_t here = slot(cell.side);
          const std::size_t from = place(here, cell.begin), to = place(here, cell.end);
          const auto fraction = [&](std::size_t i) {
            return i == from ? 0 : i == to ? 1 : (breaks_[here][i] - cell.begin) / (cell.end - cell.begin);
          };
          for (std::size_t i = from; i < to; ++i)
            add(arcs_[first_arc_[here] + i].same, fraction(i), fraction(i + 1));
        }
      }
  }

  struct User {
    Index piece = no_index;
    int side = 0;
    Index place = 0;
    friend bool operator==(const User&, const User&) = default;
  };

  /// Other user of an arc, if there is one.
  std::optional<User> partner(Index arc, const User& own) const {
    for (const User& user : users_[arc])
      if (!(user == own)) return user;
    return {};
  }
  const ArcUse& use(const User& user) const { return uses_[user.piece][std::size_t(user.side)][user.place]; }

  /// Whether the next arc along both sides belongs to the same edge.
  bool runs_on(const User& own, const std::optional<User>& other) const {
    const auto& list = uses_[own.piece][std::size_t(own.side)];
    if (own.place + 1 >= list.size()) return false;
    const User next{own.piece, own.side, own.place + 1};
    const auto beyond = partner(use(next).arc, next);
    if (beyond.has_value() != other.has_value()) return false;
    if (!other) return true;
    if (beyond->piece != other->piece || beyond->side != other->side || beyond->place + 1 != other->place)
      return false;
    const auto speed = [&](const User& a, const User& b) {
      return (use(a).end - use(a).begin) / (use(b).end - use(b).begin);
    };
    return arcs_[use(next).arc].smooth == arcs_[use(own).arc].smooth &&
           std::abs(speed(own, *other) - speed(next, *beyond)) <= same_place;
  }

  void join_arcs() {
    plan_.sides.resize(pieces_.size());
    std::vector<Index> edge_of(arcs_.size(), no_index);
    for (Index p = 0; p < pieces_.size(); ++p)
      for (int side = 0; side < 4; ++side)
        for (Index i = 0; i < uses_[p][std::size_t(side)].size(); ++i) {
          User own{p, side, i};
          if (edge_of[use(own).arc] != no_index) continue;
          PlannedEdge edge;
          auto other = partner(use(own).arc, own);
          edge.use_count = other ? 2 : 1;
          edge.smooth = arcs_[use(own).arc].smooth;
          edge.uses[0] = {p, side, use(own).begin, use(own).end};
          if (other) edge.uses[1] = {other->piece, other->side, use(*other).begin, use(*other).end};
          edge_of[use(own).arc] = Index(plan_.edges.size());
          while (runs_on(own, other)) {
            ++own.place;
            if (edge_of[use(own).arc] != no_index) break;
            if (other) --other->place;
            edge_of[use(own).arc] = Index(plan_.edges.size());
            edge.uses[0].end = use(own).end;
            if (other) edge.uses[1].begin = use(*other).begin;
          }
          plan_.edges.push_back(edge);
        }
    for (Index p = 0; p < pieces_.size(); ++p)
      for (std::size_t side = 0; side < 4; ++side)
        for (const ArcUse& item : uses_[p][side]) {
          auto& list = plan_.sides[p][side];
          if (list.empty() || list.back() != edge_of[item.arc]) list.push_back(edge_of[item.arc]);
        }
  }

  /// Point at the beginning or end of a part of a side.
  Index end_point(const CadUse& stretch, bool end) const {
    for (const ArcUse& item : uses_[stretch.piece][std::size_t(stretch.side)]) {
      if (!(end ? item.end == stretch.end : item.begin == stretch.begin)) continue;
      const Arc& arc = arcs_[item.arc];
      // Arcs run along the first side that has them; sides that run against an arc are second uses.
      const bool along = runs_along(stretch, item);
      return end == along ? arc.end : arc.begin;
    }
    HARIKO_ASSERT(false, "stretches end where arcs do");
    return no_index;
  }
  bool runs_along(const CadUse& stretch, const ArcUse& item) const {
    const std::vector<double> breaks = pieces_[stretch.piece].breaks(stretch.side);
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, 0.5 * (item.begin + item.end));
    const auto at = Index(above - breaks.begin() - 1);
    const CellSide& cell = pieces_[stretch.piece].cell(stretch.side, at).sides[std::size_t(stretch.side)];
    if (cell.side.patch == no_index) return cell.begin < cell.end;
    const std::size_t here = slot(cell.side);
    return item.arc >= first_arc_[here] && item.arc < first_arc_[here] + breaks_[here].size() - 1;
  }

  void number_vertices() {
    std::map<Index, Index> number;
    const auto vertex = [&](Index at) {
      return number.emplace(points_.find(at), Index(number.size())).first->second;
    };
    for (PlannedEdge& edge : plan_.edges) {
      edge.begin = vertex(end_point(edge.uses[0], false));
      edge.end = vertex(end_point(edge.uses[0], true));
    }
    plan_.vertex_count = Index(number.size());
  }

  struct Arc {
    Index begin = 0, end = 0;  ///< points
    Index same = 0;            ///< representative of equal arcs
    bool smooth = true;
  };

  const Surface& surface_;
  const std::vector<CadPiece>& pieces_;
  std::size_t sides_;
  std::vector<std::vector<double>> breaks_;  ///< by patch side
  DisjointSets points_;
  std::vector<Index> first_point_, first_arc_;
  Index first_inner_point_ = 0, first_inner_arc_ = 0, inner_count_ = 0;
  std::vector<Arc> arcs_;
  std::vector<std::array<std::vector<ArcUse>, 4>> uses_;
  std::vector<std::vector<User>> users_;  ///< by arc
  CadPlan plan_;
};

}  // namespace

CadPlan plan_cad(const Surface& surface, const std::vector<CadPiece>& pieces) {
  return Planner(surface, pieces).run();
}

}  // namespace hariko

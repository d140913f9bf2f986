#include "core/unfolding/cuts/reference_method.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/unfolding/cuts/convex_overlap.hpp"
#include "core/unfolding/pages/sheet_overlaps.hpp"

namespace hariko {

namespace {

constexpr int repair_rounds = 60;
using std::numbers::pi;

double corner_angle(const FacetGraph& graph, Index facet, Index corner) {
  const auto& vertices = graph.triangle(facet);
  const Vector3& at = graph.positions()[vertices[corner]];
  const Vector3 a = (graph.positions()[vertices[(corner + 1) % 3]] - at).normalized();
  const Vector3 b = (graph.positions()[vertices[(corner + 2) % 3]] - at).normalized();
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

Index corner_of(const FacetGraph& graph, Index facet, Index vertex) {
  const auto& vertices = graph.triangle(facet);
  return static_cast<Index>(std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin());
}

/// Sum of the angles at a vertex, from one facet to the next away from `edge`, up to a cut or a border, or
/// all round.
double fan_angle(const FacetGraph& graph, const std::vector<std::uint8_t>* cuts, Index facet, Index edge,
                 Index vertex) {
  double sum = 0;
  for (Index start = edge; facet != no_index;) {
    const Index corner = corner_of(graph, facet, vertex);
    sum += corner_angle(graph, facet, corner);
    const Index leaving = graph.edge_at(facet, corner), entering = graph.edge_at(facet, (corner + 2) % 3);
    edge = leaving == edge ? entering : leaving;
    if (edge == start || (cuts && (*cuts)[edge])) break;
    facet = graph.edge(edge).across(facet);
  }
  return sum;
}

std::vector<SheetPolygon> sheet_of(const FlatLayout& layout) {
  std::vector<SheetPolygon> out;
  out.reserve(layout.corners.size());
  for (Index f = 0; f < layout.corners.size(); ++f) out.emplace_back(layout.corners[f], layout.piece_of[f]);
  return out;
}

/// Initial cut to undo: the first cut between two facets, in the order of the overlapping facets; cuts that
/// the tip rule rejects have priority.
std::optional<Index> cut_to_rejoin(const FacetGraph& graph, const std::vector<std::uint8_t>& cuts,
                                   const std::vector<std::pair<Index, Index>>& pairs) {
  std::optional<Index> first;
  for (const auto& [a, b] : pairs)
    for (const Index facet : {a, b})
      for (Index side = 0; side < 3; ++side) {
        const Index e = graph.edge_at(facet, side);
        if (!cuts[e] || graph.edge(e).border()) continue;
        if (tip_would_overlap(graph, cuts, e, graph.edge(e).low) ||
            tip_would_overlap(graph, cuts, e, graph.edge(e).high))
          return e;
        if (!first) first = e;
      }
  return first;
}

}  // namespace

std::vector<std::uint8_t> initial_cuts(const FacetGraph& graph) {
  std::vector<std::uint8_t> cuts(graph.edge_count(), 0);
  std::vector<int> count(graph.facet_count(), 0);
  const auto cut = [&](Index e) {
    cuts[e] = 1;
    for (const Index facet : graph.edge(e).facets)
      if (facet != no_index) ++count[facet];
  };
  for (Index e = 0; e < graph.edge_count(); ++e)
    if (graph.edge(e).border()) cut(e);
  for (Index facet = 0; facet < graph.facet_count(); ++facet) {
    Index sharpest = no_index;
    for (Index side = 0; side < 3; ++side) {
      const Index e = graph.edge_at(facet, side);
      if (graph.edge(e).border() || graph.edge(e).inner) continue;
      if (sharpest == no_index ||
          std::abs(graph.edge(e).fold_angle) > std::abs(graph.edge(sharpest).fold_angle))
        sharpest = e;
    }
    if (sharpest == no_index || cuts[sharpest]) continue;
    if (count[facet] < 2 && count[graph.edge(sharpest).across(facet)] < 2) cut(sharpest);
  }
  return cuts;
}

Folds unfold_over(const FacetGraph& graph, const std::vector<std::uint8_t>& cuts) {
  Folds folds(graph.edge_count(), 0);
  std::vector<char> placed(graph.facet_count(), 0);
  std::vector<Index> queue;
  for (Index root = 0; root < graph.facet_count(); ++root) {
    if (placed[root]) continue;
    queue.clear();
    // Places the rest of the flat face too.
    const auto place = [&](Index facet) {
      std::size_t next = queue.size();
      placed[facet] = 1;
      queue.push_back(facet);
      for (; next < queue.size(); ++next)
        for (Index side = 0; side < 3; ++side) {
          const Index e = graph.edge_at(queue[next], side), other = graph.neighbour(queue[next], side);
          if (!graph.edge(e).inner || placed[other]) continue;
          placed[other] = 1;
          folds[e] = 1;
          queue.push_back(other);
        }
    };
    place(root);
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (Index side = 0; side < 3; ++side) {
        const Index e = graph.edge_at(queue[k], side), next = graph.neighbour(queue[k], side);
        if (cuts[e] || placed[next]) continue;
        folds[e] = 1;
        place(next);
      }
  }
  return folds;
}

bool tip_would_overlap(const FacetGraph& graph, const std::vector<std::uint8_t>& cuts, Index edge,
                       Index tip) {
  const FacetEdge& cut = graph.edge(edge);
  const Index other = tip == cut.low ? cut.high : cut.low;
  const double theta2 = fan_angle(graph, nullptr, cut.facets[0], edge, tip);
  const double theta1 = fan_angle(graph, &cuts, cut.facets[0], edge, other);
  return theta1 - pi > 2 * (2 * pi - theta2);
}

Result<ReferenceUnfolding> reference_unfolding(const FacetGraph& graph,
                                               const std::vector<FacetCorners>& shapes,
                                               const CancelToken& cancel) {
  const double longest = longest_side(shapes);
  std::vector<std::uint8_t> cuts = initial_cuts(graph);
  ReferenceUnfolding best;
  for (int round = 0;; ++round) {
    if (cancel.cancelled()) return make_error(e_cancelled, "Unfolding was cancelled.");
    Folds folds = unfold_over(graph, cuts);
    const auto pairs =
        overlapping_pairs(sheet_of(lay_out(graph, shapes, folds)), overlap_tolerance * longest);
    if (round == 0 || pairs.size() < best.overlapping_pairs) best = {std::move(folds), pairs.size(), round};
    best.rounds = round;
    if (pairs.empty() || round == repair_rounds) return best;
    const auto rejoined = cut_to_rejoin(graph, cuts, pairs);
    if (!rejoined) return best;
    cuts[*rejoined] = 0;
  }
}

}  // namespace hariko

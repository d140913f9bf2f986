#include "core/unfolding/cuts/cut_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/unfolding/cuts/convex_overlap.hpp"
#include "core/unfolding/cuts/ejection_chain.hpp"
#include "core/unfolding/cuts/greedy_unfolding.hpp"

namespace hariko {

namespace {

Message cancelled_search() {
  return make_error(e_cancelled, "Unfolding was cancelled.");
}

}  // namespace

double search_tolerance(const std::vector<FacetCorners>& shapes) {
  return 0.5 * overlap_tolerance * longest_side(shapes);
}

std::size_t piece_count(const FacetGraph& graph, const Folds& folds) {
  return graph.facet_count() - static_cast<std::size_t>(std::count(folds.begin(), folds.end(), 1));
}

Result<std::vector<Folds>> search_cuts(const FacetGraph& graph, const std::vector<FacetCorners>& shapes,
                                       const EdgeRules& rules, const CutSearch& search,
                                       const CancelToken& cancel, const Progress& progress) {
  const double tolerance = search_tolerance(shapes);
  std::optional<FacetForest> best;
  std::vector<Folds> out;
  const auto consider = [&](auto&& start, const Growth& growth) {
    FacetForest forest(graph, shapes, rules, tolerance, search.room);
    start(forest, growth, cancel);
    if (cancel.cancelled()) return;
    out.push_back(forest.folds());
    if (!best || forest.piece_count() < best->piece_count()) best = std::move(forest);
  };
  consider(gather, {GrowthOrder::long_edges});
  progress.report(0.05);
  consider(gather, {GrowthOrder::flat_edges});
  progress.report(0.1);
  consider(gather, {GrowthOrder::first_come});
  progress.report(0.15);
  consider(grow, {GrowthOrder::first_come});
  progress.report(0.2);
  if (cancel.cancelled()) return cancelled_search();

  // Keeps only states with clearly fewer pieces than the one before: others are no real alternative.
  std::size_t kept = best->piece_count();
  const auto improved = [&](const FacetForest& forest) {
    if (5 * forest.piece_count() > 4 * kept) return;
    kept = forest.piece_count();
    out.push_back(forest.folds());
  };
  eject_pieces(*best, {.steps = search.steps, .improved = improved}, cancel, progress.part(0.2, 1));
  if (cancel.cancelled()) return cancelled_search();
  out.push_back(best->folds());
  return out;
}

EdgeRules settled_rules(const FacetGraph& graph, const std::vector<FacetCorners>& shapes,
                        const EdgeRules& wishes, double merge_angle, std::optional<PaperSize> room) {
  EdgeRules out(graph.edge_count(), EdgeRule::free);
  for (Index e = 0; e < wishes.size(); ++e)
    if (wishes[e] == EdgeRule::cut && !graph.edge(e).inner) out[e] = EdgeRule::cut;
  for (Index e = 0; e < graph.edge_count(); ++e)
    if (graph.edge(e).inner) out[e] = EdgeRule::folded;
  const EdgeRules given = out;
  FacetForest forest(graph, shapes, given, search_tolerance(shapes), room);
  for (Index f = 0; f < graph.facet_count(); ++f)
    if (!forest.placed(f)) forest.plant(f);
  const auto fold = [&](Index e) {
    const FacetEdge& edge = graph.edge(e);
    if (edge.border() || out[e] != EdgeRule::free ||
        forest.piece(edge.facets[0]) == forest.piece(edge.facets[1]) || !forest.join(e))
      return;
    out[e] = EdgeRule::folded;
  };
  for (Index e = 0; e < wishes.size(); ++e)
    if (wishes[e] == EdgeRule::folded) fold(e);
  for (Index e = 0; e < graph.edge_count(); ++e)
    if (std::abs(graph.edge(e).fold_angle) <= merge_angle) fold(e);
  return out;
}

}  // namespace hariko

#include "core/unfolding/paper_document.hpp"

#include <algorithm>
#include <map>

#include "core/base/assert.hpp"
#include "core/base/disjoint_sets.hpp"
#include "core/base/index_list.hpp"
#include "core/unfolding/cuts/cut_search.hpp"
#include "core/unfolding/cuts/greedy_unfolding.hpp"

namespace hariko {

namespace {

PaperPlace row_of(const PiecePlacement& place) {
  return {place.page, place.angle, place.offset.x(), place.offset.y()};
}

PiecePlacement placement_of(const PaperPlace& place) {
  return {place.page, place.angle, {place.x, place.y}};
}

/// Number of stored facets a piece: the first one and a few more, so that a piece keeps its place when some
/// facets vanish.
constexpr std::size_t anchors_a_piece = 4;

/// Stores a layout by the numbers of the stored vertices.
class Keeper {
 public:
  Keeper(const Unfolding& unfolding, std::span<const PaperVertex> names, const PaperModel& before)
      : u_(unfolding), graph_(*unfolding.graph) {
    out_.objects = before.objects;
    out_.of_polyhedra = before.of_polyhedra;
    out_.distance = before.distance;
    out_.normal_angle = before.normal_angle;
    out_.goal = before.goal;
    out_.steps = before.steps;
    out_.kept = before.kept;
    out_.settings = unfolding.settings;
    number(names);
  }

  PaperModel keep() {
    for (Index e = 0; e < graph_.edge_count(); ++e) edge(e);
    for (auto* list : {&out_.folds, &out_.cuts, &out_.own_folds, &out_.own_cuts, &out_.tabs, &out_.strips})
      std::sort(list->begin(), list->end());
    const std::vector<FacetCorners> shapes = facet_shapes(graph_, u_.settings.scale);
    for (const PaperPiece& piece : u_.pieces) place(piece, shapes);
    for (Index j = 0; j < u_.joints.size(); ++j) {
      const PaperEdge named = names_of(graph_.edge(u_.joints[j].edge));
      if (!u_.joints[j].tab && known(named)) out_.strip_places.push_back({named, row_of(u_.strips[j])});
    }
    return std::move(out_);
  }

 private:
  void number(std::span<const PaperVertex> names) {
    HARIKO_ASSERT(names.size() == graph_.positions().size(), "one name a vertex");
    std::vector<Index> order = ascending_indices(names.size());
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return names[a] < names[b]; });
    number_.assign(names.size(), no_index);
    for (std::size_t k = 0; k < order.size(); ++k) {
      const PaperVertex& name = names[order[k]];
      if ((k > 0 && names[order[k - 1]] == name) || (k + 1 < order.size() && names[order[k + 1]] == name))
        continue;
      number_[order[k]] = static_cast<Index>(out_.vertices.size());
      out_.vertices.push_back(name);
    }
  }

  template <std::size_t N>
  static bool known(const std::array<std::uint32_t, N>& named) {
    return std::find(named.begin(), named.end(), no_index) == named.end();
  }
  PaperEdge names_of(const FacetEdge& edge) const {
    const auto [low, high] = std::minmax(number_[edge.low], number_[edge.high]);
    return {low, high};
  }

  void edge(Index e) {
    const FacetEdge& edge = graph_.edge(e);
    const PaperEdge named = names_of(edge);
    if (edge.border() || !known(named)) return;
    (u_.folds[e] ? out_.folds : out_.cuts).push_back(named);
    if (u_.wishes[e] == EdgeRule::folded) out_.own_folds.push_back(named);
    if (u_.wishes[e] == EdgeRule::cut) out_.own_cuts.push_back(named);
    const TabChoice choice = u_.tab_choices[e];
    if (choice == TabChoice::strip) out_.strips.push_back(named);
    if (choice != TabChoice::first && choice != TabChoice::second) return;
    const std::size_t k = choice == TabChoice::first ? 0 : 1;
    const auto& corners = graph_.triangle(edge.facets[k]);
    out_.tabs.push_back({number_[corners[edge.sides[k]]], number_[corners[(edge.sides[k] + 1) % 3]]});
  }

  void place(const PaperPiece& piece, const std::vector<FacetCorners>& shapes) {
    const std::size_t count = piece.facets.size();
    std::size_t last = count;
    for (std::size_t k = 0; k < anchors_a_piece; ++k) {
      const std::size_t at = k * (count - 1) / (anchors_a_piece - 1);
      if (at == last) continue;
      last = at;
      const Index facet = piece.facets[at];
      const auto& corners = graph_.triangle(facet);
      const std::array<std::uint32_t, 3> named{number_[corners[0]], number_[corners[1]], number_[corners[2]]};
      if (!known(named)) continue;
      const PiecePlacement lies =
          at == 0 ? piece.placement
                  : placement_between(shapes[facet], u_.corners[facet], piece.placement.page);
      out_.places.push_back({named, row_of(lies)});
    }
  }

  const Unfolding& u_;
  const FacetGraph& graph_;
  PaperModel out_;
  std::vector<Index> number_;  ///< number among the stored vertices, by vertex of the mesh
};

/// Finds the stored vertices, edges and facets on a mesh.
class Finder {
 public:
  Finder(const PaperModel& paper, const FacetGraph& graph, std::span<const PaperVertex> names)
      : graph_(graph), vertex_(paper.vertices.size(), no_index) {
    HARIKO_ASSERT(names.size() == graph.positions().size(), "one name a vertex");
    std::vector<char> twice(paper.vertices.size(), 0);
    for (Index v = 0; v < names.size(); ++v) {
      const auto found = std::lower_bound(paper.vertices.begin(), paper.vertices.end(), names[v]);
      if (found == paper.vertices.end() || !(*found == names[v])) continue;
      const auto at = static_cast<std::size_t>(found - paper.vertices.begin());
      twice[at] = vertex_[at] != no_index ? 1 : 0;
      vertex_[at] = v;
    }
    for (std::size_t at = 0; at < twice.size(); ++at)
      if (twice[at]) vertex_[at] = no_index;
  }

  /// Vertex of the mesh; no_index where it no longer exists.
  Index vertex(std::uint32_t kept) const { return vertex_[kept]; }
  /// Edge between two facets; no_index where it no longer exists or is a border now.
  Index edge(const PaperEdge& kept) const {
    const Index a = vertex(kept[0]), b = vertex(kept[1]);
    if (a == no_index || b == no_index) return no_index;
    const Index e = graph_.find_edge(std::min(a, b), std::max(a, b));
    return e == no_index || graph_.edge(e).border() ? no_index : e;
  }
  template <class Visit>
  void for_each(const std::vector<PaperEdge>& edges, Visit&& visit) const {
    for (const PaperEdge& kept : edges)
      if (const Index e = edge(kept); e != no_index) visit(e);
  }

 private:
  const FacetGraph& graph_;
  std::vector<Index> vertex_;
};

/// Rules that keep folds folded, unless changed facets would close a ring, and cuts cut.
EdgeRules rules_of(const PaperModel& paper, const FacetGraph& graph, const Finder& finder) {
  EdgeRules rules(graph.edge_count(), EdgeRule::free);
  finder.for_each(paper.cuts, [&](Index e) { rules[e] = EdgeRule::cut; });
  DisjointSets groups(graph.facet_count());
  const auto fold = [&](Index e) {
    const auto& [a, b] = graph.edge(e).facets;
    if (groups.find(a) == groups.find(b)) return;
    rules[e] = EdgeRule::folded;
    groups.join(a, b);
  };
  for (Index e = 0; e < graph.edge_count(); ++e)
    if (graph.edge(e).inner) fold(e);
  finder.for_each(paper.folds, fold);
  return rules;
}

Folds folds_of(const FacetGraph& graph, const EdgeRules& rules, const PaperSettings& settings) {
  bool open = false;
  Folds folds(graph.edge_count(), 0);
  for (Index e = 0; e < folds.size(); ++e) {
    folds[e] = rules[e] == EdgeRule::folded ? 1 : 0;
    open = open || (rules[e] == EdgeRule::free && !graph.edge(e).border());
  }
  if (!open) return folds;
  const std::vector<FacetCorners> shapes = facet_shapes(graph, settings.scale);
  FacetForest forest(graph, shapes, rules, search_tolerance(shapes), settings.piece_room());
  gather(forest, {GrowthOrder::long_edges}, {});
  return forest.folds();
}

std::vector<TabChoice> tabs_of(const PaperModel& paper, const FacetGraph& graph, const Finder& finder) {
  std::vector<TabChoice> out(graph.edge_count(), TabChoice::automatic);
  finder.for_each(paper.strips, [&](Index e) { out[e] = TabChoice::strip; });
  for (const PaperEdge& kept : paper.tabs) {
    const Index e = finder.edge(kept);
    if (e == no_index) continue;
    const FacetEdge& edge = graph.edge(e);
    const bool first = graph.triangle(edge.facets[0])[edge.sides[0]] == finder.vertex(kept[0]);
    out[e] = first ? TabChoice::first : TabChoice::second;
  }
  return out;
}

/// Stored place of a facet, whose corners are stored in order; `first_corner` is the mesh's corner that is
/// stored first.
struct Anchor {
  Index first_corner = 0;
  PiecePlacement place;
};

KnownPlaces places_of(const PaperModel& paper, const FacetGraph& graph, const Finder& finder) {
  std::map<std::array<Index, 3>, std::size_t> kept;  // by corners, the lowest first
  const auto turned = [](std::array<Index, 3> corners) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
  };
  for (std::size_t k = 0; k < paper.places.size(); ++k) {
    std::array<Index, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) corners[c] = finder.vertex(paper.places[k].facet[c]);
    if (std::find(corners.begin(), corners.end(), no_index) == corners.end())
      kept.emplace(turned(corners), k);
  }
  auto anchors = std::make_shared<std::map<Index, Anchor>>();
  for (Index f = 0; f < graph.facet_count(); ++f) {
    const auto found = kept.find(turned(graph.triangle(f)));
    if (found == kept.end()) continue;
    const auto& row = paper.places[found->second];
    const auto& corners = graph.triangle(f);
    const Index lead = finder.vertex(row.facet[0]);
    const auto first = static_cast<Index>(std::find(corners.begin(), corners.end(), lead) - corners.begin());
    anchors->emplace(f, Anchor{first, placement_of(row.place)});
  }
  auto strips = std::make_shared<std::map<Index, PiecePlacement>>();
  for (const auto& row : paper.strip_places)
    if (const Index e = finder.edge(row.edge); e != no_index) strips->emplace(e, placement_of(row.place));

  KnownPlaces out;
  if (paper.places.empty()) return out;
  auto shapes = std::make_shared<const std::vector<FacetCorners>>(facet_shapes(graph, paper.settings.scale));
  out.piece = [anchors, shapes](Index facet, const FacetCorners& in_piece) -> std::optional<PiecePlacement> {
    const auto found = anchors->find(facet);
    if (found == anchors->end()) return {};
    const Anchor& anchor = found->second;
    const FacetCorners& shape = (*shapes)[facet];
    if (anchor.first_corner == 0 && in_piece == shape) return anchor.place;  // the root, bit for bit
    // Frame of the stored order of corners: the first at the origin, the second on the x axis.
    const Index a = anchor.first_corner, b = (a + 1) % 3;
    const Vector2 along = shape[b] - shape[a];
    const PiecePlacement to_frame{0, -std::atan2(along.y(), along.x()), Vector2::Zero()};
    FacetCorners lies;
    for (std::size_t k = 0; k < 3; ++k)
      lies[k] = anchor.place.apply(to_frame.apply(Vector2(shape[k] - shape[a])));
    return placement_between(in_piece, lies, anchor.place.page);
  };
  out.strip = [strips, &graph](const FacetEdge& edge) -> std::optional<PiecePlacement> {
    const auto found = strips->find(graph.find_edge(edge.low, edge.high));
    return found == strips->end() ? std::nullopt : std::optional(found->second);
  };
  return out;
}

EdgeRules wishes_of(const PaperModel& paper, const FacetGraph& graph, const Finder& finder) {
  EdgeRules out(graph.edge_count(), EdgeRule::free);
  finder.for_each(paper.own_folds, [&](Index e) { out[e] = EdgeRule::folded; });
  finder.for_each(paper.own_cuts, [&](Index e) { out[e] = EdgeRule::cut; });
  return out;
}

}  // namespace

PaperModel kept_of(const Unfolding& unfolding, std::span<const PaperVertex> names, const PaperModel& before) {
  return Keeper(unfolding, names, before).keep();
}

Result<Unfolding> restored(const PaperModel& paper, std::shared_ptr<const FacetGraph> graph,
                           std::span<const PaperVertex> names) {
  if (const auto fine = check_settings(paper.settings, graph->longest_edge()); !fine.ok())
    return fine.error();
  const Finder finder(paper, *graph, names);
  Folds folds = folds_of(*graph, rules_of(paper, *graph, finder), paper.settings);
  const KnownPlaces known = places_of(paper, *graph, finder);
  const FacetGraph& mesh = *graph;
  return assemble(std::move(graph), paper.settings, std::move(folds), wishes_of(paper, mesh, finder),
                  tabs_of(paper, mesh, finder), known);
}

EdgeRules wishes_on(const PaperModel& paper, const FacetGraph& graph, std::span<const PaperVertex> names) {
  return wishes_of(paper, graph, Finder(paper, graph, names));
}

}  // namespace hariko

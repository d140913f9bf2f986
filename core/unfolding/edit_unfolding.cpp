#include "core/unfolding/edit_unfolding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/ids.hpp"
#include "core/unfolding/cuts/cut_search.hpp"

namespace hariko {

namespace {

using std::numbers::pi;

Element named_edge(const Unfolding& unfolding, Index e) {
  const FacetEdge& edge = unfolding.graph->edge(e);
  return element_of(EdgeId{{edge.low}, {edge.high}});
}

Message border_error(const Unfolding& unfolding, Index edge) {
  return make_error(e_edge_on_border, "The edge is on the border of the mesh: there is one facet only.",
                    "Choose an edge between two facets.", named_edge(unfolding, edge));
}

/// Calls visit for the tabs of a piece.
template <class Visit>
void for_each_tab(const Unfolding& unfolding, Index piece, Visit&& visit) {
  for (Index j = 0; j < unfolding.joints.size(); ++j) {
    const auto& tab = unfolding.joints[j].tab;
    if (tab && unfolding.piece_of[tab->facet] == piece) visit(j);
  }
}

/// Copy with one piece at another place. Facets and tabs are laid out anew instead of moved, so that rounding
/// does not accumulate.
Unfolding with_placement(const Unfolding& unfolding, Index piece, const PiecePlacement& placement) {
  Unfolding out = unfolding;
  const std::vector<FacetCorners> shapes = facet_shapes(*out.graph, out.settings.scale);
  const FlatLayout layout = lay_out(*out.graph, shapes, out.folds);
  const PiecePlacement before = out.pieces[piece].placement;
  out.pieces[piece].placement = placement;
  for (const Index facet : out.pieces[piece].facets)
    out.corners[facet] = placement.apply(layout.corners[facet]);
  for_each_tab(out, piece, [&](Index j) {
    GlueTab& tab = *out.joints[j].tab;
    // Maps from the page back to the piece, and to the new place.
    for (Vector2& corner : tab.corners) {
      const PiecePlacement back{0, -before.angle, Vector2::Zero()};
      corner = placement.apply(back.apply(corner - before.offset));
    }
    const FacetCorners& facet = out.corners[tab.facet];
    tab.corners[0] = facet[(tab.side + 1) % 3];
    tab.corners[1] = facet[tab.side];
  });
  out.page_count = 0;
  for (const PaperPiece& each : out.pieces)
    out.page_count = std::max(out.page_count, each.placement.page + 1);
  for (Index j = 0; j < out.joints.size(); ++j)
    if (!out.joints[j].tab) out.page_count = std::max(out.page_count, out.strips[j].page + 1);
  return out;
}

struct PieceBox {
  Vector2 low = Vector2::Constant(1e300), high = Vector2::Constant(-1e300);
};

PieceBox box_of(const Unfolding& unfolding, Index piece, double angle) {
  const PiecePlacement turn{0, angle, Vector2::Zero()};
  PieceBox out;
  for (const Index facet : unfolding.pieces[piece].facets)
    for (const Vector2& corner : unfolding.corners[facet]) {
      const Vector2 p = turn.apply(corner);
      out.low = out.low.cwiseMin(p);
      out.high = out.high.cwiseMax(p);
    }
  return out;
}

/// Present places of facets and strips, without piece `moved`.
KnownPlaces places_in(const Unfolding& unfolding, Index moved = no_index) {
  KnownPlaces out;
  out.piece = [&unfolding, moved](Index facet, const FacetCorners& corners) -> std::optional<PiecePlacement> {
    if (unfolding.piece_of[facet] == moved) return {};
    return placement_between(corners, unfolding.corners[facet], unfolding.page_of(facet));
  };
  out.strip = [&unfolding](const FacetEdge& edge) -> std::optional<PiecePlacement> {
    const Index joint = unfolding.joint_at(unfolding.graph->find_edge(edge.low, edge.high));
    if (joint == no_index || unfolding.joints[joint].tab) return {};
    return unfolding.strips[joint];
  };
  return out;
}

}  // namespace

Result<Unfolding> join_at(const Unfolding& unfolding, Index e) {
  const FacetEdge& edge = unfolding.graph->edge(e);
  if (edge.border()) return border_error(unfolding, e);
  if (unfolding.folds[e])
    return make_error(e_already_folded, "The edge is a fold already.", "Choose a cut edge.",
                      named_edge(unfolding, e));
  const Index first = unfolding.piece_of[edge.facets[0]], second = unfolding.piece_of[edge.facets[1]];
  if (first == second)
    return make_error(e_same_piece,
                      "Both sides of the edge belong to one piece; joined they would close a ring.",
                      "Split the piece elsewhere first.", named_edge(unfolding, e));
  Folds folds = unfolding.folds;
  folds[e] = 1;
  EdgeRules wishes = unfolding.wishes;
  wishes[e] = EdgeRule::folded;
  // The smaller piece loses its place.
  const std::size_t sizes[] = {unfolding.pieces[first].facets.size(), unfolding.pieces[second].facets.size()};
  const Index moved = sizes[0] < sizes[1] ? first : second;
  return assemble(unfolding.graph, unfolding.settings, std::move(folds), std::move(wishes),
                  unfolding.tab_choices, places_in(unfolding, moved));
}

Result<Unfolding> split_at(const Unfolding& unfolding, Index e) {
  if (unfolding.graph->edge(e).border()) return border_error(unfolding, e);
  if (!unfolding.folds[e])
    return make_error(e_already_cut, "The edge is cut already.", "Choose a fold.", named_edge(unfolding, e));
  if (unfolding.graph->edge(e).inner)
    return make_error(e_inside_face, "The line lies within a flat face, which stays whole.",
                      "Choose an edge of the face.", named_edge(unfolding, e));
  Folds folds = unfolding.folds;
  folds[e] = 0;
  EdgeRules wishes = unfolding.wishes;
  wishes[e] = EdgeRule::cut;
  return assemble(unfolding.graph, unfolding.settings, std::move(folds), std::move(wishes),
                  unfolding.tab_choices, places_in(unfolding));
}

Result<Unfolding> split_aside(const Unfolding& unfolding, Index e) {
  auto split = split_at(unfolding, e);
  if (!split) return split;
  const FacetEdge& edge = unfolding.graph->edge(e);
  const auto facets = [&](std::size_t k) {
    return split->pieces[split->piece_of[edge.facets[k]]].facets.size();
  };
  const Index smaller = split->piece_of[edge.facets[facets(0) < facets(1) ? 0 : 1]];
  return assemble(split->graph, split->settings, split->folds, split->wishes, split->tab_choices,
                  places_in(*split, smaller));
}

Unfolding move_piece(const Unfolding& unfolding, Index piece, Index page, const Vector2& shift) {
  PiecePlacement placement = unfolding.pieces[piece].placement;
  placement.page = page;
  placement.offset += shift;
  return with_placement(unfolding, piece, placement);
}

Unfolding turn_piece(const Unfolding& unfolding, Index piece, double angle) {
  const PieceBox box = box_of(unfolding, piece, 0);
  return with_placement(unfolding, piece,
                        unfolding.pieces[piece].placement.turned(angle, 0.5 * (box.low + box.high)));
}

Unfolding straighten_piece(const Unfolding& unfolding, Index piece) {
  // The smallest box has a side along a side of the convex hull, hence along a line between two extreme
  // corners; sides of facets and every half degree approximate it closely enough for paper.
  double best_angle = 0, best_area = 1e300;
  const auto consider = [&](double angle) {
    angle = std::remainder(angle, pi / 2);
    const PieceBox box = box_of(unfolding, piece, angle);
    const double area = (box.high.x() - box.low.x()) * (box.high.y() - box.low.y());
    const bool better = area < best_area * (1 - 1e-9);
    if (!better && !(area <= best_area * (1 + 1e-9) && std::abs(angle) < std::abs(best_angle))) return;
    best_area = std::min(area, best_area);
    best_angle = angle;
  };
  for (int k = -90; k < 90; ++k) consider(k * pi / 360);
  const std::size_t stride = unfolding.pieces[piece].facets.size() / 200 + 1;
  for (std::size_t f = 0; f < unfolding.pieces[piece].facets.size(); f += stride) {
    const FacetCorners& c = unfolding.corners[unfolding.pieces[piece].facets[f]];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector2 side = c[(k + 1) % 3] - c[k];
      consider(-std::atan2(side.y(), side.x()));
    }
  }
  return turn_piece(unfolding, piece, best_angle);
}

Unfolding choose_tab(const Unfolding& unfolding, Index edge, TabChoice choice) {
  std::vector<TabChoice> choices = unfolding.tab_choices;
  choices[edge] = choice;
  return assemble(unfolding.graph, unfolding.settings, unfolding.folds, unfolding.wishes, std::move(choices),
                  places_in(unfolding));
}

Unfolding rearrange(const Unfolding& unfolding) {
  return assemble(unfolding.graph, unfolding.settings, unfolding.folds, unfolding.wishes,
                  unfolding.tab_choices);
}

Unfolding split_to_fit(const Unfolding& unfolding, Index piece) {
  const FacetGraph& graph = *unfolding.graph;
  EdgeRules rules(graph.edge_count(), EdgeRule::cut);
  for (Index e = 0; e < rules.size(); ++e) {
    if (!unfolding.folds[e]) continue;
    const bool inside = unfolding.piece_of[graph.edge(e).facets[0]] == piece;
    const bool held = unfolding.wishes[e] == EdgeRule::folded || graph.edge(e).inner;
    rules[e] = inside && !held ? EdgeRule::free : EdgeRule::folded;
  }
  const std::vector<FacetCorners> shapes = facet_shapes(graph, unfolding.settings.scale);
  const auto found = search_cuts(graph, shapes, rules, {unfolding.settings.piece_room(), 0});
  return assemble(unfolding.graph, unfolding.settings, found.value().back(), unfolding.wishes,
                  unfolding.tab_choices, places_in(unfolding));
}

std::vector<std::pair<Index, Index>> overlaps_of(const Unfolding& unfolding) {
  return overlapping_pairs(printed_polygons(unfolding), paper_tolerance(unfolding));
}

std::vector<Index> pieces_off_page(const Unfolding& unfolding) {
  const PaperSettings& s = unfolding.settings;
  std::vector<char> off(unfolding.pieces.size(), 0);
  const auto look = [&](std::span<const Vector2> polygon, Index piece) {
    for (const Vector2& p : polygon)
      if (p.x() < s.margin - 1e-6 || p.y() < s.margin - 1e-6 || p.x() > s.page.width - s.margin + 1e-6 ||
          p.y() > s.page.height - s.margin + 1e-6)
        off[piece] = 1;
  };
  for (Index f = 0; f < unfolding.corners.size(); ++f) look(unfolding.corners[f], unfolding.piece_of[f]);
  for (const Joint& joint : unfolding.joints)
    if (joint.tab) look(joint.tab->corners, unfolding.piece_of[joint.tab->facet]);
  std::vector<Index> out;
  for (Index p = 0; p < off.size(); ++p)
    if (off[p]) out.push_back(p);
  return out;
}

}  // namespace hariko

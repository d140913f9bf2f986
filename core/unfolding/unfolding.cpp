#include "core/unfolding/unfolding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/ids.hpp"
#include "core/polyhedron/message_group.hpp"
#include "core/unfolding/cuts/best_rotation.hpp"
#include "core/unfolding/cuts/convex_overlap.hpp"
#include "core/unfolding/cuts/reference_method.hpp"

namespace hariko {

namespace {

/// Rectangle of a strip in its own frame.
std::array<Vector2, 4> strip_shape(double length, double width) {
  return {Vector2(0, -width / 2), Vector2(length, -width / 2), Vector2(length, width / 2),
          Vector2(0, width / 2)};
}

double strip_length(const FacetGraph& graph, const PaperSettings& settings, Index edge) {
  return settings.scale * graph.edge(edge).length;
}

PackItem strip_item(double length, const PaperSettings& settings) {
  return {{SheetPolygon(strip_shape(length, settings.strip_width), 0)}, false};
}

/// Runs of strips that fit on a page.
std::vector<StripRun> runs_of(const FacetGraph& graph, const FlatLayout& layout,
                              const std::vector<Joint>& joints, const PaperSettings& settings) {
  const PaperSize room = settings.printable_area();
  return strip_runs(graph, layout, joints, settings, std::max(room.width, room.height));
}

/// Places the strips of a run end to end.
void lay_run(const StripRun& run, const PiecePlacement& place, Unfolding& out) {
  double x = 0;
  for (const Index j : run.joints) {
    out.strips[j] = place;
    out.strips[j].offset = place.apply(Vector2(x, 0));
    x += strip_length(*out.graph, out.settings, out.joints[j].edge);
  }
}

/// Items to pack: pieces with their tabs, then runs of strips.
std::vector<PackItem> pack_items(const PaperSettings& settings, const FlatLayout& layout,
                                 const std::vector<Joint>& joints, const std::vector<StripRun>& runs) {
  std::vector<PackItem> items(layout.pieces.size());
  for (Index f = 0; f < layout.corners.size(); ++f)
    items[layout.piece_of[f]].polygons.emplace_back(layout.corners[f], 0);
  for (const Joint& joint : joints)
    if (joint.tab) items[layout.piece_of[joint.tab->facet]].polygons.emplace_back(joint.tab->corners, 0);
  for (const StripRun& run : runs) items.push_back(strip_item(run.length, settings));
  return items;
}

PackOptions pack_options(const PaperSettings& settings, std::size_t pieces) {
  PackOptions out{settings.page, settings.margin, settings.gap};
  out.tries = pieces <= 60 ? 12 : (pieces <= 200 ? 3 : 1);
  return out;
}

/// Places the strips whose place is known and calls `tell` for each. Returns those without a place: whole
/// runs, or single strips of runs that are partly placed.
template <class Tell>
std::vector<StripRun> keep_strips(Unfolding& out, const KnownPlaces& known, Tell&& tell) {
  std::vector<StripRun> loose;
  for (const StripRun& run : out.strip_runs) {
    std::vector<StripRun> single;
    for (const Index j : run.joints) {
      if (const auto place = known.strip(out.graph->edge(out.joints[j].edge))) {
        out.strips[j] = *place;
        tell(j);
      } else {
        single.push_back({{j}, strip_length(*out.graph, out.settings, out.joints[j].edge)});
      }
    }
    if (single.size() == run.joints.size()) single = {run};
    loose.insert(loose.end(), single.begin(), single.end());
  }
  return loose;
}

/// Keeps known places and packs the other pieces where there is room.
void keep_places(Unfolding& out, const FlatLayout& layout, const KnownPlaces& known) {
  std::vector<char> placed(out.pieces.size(), 0);
  for (std::size_t p = 0; p < out.pieces.size(); ++p) {
    // The placed facet nearest to the root determines the place.
    for (const Index facet : out.pieces[p].facets) {
      const auto place = known.piece(facet, layout.corners[facet]);
      if (!place) continue;
      out.pieces[p].placement = *place;
      placed[p] = 1;
      break;
    }
  }
  const auto moved = [](const PackItem& item, const PiecePlacement& placement, PackOptions& options) {
    for (const SheetPolygon& polygon : item.polygons) {
      SheetPolygon there = polygon;
      there.corners = placement.apply(polygon.corners);
      there.sheet = placement.page;
      options.occupied.push_back(there);
    }
  };
  const std::vector<PackItem> all = pack_items(out.settings, layout, out.joints, out.strip_runs);
  PackOptions options = pack_options(out.settings, out.pieces.size());
  options.tries = 1;
  const std::vector<StripRun> loose = keep_strips(out, known, [&](Index j) {
    moved(strip_item(strip_length(*out.graph, out.settings, out.joints[j].edge), out.settings), out.strips[j],
          options);
  });
  std::vector<PackItem> items;
  std::vector<Index> owners;
  for (Index p = 0; p < out.pieces.size(); ++p) {
    if (placed[p]) {
      moved(all[p], out.pieces[p].placement, options);
    } else {
      items.push_back(all[p]);
      owners.push_back(p);
    }
  }
  if (!items.empty()) {
    const Packing packing = pack_pages(items, options);
    for (std::size_t k = 0; k < items.size(); ++k) {
      out.pieces[owners[k]].placement = packing.placements[k];
      moved(items[k], packing.placements[k], options);
    }
  }
  items.clear();
  for (const StripRun& run : loose) items.push_back(strip_item(run.length, out.settings));
  const Packing packing = pack_pages(items, options);
  for (std::size_t k = 0; k < items.size(); ++k) lay_run(loose[k], packing.placements[k], out);
}

void pack_everything(Unfolding& out, const FlatLayout& layout, const CancelToken& cancel) {
  const Packing packing = pack_pages(pack_items(out.settings, layout, out.joints, out.strip_runs),
                                     pack_options(out.settings, out.pieces.size()), cancel);
  std::size_t next = 0;
  for (PaperPiece& piece : out.pieces) piece.placement = packing.placements[next++];
  for (const StripRun& run : out.strip_runs) lay_run(run, packing.placements[next++], out);
}

/// Computes everything that follows from the placements.
void move_to_pages(Unfolding& out, const FlatLayout& layout) {
  out.corners.resize(layout.corners.size());
  for (Index f = 0; f < out.corners.size(); ++f)
    out.corners[f] = out.pieces[out.piece_of[f]].placement.apply(layout.corners[f]);
  out.page_count = 0;
  for (const PaperPiece& piece : out.pieces)
    out.page_count = std::max(out.page_count, piece.placement.page + 1);
  for (Index j = 0; j < out.joints.size(); ++j) {
    Joint& joint = out.joints[j];
    if (joint.tab)
      joint.tab->corners = out.pieces[out.piece_of[joint.tab->facet]].placement.apply(joint.tab->corners);
    else
      out.page_count = std::max(out.page_count, out.strips[j].page + 1);
  }
}

struct Candidate {
  Folds folds;
  std::size_t pieces = 0, strips = 0;
  Index pages = 0;
};

Candidate judged(const FacetGraph& graph, const PaperSettings& settings,
                 const std::vector<FacetCorners>& shapes, Folds folds, const CancelToken& cancel) {
  const FlatLayout layout = lay_out(graph, shapes, folds);
  const std::vector<Joint> joints = find_joints(graph, folds, layout, {}, settings);
  Candidate out;
  out.pieces = layout.pieces.size();
  out.strips = static_cast<std::size_t>(
      std::count_if(joints.begin(), joints.end(), [](const Joint& joint) { return !joint.tab; }));
  PackOptions options = pack_options(settings, out.pieces);
  options.tries = 1;
  const std::vector<StripRun> runs = runs_of(graph, layout, joints, settings);
  out.pages = pack_pages(pack_items(settings, layout, joints, runs), options, cancel).page_count;
  out.folds = std::move(folds);
  return out;
}

/// Score of a candidate for a goal; the lowest is best.
std::array<double, 3> score(const Candidate& candidate, CutGoal goal) {
  const double pieces = double(candidate.pieces), strips = double(candidate.strips);
  switch (goal) {
    case CutGoal::balanced:
      return {pieces + double(candidate.pages) + 0.05 * strips, pieces, strips};
    case CutGoal::easiest:
      return {strips + 0.5 * pieces, pieces, double(candidate.pages)};
    case CutGoal::fewest:
      break;
  }
  return {pieces, double(candidate.pages), strips};
}

Folds best_candidate(const FacetGraph& graph, const PaperSettings& settings,
                     const std::vector<FacetCorners>& shapes, std::vector<Folds> candidates, CutGoal goal,
                     const CancelToken& cancel) {
  const std::size_t fewest = piece_count(graph, candidates.back());
  if (goal == CutGoal::fewest)
    std::erase_if(candidates, [&](const Folds& folds) { return piece_count(graph, folds) > fewest; });
  if (candidates.size() == 1) return candidates.front();
  std::optional<Candidate> best;
  for (Folds& folds : candidates) {
    Candidate next = judged(graph, settings, shapes, std::move(folds), cancel);
    if (!best || score(next, goal) < score(*best, goal)) best = std::move(next);
  }
  return best->folds;
}

/// Best rotation of a piece's facets on the page.
BestTurn best_fit(const Unfolding& unfolding, const PaperPiece& piece) {
  std::vector<Vector2> points;
  for (const Index facet : piece.facets)
    points.insert(points.end(), unfolding.corners[facet].begin(), unfolding.corners[facet].end());
  return best_turn(points, unfolding.settings.piece_room());
}

std::string rounded(double value, int decimals) {
  const double power = std::pow(10, decimals);
  const auto scaled = static_cast<std::int64_t>(std::floor(value * power));
  std::string out = std::to_string(scaled / static_cast<std::int64_t>(power));
  if (decimals > 0) out += "." + std::to_string(scaled % static_cast<std::int64_t>(power));
  return out;
}

/// Reports pieces marked in `off` that fit the page in no rotation; pieces that were only moved off the page
/// are not reported.
void report_too_large(const Unfolding& unfolding, const std::vector<char>& off, std::vector<Message>& out) {
  constexpr std::size_t limit = 20;
  std::vector<std::pair<Index, BestTurn>> large;
  double factor = 1;
  for (Index p = 0; p < off.size(); ++p) {
    if (!off[p]) continue;
    const BestTurn fit = best_fit(unfolding, unfolding.pieces[p]);
    if (fit.factor < 1) large.emplace_back(p, fit);
    factor = std::min(factor, fit.factor);
  }
  MessageGroup group(out, Severity::error, e_piece_too_large,
                     "Scale to " + rounded(100 * factor, 1) + " %, split the piece, or choose a larger page.",
                     limit);
  for (const auto& [p, fit] : large)
    group.add(element_of(FaceId{unfolding.pieces[p].facets.front()}), [p = p, fit = fit] {
      return "Piece " + piece_name(p) + ": piece " + std::to_string(p) +
             " does not fit on the page at this scale (needs " + rounded(fit.size.width + 0.5, 0) + " x " +
             rounded(fit.size.height + 0.5, 0) + " mm).";
    });
}

/// Longest extent of the finished model, mm.
double largest_extent(const Unfolding& unfolding) {
  const FacetGraph& graph = *unfolding.graph;
  Vector3 low = Vector3::Constant(1e300), high = -low;
  for (Index f = 0; f < graph.facet_count(); ++f)
    for (const Index v : graph.triangle(f)) {
      low = low.cwiseMin(graph.positions()[v]);
      high = high.cwiseMax(graph.positions()[v]);
    }
  return unfolding.settings.scale * (high - low).maxCoeff();
}

void report_size(const Unfolding& unfolding, std::vector<Message>& out) {
  const double extent = largest_extent(unfolding);
  if (extent >= smallest_paper_model && extent <= largest_paper_model) return;
  const std::string size = extent < 1000 ? rounded(extent, 2) + " mm" : rounded(extent / 1000, 2) + " m";
  out.push_back(make_warning(w_paper_size,
                             "The finished model is " + size + (extent < 1000 ? " small." : " large."),
                             "Give its height, width or depth in mm, or check the unit of the file."));
}

bool within_margins(const Unfolding& unfolding, std::span<const Vector2> polygon) {
  const PaperSettings& s = unfolding.settings;
  return std::all_of(polygon.begin(), polygon.end(), [&](const Vector2& p) {
    return p.x() >= s.margin - 1e-6 && p.y() >= s.margin - 1e-6 && p.x() <= s.page.width - s.margin + 1e-6 &&
           p.y() <= s.page.height - s.margin + 1e-6;
  });
}

}  // namespace

Index Unfolding::joint_at(Index edge) const {
  const auto found = std::lower_bound(joints.begin(), joints.end(), edge,
                                      [](const Joint& joint, Index e) { return joint.edge < e; });
  return found != joints.end() && found->edge == edge ? static_cast<Index>(found - joints.begin()) : no_index;
}

std::array<Vector2, 4> strip_corners(const Unfolding& unfolding, Index joint) {
  const double length = strip_length(*unfolding.graph, unfolding.settings, unfolding.joints[joint].edge);
  return unfolding.strips[joint].apply(strip_shape(length, unfolding.settings.strip_width));
}

Index numbered_as(const Unfolding& unfolding, Index joint) {
  const Index run = unfolding.run_of[joint];
  if (run == no_index) return joint;
  const auto& joints = unfolding.strip_runs[run].joints;
  return *std::min_element(joints.begin(), joints.end());
}

bool follows(const Unfolding& unfolding, Index first, Index second) {
  const PiecePlacement &a = unfolding.strips[first], &b = unfolding.strips[second];
  const double length = strip_length(*unfolding.graph, unfolding.settings, unfolding.joints[first].edge);
  constexpr double touching = 1e-6;  // mm
  return a.page == b.page && (a.apply(Vector2(length, 0)) - b.apply(Vector2(0, 0))).norm() < touching &&
         std::abs(std::remainder(a.angle - b.angle, 2 * std::numbers::pi)) < 1e-9;
}

std::vector<SheetPolygon> printed_polygons(const Unfolding& unfolding) {
  std::vector<SheetPolygon> out;
  for (Index f = 0; f < unfolding.corners.size(); ++f)
    out.emplace_back(unfolding.corners[f], unfolding.page_of(f));
  for (Index j = 0; j < unfolding.joints.size(); ++j) {
    const Joint& joint = unfolding.joints[j];
    if (joint.tab)
      out.emplace_back(joint.tab->corners, unfolding.page_of(joint.tab->facet));
    else
      out.emplace_back(strip_corners(unfolding, j), unfolding.strips[j].page);
  }
  return out;
}

double paper_tolerance(const Unfolding& unfolding) {
  return overlap_tolerance * unfolding.settings.scale * unfolding.graph->longest_edge();
}

std::string piece_name(Index piece) {
  std::string out;
  for (std::uint64_t rest = std::uint64_t{piece} + 1; rest > 0; rest = (rest - 1) / 26)
    out.insert(out.begin(), static_cast<char>('A' + (rest - 1) % 26));
  return out;
}

double paper_use(const Unfolding& unfolding) {
  const PaperSettings& s = unfolding.settings;
  const double pages = s.printable_area().width * s.printable_area().height * unfolding.page_count;
  return pages > 0 ? s.scale * s.scale * unfolding.graph->total_area() / pages : 0;
}

std::size_t strip_count(const Unfolding& unfolding) {
  return static_cast<std::size_t>(std::count_if(unfolding.joints.begin(), unfolding.joints.end(),
                                                [](const Joint& joint) { return !joint.tab; }));
}

double fitting_factor(const Unfolding& unfolding) {
  double factor = 1;
  for (const PaperPiece& piece : unfolding.pieces)
    factor = std::min(factor, best_fit(unfolding, piece).factor);
  return factor;
}

Unfolding assemble(std::shared_ptr<const FacetGraph> graph, const PaperSettings& settings, Folds folds,
                   EdgeRules wishes, std::vector<TabChoice> tab_choices, const KnownPlaces& known) {
  Unfolding out;
  out.graph = std::move(graph);
  out.settings = settings;
  out.folds = std::move(folds);
  out.wishes = std::move(wishes);
  out.tab_choices = std::move(tab_choices);
  out.wishes.resize(out.graph->edge_count(), EdgeRule::free);
  out.tab_choices.resize(out.graph->edge_count(), TabChoice::automatic);
  FlatLayout layout = lay_out(*out.graph, facet_shapes(*out.graph, settings.scale), out.folds);
  out.joints = find_joints(*out.graph, out.folds, layout, out.tab_choices, settings);
  out.strips.resize(out.joints.size());
  out.strip_runs = runs_of(*out.graph, layout, out.joints, settings);
  out.run_of.assign(out.joints.size(), no_index);
  for (Index r = 0; r < out.strip_runs.size(); ++r)
    for (const Index j : out.strip_runs[r].joints) out.run_of[j] = r;
  out.piece_of = layout.piece_of;
  out.pieces.resize(layout.pieces.size());
  for (std::size_t p = 0; p < out.pieces.size(); ++p)
    out.pieces[p].facets = std::move(layout.pieces[p].facets);
  if (known.piece)
    keep_places(out, layout, known);
  else
    pack_everything(out, layout, {});
  move_to_pages(out, layout);
  return out;
}

Result<Unfolding> unfold(std::shared_ptr<const FacetGraph> graph, const PaperSettings& settings,
                         const UnfoldOptions& options, const CancelToken& cancel, const Progress& progress) {
  if (const auto fine = check_settings(settings, graph->longest_edge()); !fine.ok()) return fine.error();
  const std::vector<FacetCorners> shapes = facet_shapes(*graph, settings.scale);
  Folds folds;
  if (options.method == CutMethod::reference) {
    auto found = reference_unfolding(*graph, shapes, cancel);
    if (!found.ok()) return found.error();
    folds = std::move(found).value().folds;
  } else {
    // Slightly smaller than the page's room, so that the packer, which has its own steps of rotation, finds
    // one that fits.
    const PaperSize room{settings.piece_room().width - 0.2, settings.piece_room().height - 0.2};
    const EdgeRules rules =
        settled_rules(*graph, shapes, options.wishes, settings.merge_angle.value_or(-1), room);
    auto found = search_cuts(*graph, shapes, rules, {.room = room, .steps = options.steps}, cancel,
                             progress.part(0, 0.8));
    if (!found.ok()) return found.error();
    folds = best_candidate(*graph, settings, shapes, std::move(found).value(), options.goal, cancel);
  }
  if (cancel.cancelled()) return make_error(e_cancelled, "Unfolding was cancelled.");
  progress.report(0.9);
  Unfolding out = assemble(std::move(graph), settings, std::move(folds), options.wishes, {});
  progress.report(1);
  return out;
}

std::vector<Message> unfolding_messages(const Unfolding& unfolding) {
  std::vector<Message> out;
  const std::vector<SheetPolygon> polygons = printed_polygons(unfolding);
  std::vector<char> off(unfolding.pieces.size(), 0);
  for (Index f = 0; f < unfolding.corners.size(); ++f)
    if (!within_margins(unfolding, polygons[f].span())) off[unfolding.piece_of[f]] = 1;
  report_size(unfolding, out);
  report_too_large(unfolding, off, out);
  const auto pairs = overlapping_pairs(polygons, paper_tolerance(unfolding));
  if (!pairs.empty())
    out.push_back(make_warning(w_unfolding_overlaps,
                               std::to_string(pairs.size()) + " pairs of facets, tabs or strips overlap.",
                               "Split the pieces there, or move them apart."));
  return out;
}

}  // namespace hariko

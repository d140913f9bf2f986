// The search for cuts: no overlaps, and no more pieces than allowed below.

#include "core/unfolding/cuts/cut_search.hpp"

#include <chrono>
#include <thread>

#include "core/base/cancellation.hpp"
#include "core/base/parallel.hpp"
#include "core/unfolding/cuts/reference_method.hpp"
#include "core/unfolding/pages/sheet_overlaps.hpp"
#include "tests/unfolding/check_layout.hpp"
#include "tests/unfolding/meshes.hpp"

namespace hariko::test {
namespace {

CheckedLayout checked_folds(const FacetGraph& graph, const Folds& folds, double scale) {
  const FlatLayout layout = lay_out(graph, facet_shapes(graph, scale), folds);
  CheckedLayout out{scale, layout.corners, layout.piece_of, layout.piece_of, {}};
  for (Index e = 0; e < graph.edge_count(); ++e)
    if (folds[e]) out.folds.emplace_back(graph.edge(e).facets[0], graph.edge(e).facets[1]);
  return out;
}

struct TableRow {
  const char* name;
  PolygonMesh mesh;
  std::size_t most_pieces;
};

std::vector<TableRow> table() {
  std::vector<TableRow> out = {{"ico320", icosphere(2), 1},
                               {"ico1280", icosphere(3), 1},
                               {"torus576", torus_facets(24, 12), 1},
                               {"torus2000", torus_facets(50, 20), 1}};
  for (const auto& [name, most] : {std::pair{"star1280", 6},
                                   {"wave800", 14},
                                   {"saddle800", 14},
                                   {"dome_opt", 1},
                                   {"fender_opt", 1},
                                   {"wave_opt", 3}})
    out.push_back({name, golden_facets(name), static_cast<std::size_t>(most)});
  return out;
}

TEST(CutSearch, NoOverlapsAndNoMorePiecesThanTheTable) {
  for (const TableRow& row : table()) {
    SCOPED_TRACE(row.name);
    const auto graph = must(FacetGraph::build(row.mesh));
    const auto shapes = facet_shapes(*graph, 1);
    // A third of the default budget: more pieces than it would find, but within the table.
    const auto found = must(search_cuts(*graph, shapes, {}, {.steps = 100'000}));
    EXPECT_LE(piece_count(*graph, found->back()), row.most_pieces);
    check_layout(row.mesh, checked_folds(*graph, found->back(), 1));
  }
}

TEST(CutSearch, EveryCandidateOfRandomMeshesIsFreeOfOverlaps) {
  for_random(31, 15, [&](std::mt19937_64& rng) {
    PolygonMesh mesh = random_sheet(rng);
    if (chance(rng, 0.3)) mesh = side_by_side({mesh, icosphere(1), random_sheet(rng)});
    const auto graph = must(FacetGraph::build(mesh));
    const double scale = log_uniform(rng, 0.5, 50);
    const auto shapes = facet_shapes(*graph, scale);
    CutSearch search{.steps = 3000};
    if (chance(rng, 0.5))
      search.room = {scale * graph->longest_edge() * uniform(rng, 1, 4), scale * graph->longest_edge() * 3};
    const auto found = must(search_cuts(*graph, shapes, {}, search));
    for (const Folds& folds : *found) {
      check_layout(mesh, checked_folds(*graph, folds, scale));
      EXPECT_GE(piece_count(*graph, folds), graph->component_count());
      EXPECT_GE(piece_count(*graph, folds), piece_count(*graph, found->back()));
    }
  });
}

TEST(CutSearch, PiecesStayWithinTheRoom) {
  const auto graph = must(FacetGraph::build(torus_facets(24, 12)));
  const auto shapes = facet_shapes(*graph, 40);
  const PaperSize room{150, 230};
  const auto found = must(search_cuts(*graph, shapes, {}, {.room = room, .steps = 20'000}));
  for (const Folds& folds : *found) {
    const FlatLayout layout = lay_out(*graph, shapes, folds);
    for (const LaidPiece& piece : layout.pieces) {
      // Some turn of the piece fits; 1/20 of a degree tells as finely as matters.
      bool fits = false;
      for (int k = 0; k < 3600 && !fits; ++k) {
        const double angle = k * std::numbers::pi / 3600;
        const Vector2 x(std::cos(angle), std::sin(angle)), y(-x.y(), x.x());
        Vector2 low(1e9, 1e9), high(-1e9, -1e9);
        for (const Index f : piece.facets)
          for (const Vector2& corner : layout.corners[f]) {
            const Vector2 p(x.dot(corner), y.dot(corner));
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
          }
        fits = high.x() - low.x() <= room.width + 1e-9 && high.y() - low.y() <= room.height + 1e-9;
      }
      EXPECT_TRUE(fits);
    }
  }
}

TEST(CutSearch, TheSameInputGivesTheSameSheet) {
  const auto graph = must(FacetGraph::build(golden_facets("wave_opt")));
  const auto shapes = facet_shapes(*graph, 1);
  const auto first = must(search_cuts(*graph, shapes, {}, {.steps = 20'000}));
  const ParallelLimit serial(1);
  const auto second = must(search_cuts(*graph, shapes, {}, {.steps = 20'000}));
  EXPECT_EQ(*first, *second);
}

TEST(CutSearch, RulesAreKept) {
  for_random(32, 10, [&](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_sheet(rng);
    const auto graph = must(FacetGraph::build(mesh));
    const auto shapes = facet_shapes(*graph, 1);
    EdgeRules wishes(graph->edge_count(), EdgeRule::free);
    for (Index e = 0; e < wishes.size(); ++e)
      if (chance(rng, 0.2) && !graph->edge(e).border())
        wishes[e] = chance(rng, 0.5) ? EdgeRule::cut : EdgeRule::folded;
    const EdgeRules rules = settled_rules(*graph, shapes, wishes, -1, {});
    const auto found = must(search_cuts(*graph, shapes, rules, {.steps = 2000}));
    for (const Folds& folds : *found) {
      for (Index e = 0; e < folds.size(); ++e) {
        EXPECT_TRUE(rules[e] != EdgeRule::folded || folds[e]) << e;
        EXPECT_TRUE(wishes[e] != EdgeRule::cut || !folds[e]) << e;
      }
      check_layout(mesh, checked_folds(*graph, folds, 1));
    }
  });
}

TEST(CutSearch, CoplanarFacetsStayTogether) {
  // Quads of a torus are planar: with merging none of their diagonals is cut.
  const auto graph = must(FacetGraph::build(torus_facets(24, 12)));
  const auto shapes = facet_shapes(*graph, 1);
  const EdgeRules rules = settled_rules(*graph, shapes, {}, 1e-9, {});
  EXPECT_EQ(std::count(rules.begin(), rules.end(), EdgeRule::folded), 288);
  const auto found = must(search_cuts(*graph, shapes, rules, {.steps = 20'000}));
  for (Index e = 0; e < graph->edge_count(); ++e)
    EXPECT_TRUE(std::abs(graph->edge(e).fold_angle) > 1e-9 || found->back()[e]);
}

TEST(CutSearch, CanBeCancelledAndReports) {
  const auto graph = must(FacetGraph::build(golden_facets("wave800")));
  const auto shapes = facet_shapes(*graph, 1);
  const CancelToken cancel = CancelToken::make();
  const Progress progress = Progress::make();
  std::thread canceller([&] {
    while (progress.fraction() < 0.2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    cancel.cancel();
  });
  const auto found = search_cuts(*graph, shapes, {}, {.steps = 1'000'000'000'000}, cancel, progress);
  canceller.join();
  must_fail(found, e_cancelled);
}

TEST(ReferenceMethod, LeavesWhatTheSpecificationFound) {
  // Pieces and overlaps that the repair leaves (unfolding.md).
  const auto check = [](const PolygonMesh& mesh, std::size_t pieces, std::size_t overlaps) {
    const auto graph = must(FacetGraph::build(mesh));
    const auto shapes = facet_shapes(*graph, 1);
    const auto found = must(reference_unfolding(*graph, shapes));
    EXPECT_NEAR(double(piece_count(*graph, found->folds)), double(pieces), 0.06 * double(pieces));
    EXPECT_NEAR(double(found->overlapping_pairs), double(overlaps), 2);
    const CheckedLayout layout = checked_folds(*graph, found->folds, 1);
    check_shape(mesh, layout);
    EXPECT_EQ(count_overlaps(layout, 1e-9 * graph->longest_edge()), found->overlapping_pairs);
  };
  check(torus_facets(24, 12), 12, 0);
  check(golden_facets("saddle800"), 94, 0);
  check(golden_facets("wave_opt"), 39, 3);
  check(golden_facets("star1280"), 147, 64);
}

TEST(ReferenceMethod, AtMostTwoInitialCutsAFacet) {
  for_random(33, 10, [&](std::mt19937_64& rng) {
    const auto graph = must(FacetGraph::build(random_sheet(rng)));
    const auto cuts = initial_cuts(*graph);
    for (Index f = 0; f < graph->facet_count(); ++f) {
      int inner = 0, border = 0;
      for (Index side = 0; side < 3; ++side) {
        const Index e = graph->edge_at(f, side);
        ++(graph->edge(e).border() ? border : inner) -= cuts[e] ? 0 : 1;
      }
      EXPECT_LE(inner, std::max(0, 2 - border));
    }
  });
}

}  // namespace
}  // namespace hariko::test

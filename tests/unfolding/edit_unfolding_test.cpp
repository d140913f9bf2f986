// Edits by hand, and a changed mesh.

#include "core/unfolding/edit_unfolding.hpp"

#include "core/unfolding/folding.hpp"
#include "core/unfolding/paper_document.hpp"
#include "tests/unfolding/paper.hpp"

namespace hariko::test {
namespace {

Unfolding model_of(const PolygonMesh& mesh, double size, std::uint64_t steps = 2000) {
  PaperSettings settings;
  settings.scale = scale_for(mesh, 0, size);
  return unfold(shared_graph(mesh), settings, {.steps = steps}).value();
}

Index some_edge(std::mt19937_64& rng, const Unfolding& model, bool folded) {
  for (int tries = 0; tries < 10'000; ++tries) {
    const auto e = static_cast<Index>(rng() % model.graph->edge_count());
    if (!model.graph->edge(e).border() && bool(model.folds[e]) == folded) return e;
  }
  return no_index;
}

TEST(EditUnfolding, RandomEditsKeepShapesAndTrees) {
  for_random(51, 6, [&](std::mt19937_64& rng) {
    const PolygonMesh mesh = chance(rng, 0.5) ? random_sheet(rng) : torus_facets(10, 6);
    Unfolding model = model_of(mesh, 200);
    for (int step = 0; step < 25; ++step) {
      const Unfolding before = model;
      const auto piece = static_cast<Index>(rng() % model.pieces.size());
      switch (uniform_int(rng, 0, 5)) {
        case 0:
          if (const Index e = some_edge(rng, model, true); e != no_index) {
            const auto split = must(split_at(model, e));
            EXPECT_EQ(split->pieces.size(), before.pieces.size() + 1);
            for (Index f = 0; f < mesh.face_count(); ++f)
              for (std::size_t k = 0; k < 3; ++k)
                EXPECT_LT((split->corners[f][k] - before.corners[f][k]).norm(), 1e-9);
            model = *split;
          }
          break;
        case 1:
          if (const Index e = some_edge(rng, model, false); e != no_index) {
            const FacetEdge& edge = model.graph->edge(e);
            const bool same = model.piece_of[edge.facets[0]] == model.piece_of[edge.facets[1]];
            const auto joined = join_at(model, e);
            ASSERT_EQ(joined.ok(), !same);
            EXPECT_TRUE(joined.ok() || joined.error().code == e_same_piece);
            if (joined.ok()) model = *joined;
          }
          break;
        case 2:
          model = move_piece(model, piece, static_cast<Index>(uniform_int(rng, 0, 2)),
                             {uniform(rng, -20, 20), uniform(rng, -20, 20)});
          break;
        case 3:
          model = turn_piece(model, piece, uniform(rng, -3, 3));
          break;
        case 4:
          if (const Index e = some_edge(rng, model, false); e != no_index)
            model = choose_tab(model, e, static_cast<TabChoice>(uniform_int(rng, 0, 3)));
          break;
        default:
          model = straighten_piece(model, piece);
      }
      check_shape(mesh, checked_layout(model));
    }
    model = rearrange(model);
    check_shape(mesh, checked_layout(model));
    EXPECT_EQ(overlaps_of(model).size() - count_overlaps(checked_layout(model), paper_tolerance(model)), [&] {
      const auto pairs = overlaps_of(model);
      return static_cast<std::size_t>(std::count_if(
          pairs.begin(), pairs.end(), [&](const auto& pair) { return pair.second >= mesh.face_count(); }));
    }());
  });
}

TEST(EditUnfolding, SplitAndJoinGiveTheSameSheetAgain) {
  const Unfolding model = model_of(golden_facets("wave_opt"), 250);
  std::mt19937_64 rng(5);
  const Index e = some_edge(rng, model, true);
  const auto back = must(join_at(split_at(model, e).value(), e));
  EXPECT_EQ(back->folds, model.folds);
  for (Index f = 0; f < model.corners.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LT((back->corners[f][k] - model.corners[f][k]).norm(), 1e-8);
}

TEST(EditUnfolding, RefusalsNameTheEdge) {
  const Unfolding model = model_of(golden_facets("wave_opt"), 250);
  std::mt19937_64 rng(6);
  EXPECT_EQ(join_at(model, some_edge(rng, model, true)).error().code, e_already_folded);
  EXPECT_EQ(split_at(model, some_edge(rng, model, false)).error().code, e_already_cut);
  Index border = 0;
  while (!model.graph->edge(border).border()) ++border;
  EXPECT_EQ(split_at(model, border).error().code, e_edge_on_border);
  EXPECT_EQ(join_at(model, border).error().code, e_edge_on_border);
}

TEST(EditUnfolding, OverlapsAndPagesAreSeenAtOnce) {
  Unfolding model = model_of(torus_facets(24, 12), 250);
  ASSERT_GE(model.pieces.size(), 2U);
  EXPECT_TRUE(overlaps_of(model).empty());
  EXPECT_TRUE(pieces_off_page(model).empty());
  const auto& first = model.pieces[0].placement;
  const Vector2 shift =
      model.corners[model.pieces[0].facets[0]][0] - model.corners[model.pieces[1].facets[0]][0];
  const Unfolding stacked = move_piece(model, 1, first.page, shift);
  EXPECT_FALSE(overlaps_of(stacked).empty());
  const Unfolding away = move_piece(model, 0, first.page, {500, 0});
  EXPECT_EQ(pieces_off_page(away), std::vector<Index>{0});
  EXPECT_TRUE(overlaps_of(rearrange(stacked)).empty());
}

TEST(EditUnfolding, StraightPiecesHaveTheSmallestBox) {
  const PolygonMesh mesh = sheet_facets(
      4, [](double, double) { return 0.0; }, [](int, int, int) { return false; });
  Unfolding model = turn_piece(model_of(mesh, 100), 0, 0.7);
  model = straighten_piece(model, 0);
  Vector2 low(1e9, 1e9), high(-1e9, -1e9);
  for (const FacetCorners& corners : model.corners)
    for (const Vector2& p : corners) low = low.cwiseMin(p), high = high.cwiseMax(p);
  EXPECT_NEAR((high - low).prod(), 100.0 * 100.0, 1e-6);
}

TEST(EditUnfolding, TheTabGoesWhereItIsWanted) {
  const Unfolding model = model_of(icosphere(1), 150);
  for (const Joint& joint : model.joints) {
    const FacetEdge& edge = model.graph->edge(joint.edge);
    EXPECT_FALSE(choose_tab(model, joint.edge, TabChoice::strip).joints[model.joint_at(joint.edge)].tab);
    const Unfolding second = choose_tab(model, joint.edge, TabChoice::second);
    const auto& tab = second.joints[second.joint_at(joint.edge)].tab;
    EXPECT_TRUE(!tab || tab->facet == edge.facets[1]);
    // On the page it may meet another piece; on its own piece it overlaps nothing.
    EXPECT_EQ(overlaps_of(rearrange(second)).size(), 0U);
  }
}

/// A part that was split off goes where it covers nothing, and the rest stays.
TEST(EditUnfolding, SplitAsideLeavesNoOverlaps) {
  for_random(52, 4, [&](std::mt19937_64& rng) {
    Unfolding model = model_of(torus_facets(10, 6), 150);
    ASSERT_TRUE(overlaps_of(model).empty());
    for (int step = 0; step < 5; ++step) {
      const Index e = some_edge(rng, model, true);
      if (e == no_index) return;
      const Unfolding before = model;
      model = split_aside(model, e).value();
      EXPECT_EQ(model.pieces.size(), before.pieces.size() + 1);
      EXPECT_TRUE(overlaps_of(model).empty()) << step;
      EXPECT_TRUE(pieces_off_page(model).empty()) << step;
      const FacetEdge& edge = model.graph->edge(e);
      const auto facets = [&](std::size_t k) {
        return model.pieces[model.piece_of[edge.facets[k]]].facets.size();
      };
      const Index larger = edge.facets[facets(0) < facets(1) ? 1 : 0];
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_LT((model.corners[larger][k] - before.corners[larger][k]).norm(), 1e-9);
    }
  });
}

TEST(EditUnfolding, SplitToFitBreaksUpOnePiece) {
  PolygonMesh mesh = sheet_facets(
      10, [](double x, double) { return 0.1 * x * x; }, [](int, int, int) { return false; });
  Unfolding model = model_of(mesh, 150);
  ASSERT_EQ(model.pieces.size(), 1U);
  PaperSettings larger = model.settings;
  larger.scale *= 3;
  const Unfolding scaled = assemble(model.graph, larger, model.folds, model.wishes, model.tab_choices);
  ASSERT_EQ(unfolding_messages(scaled).size(), 1U);
  const Unfolding split = rearrange(split_to_fit(scaled, 0));
  EXPECT_TRUE(unfolding_messages(split).empty());
  check_pages(mesh, split);
}

/// Names for a mesh that stands for itself: the numbers of its vertices.
std::vector<PaperVertex> plain_names(const FacetGraph& graph) {
  std::vector<PaperVertex> out(graph.positions().size());
  for (Index v = 0; v < out.size(); ++v) {
    out[v].object = ObjectId{0};
    out[v].side = v;
  }
  return out;
}

/// Kept by a document and restored on another mesh, where vertices are known by their numbers.
Unfolding carried_over(const Unfolding& model, const std::shared_ptr<const FacetGraph>& graph) {
  const PaperModel kept = kept_of(model, plain_names(*model.graph), {});
  auto out = must(restored(kept, graph, plain_names(*graph)));
  return std::move(out).value();
}

TEST(EditUnfolding, WhatADocumentKeepsComesBack) {
  for_random(53, 10, [&](std::mt19937_64& rng) {
    const PolygonMesh mesh = chance(rng, 0.5) ? random_sheet(rng) : icosphere(2);
    Unfolding model = model_of(mesh, uniform(rng, 60, 300));
    for (int k = 0; k < 3; ++k) {
      const Index e = static_cast<Index>(rng() % model.graph->edge_count());
      if (const auto split = split_at(model, e); split.ok()) model = *split;
      if (const auto joined = join_at(model, static_cast<Index>(rng() % model.graph->edge_count()));
          joined.ok())
        model = *joined;
      const Index piece = static_cast<Index>(rng() % model.pieces.size());
      model = move_piece(model, piece, static_cast<Index>(rng() % 3), {uniform(rng, -9, 9), 3});
      model = turn_piece(model, piece, uniform(rng, -3, 3));
      if (const Index cut = some_edge(rng, model, false); cut != no_index)
        model = choose_tab(model, cut, static_cast<TabChoice>(uniform_int(rng, 0, 3)));
    }
    const Unfolding back = carried_over(model, model.graph);
    EXPECT_EQ(back.folds, model.folds);
    EXPECT_EQ(back.wishes, model.wishes);
    EXPECT_EQ(back.tab_choices, model.tab_choices);
    EXPECT_EQ(back.corners, model.corners);
    EXPECT_EQ(back.page_count, model.page_count);
    ASSERT_EQ(back.joints.size(), model.joints.size());
    for (Index j = 0; j < back.joints.size(); ++j) {
      ASSERT_EQ(back.joints[j].tab.has_value(), model.joints[j].tab.has_value());
      if (!back.joints[j].tab)
        EXPECT_EQ(back.strips[j], model.strips[j]);
      else
        for (std::size_t k = 0; k < 4; ++k)
          EXPECT_LT((back.joints[j].tab->corners[k] - model.joints[j].tab->corners[k]).norm(), 1e-9);
    }
    const auto names = plain_names(*model.graph);
    EXPECT_EQ(kept_of(back, names, {}), kept_of(model, names, {}));
  });
}

TEST(EditUnfolding, AChangedMeshKeepsCutsAndPlaces) {
  const PolygonMesh mesh = golden_facets("wave_opt");
  Unfolding model = model_of(mesh, 250);
  std::mt19937_64 rng(7);
  model = split_at(model, some_edge(rng, model, true)).value();
  model = move_piece(model, 0, 0, {3, 4});

  PolygonMesh moved = mesh;
  for (Vector3& p : moved.positions) p.z() *= 1.01;
  const Unfolding after = carried_over(model, shared_graph(moved));
  EXPECT_EQ(after.folds, model.folds);
  EXPECT_EQ(after.wishes, model.wishes);
  for (std::size_t p = 0; p < model.pieces.size(); ++p) {
    EXPECT_EQ(after.pieces[p].placement.page, model.pieces[p].placement.page);
    const Index root = model.pieces[p].facets.front();
    EXPECT_LT((after.corners[root][0] - model.corners[root][0]).norm(), 5);
  }
  check_shape(moved, checked_layout(after));

  // Facets removed and others added: what is left keeps its folds.
  PolygonMesh changed;
  changed.positions = mesh.positions;
  for (std::size_t f = 5; f < mesh.face_count(); ++f) changed.add_face(mesh.face(f));
  const auto graph = shared_graph(changed);
  const Unfolding fewer = carried_over(model, graph);
  for (Index e = 0; e < graph->edge_count(); ++e) {
    const FacetEdge& edge = graph->edge(e);
    if (edge.border()) continue;
    const Index old = model.graph->find_edge(edge.low, edge.high);
    EXPECT_EQ(fewer.folds[e], model.folds[old]) << e;
  }
  check_shape(changed, checked_layout(fewer));
  const Unfolding more = carried_over(fewer, model.graph);
  check_shape(mesh, checked_layout(more));
  EXPECT_LE(more.pieces.size(), model.pieces.size() + 5);
}

TEST(Folding, FromFlatPagesToTheSolid) {
  for_random(52, 6, [&](std::mt19937_64& rng) {
    const PolygonMesh mesh = chance(rng, 0.5) ? random_sheet(rng) : icosphere(1);
    const Unfolding model = model_of(mesh, 150);
    const double scale = model.settings.scale, size = scale * longest_edge_of(mesh);
    const auto flat = folded_positions(model, 0, 230), solid = folded_positions(model, 1, 230);
    const Vector3 shift = solid[0][0] - scale * mesh.positions[mesh.face(0)[0]];
    for (Index f = 0; f < mesh.face_count(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector2 on_page = model.corners[f][k] + Vector2(230.0 * model.page_of(f), 0);
        ASSERT_LT((flat[f][k] - Vector3(on_page.x(), on_page.y(), 0)).norm(), 1e-9 * size);
        ASSERT_LT((solid[f][k] - scale * mesh.positions[mesh.face(f)[k]] - shift).norm(), 1e-8 * size);
      }
    const auto between = folded_positions(model, uniform(rng), 230);
    for (Index f = 0; f < mesh.face_count(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_NEAR((between[f][(k + 1) % 3] - between[f][k]).norm(),
                    (model.corners[f][(k + 1) % 3] - model.corners[f][k]).norm(), 1e-9 * size);
  });
}

}  // namespace
}  // namespace hariko::test

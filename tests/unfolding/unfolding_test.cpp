// Whole paper models: pages, tabs, strips, and how much of the paper they use.

#include "core/unfolding/unfolding.hpp"

#include <numbers>

#include "core/unfolding/edit_unfolding.hpp"
#include "core/unfolding/pages/sheet_drawing.hpp"

#include "tests/unfolding/paper.hpp"

namespace hariko::test {
namespace {

Unfolding unfolded(const PolygonMesh& mesh, const PaperSettings& settings,
                   const UnfoldOptions& options = {}) {
  auto out = must(unfold(shared_graph(mesh), settings, options));
  return std::move(out).value();
}

TEST(Unfolding, RealSizesUseThePaper) {
  struct Row {
    const char* name;
    PolygonMesh mesh;
    int axis;
    double size, least_use;
  };
  const Row rows[] = {{"torus576", torus_facets(24, 12), 0, 250, 0.45},
                      {"ico320", icosphere(2), 2, 200, 0.45},
                      {"wave_opt", golden_facets("wave_opt"), 0, 250, 0.38}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    PaperSettings settings;
    settings.scale = scale_for(row.mesh, row.axis, row.size);
    const Unfolding model = unfolded(row.mesh, settings, {.steps = 50'000});
    EXPECT_GE(paper_use(model), row.least_use);
    check_pages(row.mesh, model);
    EXPECT_TRUE(unfolding_messages(model).empty());
  }
}

TEST(Unfolding, RandomMeshesOnRandomPages) {
  for_random(41, 12, [&](std::mt19937_64& rng) {
    PolygonMesh mesh = random_sheet(rng);
    if (chance(rng, 0.3)) mesh = side_by_side({mesh, icosphere(1), torus_facets(8, 5)});
    const auto graph = shared_graph(mesh);
    PaperSettings settings;
    settings.page = {uniform(rng, 150, 400), uniform(rng, 150, 400)};
    settings.margin = uniform(rng, 0, 15);
    settings.gap = uniform(rng, 0, 4);
    settings.inside = chance(rng, 0.5);
    if (chance(rng, 0.5)) settings.merge_angle = 0.02;
    settings.scale = uniform(rng, 10, 60) / graph->longest_edge();
    UnfoldOptions options{.steps = 2000};
    options.goal = static_cast<CutGoal>(uniform_int(rng, 0, 2));
    const auto model = must(unfold(graph, settings, options));
    check_pages(mesh, *model);
    EXPECT_TRUE(unfolding_messages(*model).empty());
  });
}

TEST(Unfolding, TheReferenceMethodSaysWhatItLeaves) {
  const PolygonMesh mesh = golden_facets("wave_opt");
  PaperSettings settings{.scale = 10};
  UnfoldOptions options{.method = CutMethod::reference};
  const Unfolding model = unfolded(mesh, settings, options);
  check_shape(mesh, checked_layout(model));
  const std::vector<Message> messages = unfolding_messages(model);
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0].code, w_unfolding_overlaps);
}

TEST(Unfolding, APieceThatDoesNotFitIsNamedWithTheScaleThatWould) {
  PaperSettings settings{.scale = 1000};
  const Unfolding model = unfolded(icosphere(0), settings);
  const std::vector<Message> messages = unfolding_messages(model);
  ASSERT_FALSE(messages.empty());
  EXPECT_EQ(messages[0].code, e_piece_too_large);
  EXPECT_NE(messages[0].text.find("does not fit on the page at this scale (needs"), std::string::npos);
  const std::string& remedy = messages[0].remedy;
  double percent = 0;
  ASSERT_EQ(std::sscanf(remedy.c_str(), "Scale to %lf %%", &percent), 1) << remedy;
  settings.scale *= percent / 100;
  EXPECT_TRUE(unfolding_messages(unfolded(icosphere(0), settings)).empty());
  settings.scale *= 1.1;  // the named scale leaves room for tabs
  EXPECT_FALSE(unfolding_messages(unfolded(icosphere(0), settings)).empty());
}

TEST(Unfolding, GoalsTradePiecesForStrips) {
  const PolygonMesh mesh = torus_facets(24, 12);
  PaperSettings settings;
  settings.scale = scale_for(mesh, 0, 120);
  const auto of = [&](CutGoal goal) { return unfolded(mesh, settings, {.goal = goal, .steps = 20'000}); };
  const Unfolding fewest = of(CutGoal::fewest), easiest = of(CutGoal::easiest);
  EXPECT_LE(fewest.pieces.size(), easiest.pieces.size());
  EXPECT_LE(strip_count(easiest), strip_count(fewest));
}

TEST(Unfolding, SettingsThatMakeNoPageAreRefused) {
  const auto graph = shared_graph(icosphere(0));
  PaperSettings settings{.margin = 100};
  EXPECT_EQ(unfold(graph, settings, {}).error().code, e_paper_setting);
  settings = {};
  settings.scale = 1e-12;
  EXPECT_EQ(unfold(graph, settings, {}).error().code, e_paper_setting);
  settings.scale = std::nan("");
  EXPECT_EQ(unfold(graph, settings, {}).error().code, e_paper_setting);
  settings = {};
  settings.page.width = -3;
  EXPECT_EQ(unfold(graph, settings, {}).error().code, e_paper_setting);
}

/// A round can of many narrow sides, closed below, open above.
PolygonMesh can(Index sides) {
  PolygonMesh mesh;
  for (Index k = 0; k < sides; ++k)
    for (const double z : {0.0, 1.0}) {
      const double angle = 2 * std::numbers::pi * k / sides;
      mesh.positions.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  std::vector<Index> bottom;
  for (Index k = 0; k < sides; ++k) {
    const Index a = 2 * k, b = 2 * ((k + 1) % sides);
    mesh.add_face({a, b, b + 1, a + 1});
    bottom.insert(bottom.begin(), a);
  }
  mesh.add_face(bottom);
  return mesh;
}

TEST(Unfolding, StripsInARowAreOneLongStrip) {
  // Sides of 2 mm leave no room for tabs of 2 mm.
  const PolygonMesh mesh = can(94);
  PaperSettings settings{.scale = 30};
  const Unfolding model = unfolded(mesh, settings);
  EXPECT_TRUE(unfolding_messages(model).empty());
  const std::size_t strips = strip_count(model);
  ASSERT_GT(strips, 80U);
  std::size_t joints = 0;
  for (const StripRun& run : model.strip_runs) {
    joints += run.joints.size();
    for (std::size_t k = 0; k + 1 < run.joints.size(); ++k)
      EXPECT_TRUE(follows(model, run.joints[k], run.joints[k + 1]));
    for (const Index j : run.joints) EXPECT_EQ(numbered_as(model, j), numbered_as(model, run.joints[0]));
  }
  EXPECT_EQ(joints, strips);
  EXPECT_LT(model.strip_runs.size(), strips / 3);
  // Printed as one: two long sides and a fold each, two ends a run, and its number.
  const SheetDrawing drawing = draw_sheets(model);
  const auto lines = std::count_if(drawing.lines.begin(), drawing.lines.end(),
                                   [](const DrawnLine& line) { return line.layer == SheetLayer::strip; });
  EXPECT_EQ(std::size_t(lines), 3 * strips + 2 * model.strip_runs.size());
  // Kept by edits.
  EXPECT_EQ(choose_tab(model, 0, model.tab_choices[0]).strips, model.strips);
}

TEST(Unfolding, NamesOfPieces) {
  EXPECT_EQ(piece_name(0), "A");
  EXPECT_EQ(piece_name(25), "Z");
  EXPECT_EQ(piece_name(26), "AA");
  EXPECT_EQ(piece_name(26 + 26 * 26), "AAA");
}

}  // namespace
}  // namespace hariko::test

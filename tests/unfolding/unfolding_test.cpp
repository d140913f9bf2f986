// Whole paper models: pages, tabs, strips, and how much of the paper they use.

#include "core/unfolding/unfolding.hpp"

#include "tests/unfolding/paper.hpp"

namespace hariko::test {
namespace {

Unfolding unfolded(const PolygonMesh& mesh, const PaperSettings& settings,
                   const UnfoldOptions& options = {}) {
  auto out = unfold(shared_graph(mesh), settings, options);
  EXPECT_TRUE(out.ok()) << (out.ok() ? "" : out.error().text);
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
    const auto model = unfold(graph, settings, options);
    ASSERT_TRUE(model.ok());
    check_pages(mesh, *model);
    EXPECT_TRUE(unfolding_messages(*model).empty());
  });
}

TEST(Unfolding, TheReferenceMethodSaysWhatItLeaves) {
  const PolygonMesh mesh = golden_facets("wave_opt");
  PaperSettings settings;
  settings.scale = 10;
  UnfoldOptions options;
  options.method = CutMethod::reference;
  const Unfolding model = unfolded(mesh, settings, options);
  check_shape(mesh, checked_layout(model));
  const std::vector<Message> messages = unfolding_messages(model);
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0].code, w_unfolding_overlaps);
}

TEST(Unfolding, APieceThatDoesNotFitIsNamedWithTheScaleThatWould) {
  PaperSettings settings;
  settings.scale = 1000;
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
  settings.scale *= 1.1;  // what is named leaves room for tabs
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
  PaperSettings settings;
  settings.margin = 100;
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

TEST(Unfolding, NamesOfPieces) {
  EXPECT_EQ(piece_name(0), "A");
  EXPECT_EQ(piece_name(25), "Z");
  EXPECT_EQ(piece_name(26), "AA");
  EXPECT_EQ(piece_name(26 + 26 * 26), "AAA");
}

}  // namespace
}  // namespace hariko::test

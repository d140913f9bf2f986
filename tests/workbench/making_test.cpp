// Checking a part before it is made, by hand: maps of making by palette and menu, the probe, the legend, and
// limits typed in the panel.

#include <algorithm>

#include "core/document/edits/edits.hpp"
#include "core/document/file.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"
#include "ui/editor/legend_source.hpp"
#include "ui/editor/probe.hpp"

namespace hariko {
namespace {

/// An open surface.
Document part_with_a_border() {
  return load_document(test::source_folder() + "/assets/samples/saddle.hariko").value();
}

Document two_parts() {
  Document document = document_from_mesh(test::cube(), "Part").value();
  Similarity place{.translation = {0.125, 0, 0}};
  return add_object(document, "Model", document.objects[0]->source, place)->document;
}

class Making : public ::testing::Test {
 protected:
  void open(Document document) {
    bench_ = std::make_unique<test::HeadlessWorkbench>(std::move(document), ImVec2{1440, 1000});
    bench_->wait_for_surfaces();
  }
  Editor& editor() { return bench_->editor(); }
  const std::map<std::string, Marks::Rect>& marks() { return bench_->workbench().marks().all(); }
  const SceneBuilder& scene() { return bench_->workbench().viewport().scene(); }
  void frames(int count) { bench_->frames(count); }
  void click(const std::string& mark) {
    bench_->click(mark);
    frames(3);
  }
  void from_palette(const char* words, const std::string& id) {
    bench_->from_palette(words, id);
    bench_->wait_for_surfaces();
  }
  void from_menu(const std::string& id) {
    click("menu.Analyse");
    click("menu.Making");
    click("command." + id);
    bench_->wait_for_surfaces();
  }
  /// The probe's text in the middle of the part.
  std::string probed() {
    const PanelRect& view = bench_->workbench().viewport().rect();
    bench_->move((view.min.x + view.max.x) / 2, (view.min.y + view.max.y) / 2);
    frames(2);
    EXPECT_TRUE(marks().contains("probe"));
    const auto point = bench_->workbench().viewport().pointed_at();
    return point ? map_value_text(editor(), editor().language, *point) : std::string("nothing");
  }
  SurfaceMap shown(std::size_t object = 0) { return scene().scene().objects.at(object).map; }
  void type_into(const std::string& mark, std::string_view text) {
    click(mark);
    bench_->enter(text);
    bench_->wait_for_surfaces();
  }

  std::unique_ptr<test::HeadlessWorkbench> bench_;
};

TEST_F(Making, EachMapComesAndGoesByPaletteAndMenu) {
  open(document_from_mesh(test::cube(), "Part").value());
  const struct {
    const char *words, *id;
    SurfaceMap map;
    const char* unit;
  } rows[] = {{"draft angle", "analyse.draft", SurfaceMap::draft, "\u00b0"},
              {"smallest radius", "analyse.radius", SurfaceMap::radius, " mm"},
              {"wall thickness", "analyse.thickness", SurfaceMap::thickness, " mm"}};
  for (const auto& row : rows) {
    SCOPED_TRACE(row.id);
    from_palette(row.words, row.id);
    EXPECT_EQ(shown(), row.map);
    const auto legend = legend_source(editor(), scene());
    ASSERT_TRUE(legend);
    EXPECT_EQ(legend->map, row.map);
    EXPECT_TRUE(legend->of_view);
    EXPECT_TRUE(marks().contains("legend.limit"));
    EXPECT_EQ(marks().contains("legend.floor"), row.map == SurfaceMap::draft);
    const std::string value = probed();
    EXPECT_TRUE(value.find(row.unit) != std::string::npos) << value;
    EXPECT_TRUE(value.find_first_of("0123456789") != std::string::npos) << value;
    // The menu takes it away again.
    from_menu(row.id);
    EXPECT_EQ(shown(), SurfaceMap::shaded);
    from_menu(row.id);
    EXPECT_EQ(shown(), row.map);
    EXPECT_FALSE(editor().history.dirty()) << "looking is no edit";
  }
}

TEST_F(Making, LimitsAreTypedInThePanelAndCentreTheLegend) {
  open(document_from_mesh(test::cube(), "Part").value());
  from_menu("analyse.draft");
  EXPECT_EQ(legend_source(editor(), scene())->range, (ValueRange{-3, 9, 3}));
  type_into("field.draft_limit", "5");
  EXPECT_EQ(editor().document().making.draft, 5);
  EXPECT_EQ(legend_source(editor(), scene())->range, (ValueRange{-5, 15, 5}));
  EXPECT_EQ(editor().history.undo_label(), "Least draft");
  from_menu("analyse.radius");
  EXPECT_FALSE(marks().contains("field.draft_limit"));
  type_into("field.radius_limit", "1/4in");
  EXPECT_EQ(editor().document().making.radius, 6.35);
  EXPECT_EQ(legend_source(editor(), scene())->range, (ValueRange{0, 12.7, 6.35}));
  from_menu("analyse.thickness");
  type_into("field.thickness_limit", "0.75");
  EXPECT_EQ(legend_source(editor(), scene())->range, (ValueRange{0, 1.5, 0.75}));
  // Steps like any other.
  bench_->key("Ctrl+Z");
  bench_->wait_for_surfaces();
  EXPECT_EQ(editor().document().making.thickness, 2);
  EXPECT_EQ(editor().document().making.radius, 6.35);
}

TEST_F(Making, ThePullIsAnAxisOrTheView) {
  open(document_from_mesh(test::cube(), "Part").value());
  from_menu("analyse.draft");
  const auto mean = [&] {
    double sum = 0;
    const auto values = scene().scene().objects[0].mesh->defined_values();
    for (const float value : values) sum += double(value);
    return sum / double(values.size());
  };
  const double upright = mean();
  click("combo.pull");
  click("choice.pull.5");
  bench_->wait_for_surfaces();
  EXPECT_EQ(editor().document().making.pull, Vector3(0, 0, -1));
  EXPECT_NEAR(mean(), upright, 0.5) << "a cube is the same from below";
  bench_->key("Num 7");
  for (int i = 0; i < 20; ++i) bench_->frame();
  click("combo.pull");
  click("choice.pull.6");
  const Vector3 eye = editor().camera().orientation * Vector3::UnitZ();
  EXPECT_TRUE(editor().document().making.pull.isApprox(eye, 1e-9));
  EXPECT_EQ(editor().history.undo_label(), "Pull direction");
}

TEST_F(Making, OpenSurfacesSayWhyTheyHaveNoWalls) {
  open(part_with_a_border());
  from_menu("analyse.thickness");
  EXPECT_EQ(shown(), SurfaceMap::shaded);
  ASSERT_TRUE(marks().contains("legend.missing"));
  ASSERT_TRUE(marks().contains("map.missing"));
  const auto missing = missing_map(editor());
  ASSERT_TRUE(missing);
  EXPECT_NE(missing->reason->text.find("open"), std::string::npos);
  EXPECT_FALSE(missing->reason->remedy.empty());
  // Other maps are not concerned.
  from_menu("analyse.radius");
  EXPECT_EQ(shown(), SurfaceMap::radius);
  EXPECT_FALSE(marks().contains("legend.missing"));
}

TEST_F(Making, DeviationsAreFromTheReferenceThatIsChosen) {
  open(two_parts());
  from_menu("analyse.deviation");
  ASSERT_TRUE(marks().contains("legend.missing")) << "no reference yet";
  ASSERT_FALSE(editor().notices().empty());
  const ObjectId part = editor().document().objects[0]->id, model = editor().document().objects[1]->id;
  editor().selection.active = part;
  frames(2);
  click("combo.reference");
  click("reference." + std::to_string(model.value));
  bench_->wait_for_surfaces();
  EXPECT_EQ(editor().document().making.reference, model);
  EXPECT_EQ(shown(0), SurfaceMap::deviation);
  EXPECT_EQ(shown(1), SurfaceMap::shaded) << "the reference itself";
  EXPECT_FALSE(marks().contains("legend.missing"));
  const auto values = scene().scene().objects[0].mesh->defined_values();
  EXPECT_NEAR(*std::max_element(values.begin(), values.end()), 0.125, 0.01);
  const auto legend = legend_source(editor(), scene());
  ASSERT_TRUE(legend);
  EXPECT_EQ(legend->range.centre, 0);
  // One object alone has nothing to deviate from.
  editor().commit(set_visible(editor().history.current(), model, false), "Hide");
  bench_->wait_for_surfaces();
  EXPECT_FALSE(bench_->workbench().commands().run("analyse.deviation").ran);
}

TEST_F(Making, AnObjectsOwnMapIsKeptAndGoesBeforeTheViews) {
  open(document_from_mesh(test::cube(), "Part").value());
  click("combo.map");
  click("choice.map." + std::to_string(static_cast<int>(SurfaceMap::thickness)));
  bench_->wait_for_surfaces();
  EXPECT_EQ(editor().active_object()->display.map, SurfaceMap::thickness);
  from_menu("analyse.draft");
  EXPECT_EQ(shown(), SurfaceMap::thickness);
  const auto legend = legend_source(editor(), scene());
  ASSERT_TRUE(legend);
  EXPECT_FALSE(legend->of_view);
  EXPECT_EQ(legend->range, (ValueRange{0, 4, 2}));
}

TEST_F(Making, FacetsHaveDraftsAndWallsButNoRadius) {
  Document document;
  PolygonMesh mesh = test::cube();
  auto added = add_object(document, "Facets", MeshSource::from_mesh(std::move(mesh)).value());
  open(added->document);
  for (const auto& [id, map] :
       {std::pair{"analyse.draft", SurfaceMap::draft}, {"analyse.thickness", SurfaceMap::thickness}}) {
    from_menu(id);
    EXPECT_EQ(shown(), map);
    EXPECT_TRUE(scene().scene().objects[0].mesh->has_values());
  }
  const auto outcome = bench_->workbench().commands().run("analyse.radius");
  EXPECT_FALSE(outcome.ran);
  EXPECT_FALSE(outcome.reason.empty());
}

}  // namespace
}  // namespace hariko

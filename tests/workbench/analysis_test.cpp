// Analysis as a way of looking: for every kind of object, for all at once, and no edit.

#include <set>

#include "core/document/edits/edits.hpp"
#include "core/document/file.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"
#include "ui/editor/continuity_text.hpp"
#include "ui/editor/legend_source.hpp"

namespace hariko {
namespace {

Document sample_document(const std::string& name) {
  return load_document(test::source_folder() + "/assets/samples/" + name + ".hariko").value();
}

/// A sphere of a radius as a polyhedron scaled by the object.
Document two_cubes() {
  Document document = document_from_mesh(test::cube(), "Small").value();
  Similarity far{.scale = 2, .translation = {8, 0, 0}};
  auto added = add_object(document, "Large", document.objects[0]->source);
  const ObjectId id = added->document.objects.back()->id;
  return set_transform(added->document, id, far).value();
}

TEST(Analysis, EveryKindOfObjectShowsEveryMapByKeyAndPalette) {
  for (const char* name : {"cube", "solids_one", "skin_smooth", "sphere_cap"}) {
    test::HeadlessWorkbench bench(sample_document(name));
    bench.wait_for_surfaces();
    Editor& editor = bench.editor();
    bench.key("Alt+Z");
    bench.wait_for_surfaces();
    const Scene& scene = bench.workbench().viewport().scene().scene();
    EXPECT_EQ(scene.objects[0].map, SurfaceMap::zebra) << name;
    EXPECT_FALSE(editor.history.dirty()) << name;
    for (const auto& [id, map] : {std::pair{"analyse.isophotes", SurfaceMap::isophotes},
                                  {"analyse.gauss", SurfaceMap::gaussian},
                                  {"analyse.mean", SurfaceMap::mean},
                                  {"analyse.k1", SurfaceMap::principal_max},
                                  {"analyse.k2", SurfaceMap::principal_min},
                                  {"analyse.continuity", SurfaceMap::continuity},
                                  {"analyse.patches", SurfaceMap::patches}}) {
      const Command* command = bench.workbench().commands().find(id);
      ASSERT_TRUE(command && !command->keys.empty()) << id << " has no key";
      const std::size_t notices = editor.notices().size();
      bench.key(command->keys);
      EXPECT_EQ(editor.notices().size(), notices) << name << " " << id;
      bench.wait_for_surfaces();
      EXPECT_EQ(bench.workbench().viewport().scene().scene().objects[0].map, map) << name << " " << id;
    }
    // The map that is on goes off again.
    EXPECT_TRUE(bench.workbench().commands().run("analyse.patches").ran);
    bench.wait_for_surfaces();
    EXPECT_EQ(bench.workbench().viewport().scene().scene().objects[0].map, SurfaceMap::shaded) << name;
    EXPECT_FALSE(editor.history.dirty()) << name;
    EXPECT_TRUE(bench.workbench().commands().run("material.metal").ran) << name;
  }
}

TEST(Analysis, AnObjectsOwnMapGoesBeforeTheViews) {
  test::HeadlessWorkbench bench(two_cubes());
  Editor& editor = bench.editor();
  const ObjectId first = editor.document().objects[0]->id;
  DisplaySettings display = editor.document().objects[0]->display;
  display.map = SurfaceMap::patches;
  editor.commit(set_display(editor.history.current(), first, display), "Map");
  bench.key("Alt+Z");
  bench.wait_for_surfaces();
  const Scene& scene = bench.workbench().viewport().scene().scene();
  EXPECT_EQ(scene.objects[0].map, SurfaceMap::patches);
  EXPECT_EQ(scene.objects[1].map, SurfaceMap::zebra);
  ASSERT_FALSE(editor.notices().empty());
  EXPECT_NE(editor.notices().back().text.find("1 object keeps"), std::string::npos);
}

TEST(Analysis, ColoursOfAllSurfacesCompare) {
  test::HeadlessWorkbench bench(two_cubes());
  Editor& editor = bench.editor();
  EXPECT_TRUE(bench.workbench().commands().run("analyse.mean").ran);
  bench.wait_for_surfaces();
  const SceneBuilder& builder = bench.workbench().viewport().scene();
  const ViewScale* scale = builder.view_scale();
  ASSERT_NE(scale, nullptr);
  const auto& objects = builder.scene().objects;
  ASSERT_TRUE(objects[0].mesh->has_values() && objects[1].mesh->has_values());
  // The same curvature has the same colour: values of the large one are those of its own, smaller space.
  EXPECT_DOUBLE_EQ(objects[0].range.high, scale->range.high);
  EXPECT_DOUBLE_EQ(objects[1].range.high, 2 * scale->range.high);
  const auto legend = legend_source(editor, builder);
  ASSERT_TRUE(legend);
  EXPECT_TRUE(legend->of_view);
  // Its range is set without a step.
  const auto steps = editor.history.position();
  set_range(editor, *legend, {RangeMode::manual, -3, 3});
  bench.frame();
  EXPECT_EQ(builder.view_scale()->range, (ValueRange{-3, 3}));
  EXPECT_EQ(editor.history.position(), steps);
  EXPECT_FALSE(editor.history.dirty());
}

/// Seams inside of faces are no edges: the sentence counts edges as the legend of the view does.
TEST(Analysis, EdgesThatAreLessContinuousAreThoseOfTheLegend) {
  const Document document = sample_document("car");
  test::HeadlessWorkbench bench(document);
  bench.wait_for_surfaces();
  const SurfaceView* view = bench.editor().view_of(document.objects[0]->id);
  ASSERT_TRUE(view && view->continuity);
  const ReachedContinuity reached = reached_continuity(view->surface, *view->continuity, {});
  ASSERT_EQ(reached.smooth, Continuity::g2);
  const std::vector<Continuity> classes = classify(view->surface, *view->continuity, {});
  std::set<std::uint64_t> edges;
  std::size_t inner = 0;
  for (std::size_t s = 0; s < classes.size(); ++s) {
    const Seam& seam = view->surface.seams()[s];
    if (classes[s] == Continuity::g2) continue;
    if (seam.source.kind == Element::Kind::edge)
      edges.insert(seam.source.id);
    else
      ++inner;
  }
  EXPECT_EQ(reached.less, edges.size());
  EXPECT_EQ(reached.inner_less, inner);
  EXPECT_GT(reached.less, 0U);
}

TEST(Analysis, TheContinuityThatIsReachedIsTold) {
  Document document = document_from_mesh(test::cube(), "Cube").value();
  const ObjectId id = document.objects[0]->id;
  const Polyhedron& cube = document.objects[0]->polyhedron()->polyhedron;
  const std::vector<EdgeId> two{cube.edge_id(0), cube.edge_id(1)};
  test::HeadlessWorkbench bench(set_crease(document, id, two, true).value());
  bench.wait_for_surfaces();
  const SurfaceView* view = bench.editor().view_of(id);
  ASSERT_TRUE(view && view->continuity);
  const ReachedContinuity reached = reached_continuity(view->surface, *view->continuity, {});
  EXPECT_EQ(reached.creases, 2U);
  EXPECT_TRUE(reached.joined);
  const Language english;
  const std::string text = text_of(reached, english);
  EXPECT_NE(text.find("-continuous"), std::string::npos) << text;
  EXPECT_NE(text.find("2 creased edges"), std::string::npos) << text;

  ReachedContinuity all;
  EXPECT_EQ(text_of(all, english), "");
  all.joined = true;
  EXPECT_EQ(text_of(all, english), "tangent-continuous");
  all.smooth = Continuity::g2;
  EXPECT_EQ(text_of(all, english), "curvature-continuous");
  all.creases = 10;
  EXPECT_EQ(text_of(all, english), "curvature-continuous but for 10 creased edges");
  all.less = 1;
  EXPECT_EQ(text_of(all, english), "curvature-continuous but for 1 edge and 10 creased edges");
  all.inner_less = 12;
  EXPECT_EQ(text_of(all, english),
            "curvature-continuous but for 1 edge, 12 seams inside of faces and 10 creased edges");
  all.largest_kink = 0.1;
  EXPECT_EQ(text_of(all, english), "largest kink 5.73\u00b0, 10 creased edges");
}

}  // namespace
}  // namespace hariko

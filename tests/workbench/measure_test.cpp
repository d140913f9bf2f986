// Measuring by hand: clicks on the model make dimensions, which follow it, are chosen, moved, copied and
// deleted; and the status line tells how large what is selected is.

#include <cmath>
#include <numbers>

#include "core/modeling/measuring/surface_curves.hpp"
#include "core/modeling/objects/edit_modeling.hpp"
#include "core/modeling/operations/delete_elements.hpp"
#include "tests/workbench/bench_hands.hpp"
#include "ui/editor/dimension_view.hpp"

namespace hariko {
namespace {

/// A cube with edges of 100 mm. Vertices 4 to 7 are round its top, which the first view sees.
Document cube_of_100() {
  PolygonMesh mesh = test::cube();
  for (Vector3& position : mesh.positions) position *= 50;
  return document_from_mesh(mesh, "Cube").value();
}

class Measure : public test::BenchHands {
 protected:
  /// So high that all properties show.
  Measure() : BenchHands(cube_of_100(), {1100, 1500}) { bench_.wait_for_surfaces(); }

  Vector3 vertex(std::uint32_t id) {
    const Object& object = *editor().document().objects[0];
    const Polyhedron& cage = *object.cage();
    return object.transform.apply(object.cage_origin() + cage.position(cage.find(VertexId{id})));
  }
  void move_to(const Vector3& world) { BenchHands::move_to(pixel(world)); }
  void click(const Vector3& world) { BenchHands::click(pixel(world)); }
  void measure_edge() {
    bench_.key("D");
    click(vertex(4));
    click(vertex(5));
    bench_.key("Enter");
    bench_.frame();
  }
  bool tool_active() { return bench_.workbench().viewport().tool_active(); }
  const Dimensions& dimensions() { return *editor().document().dimensions; }
  double value(std::size_t number = 0) {
    bench_.frame();
    const auto& all = editor().dimensions.all();
    EXPECT_LT(number, all.size());
    EXPECT_TRUE(number < all.size() && all[number].measured);
    return number < all.size() && all[number].measured ? all[number].measured->value : -1;
  }
  bool marked(const std::string& mark) { return marks().contains(mark); }
  void select(ElementMode mode, const std::vector<Element>& elements) {
    editor().mode = mode;
    editor().selection.clear_elements();
    editor().selection.clear_objects();
    for (const Element& element : elements)
      editor().selection.select({editor().document().objects[0]->id, element}, Selection::How::add);
    bench_.move(5, 5);  // nothing is hovered
    for (int i = 0; i < 3; ++i) bench_.frame();
  }
};

TEST_F(Measure, TwoClicksGiveTheLengthOfAnEdge) {
  const Document before = editor().document();
  bench_.key("D");
  ASSERT_TRUE(tool_active());
  EXPECT_TRUE(hint().starts_with("Distance")) << hint();
  click(vertex(4));
  EXPECT_TRUE(dimensions().empty());
  move_to(vertex(5));
  EXPECT_TRUE(hint().starts_with("Distance  100 mm")) << hint();
  EXPECT_NE(hint().find("x 100   y 0   z 0"), std::string::npos) << hint();
  click(vertex(5));
  ASSERT_EQ(dimensions().size(), 1U) << hint();
  const ObjectId id = editor().document().objects[0]->id;
  EXPECT_EQ(dimensions()[0].anchors[0], Anchor(VertexAnchor{id, VertexId{4}}));
  EXPECT_EQ(dimensions()[0].anchors[1], Anchor(VertexAnchor{id, VertexId{5}}));
  EXPECT_DOUBLE_EQ(value(), 100);
  EXPECT_TRUE(marked("dimension.1")) << "its label is in the view";
  EXPECT_TRUE(tool_active()) << "the next one can begin";
  bench_.key("Enter");
  EXPECT_FALSE(tool_active());
  EXPECT_EQ(editor().history.undo_label(), "Measure distance");
  bench_.key("Ctrl+Z");
  EXPECT_EQ(editor().document(), before);
  bench_.frame();
  EXPECT_FALSE(marked("dimension.1"));
  bench_.key("Ctrl+Shift+Z");
  EXPECT_DOUBLE_EQ(value(), 100);
}

TEST_F(Measure, ThreeClicksGiveARightAngle) {
  bench_.key("Alt+D");
  click(vertex(5));
  click(vertex(4));
  move_to(vertex(7));
  EXPECT_TRUE(hint().starts_with("Angle  90\u00b0")) << hint();
  click(vertex(7));
  ASSERT_EQ(dimensions().size(), 1U) << hint();
  EXPECT_EQ(dimensions()[0].kind, DimensionKind::angle);
  EXPECT_NEAR(value(), std::numbers::pi / 2, 1e-12);
  bench_.key("Esc");
  EXPECT_FALSE(tool_active());
  EXPECT_EQ(dimensions().size(), 1U) << "what is kept stays when the tool ends";
}

TEST_F(Measure, AClickGivesTheRadiiOfTheSurface) {
  bench_.key("Ctrl+Alt+D");
  ASSERT_TRUE(tool_active());
  move_to({0, 0, 50});  // over the top, which bulges
  EXPECT_TRUE(hint().starts_with("Radius  R ")) << hint();
  click({0, 0, 50});
  ASSERT_EQ(dimensions().size(), 1U) << hint();
  const auto& shown = editor().dimensions.all();
  bench_.frame();
  ASSERT_TRUE(shown[0].measured);
  EXPECT_GT(shown[0].measured->first_radius, 0) << "convex";
  EXPECT_LE(std::abs(shown[0].measured->first_radius), std::abs(shown[0].measured->second_radius));
  // Beside the model there is nothing to measure.
  const ImVec2 corner = bench_.workbench().viewport().rect().min;
  bench_.move(double(corner.x) + 20, double(corner.y) + 200);
  bench_.press();
  bench_.release();
  EXPECT_TRUE(hint().starts_with("Click a point of a surface.")) << hint();
  EXPECT_EQ(dimensions().size(), 1U);
}

TEST_F(Measure, BackspaceAndEscTakeBackWhatIsNotComplete) {
  const Document before = editor().document();
  bench_.key("D");
  click(vertex(4));
  bench_.key("Backspace");
  click(vertex(6));
  click(vertex(6));
  EXPECT_TRUE(hint().starts_with("This is the last point.")) << hint();
  bench_.key("G");  // a letter does not run its command in the middle
  EXPECT_TRUE(tool_active());
  bench_.key("Esc");
  EXPECT_FALSE(tool_active());
  EXPECT_EQ(editor().document(), before);
  EXPECT_FALSE(editor().history.can_undo());
}

TEST_F(Measure, ADimensionFollowsItsVertex) {
  measure_edge();
  ASSERT_EQ(dimensions().size(), 1U);
  const Object& object = *editor().document().objects[0];
  const std::vector<VertexId> moved{VertexId{5}};
  const std::vector<Vector3> to{Vector3(150, -50, 50) - object.cage_origin()};
  editor().commit(move_vertices(editor().history.current(), object.id, moved, to), "Move vertex");
  EXPECT_DOUBLE_EQ(value(), 200);
  // Also while a gesture shows it.
  const std::vector<Vector3> further{Vector3(250, -50, 50) - object.cage_origin()};
  editor().preview(move_vertices(editor().history.current(), object.id, moved, further));
  EXPECT_DOUBLE_EQ(value(), 300);
  editor().cancel_preview();
  EXPECT_DOUBLE_EQ(value(), 200);
  bench_.key("Ctrl+Z");
  EXPECT_DOUBLE_EQ(value(), 100);
}

TEST_F(Measure, ADimensionGoesWithItsVertexAndComesBack) {
  measure_edge();
  const ObjectId id = editor().document().objects[0]->id;
  const std::vector<VertexId> gone{VertexId{5}};
  const auto opened = edit_polyhedron(editor().history.current(), id, [&](const PolyhedronSource& source) {
    return delete_vertices(source, gone);
  });
  ASSERT_TRUE(opened);
  editor().commit(opened->document, "Delete vertices");
  EXPECT_TRUE(dimensions().empty());
  EXPECT_EQ(notice(), "1 dimension went with what it measured.");
  editor().undo();
  EXPECT_EQ(dimensions().size(), 1U);
  EXPECT_DOUBLE_EQ(value(), 100);
  // The same where its whole object is deleted.
  editor().notices().clear();
  const std::vector<ObjectId> objects{id};
  editor().commit(delete_objects(editor().history.current(), objects), "Delete object");
  EXPECT_TRUE(dimensions().empty());
  EXPECT_EQ(notice(), "1 dimension went with what it measured.");
}

TEST_F(Measure, ALabelIsClickedAndDelDeletesTheDimension) {
  measure_edge();
  const std::size_t objects = editor().document().objects.size();
  bench_.click("dimension.1");
  EXPECT_EQ(editor().dimensions.chosen(editor()), DimensionId{1});
  bench_.key("Del");
  EXPECT_TRUE(dimensions().empty());
  EXPECT_EQ(editor().document().objects.size(), objects);
  EXPECT_EQ(editor().history.undo_label(), "Delete dimension");
  bench_.key("Ctrl+Z");
  bench_.frame();
  // Del is about anything that is selected afterwards.
  bench_.click("dimension.1");
  select(ElementMode::face, {element_of(FaceId{0})});
  EXPECT_FALSE(editor().dimensions.chosen(editor()).has_value());
  bench_.click("dimension.1");
  bench_.key("Esc");
  EXPECT_FALSE(editor().dimensions.chosen(editor()).has_value());
  EXPECT_FALSE(editor().selection.no_elements()) << "Esc let go of the dimension alone";
}

TEST_F(Measure, ALabelIsDragged) {
  measure_edge();
  const std::size_t steps = editor().history.position();
  const Marks::Rect before = bench_.workbench().marks().all().at("dimension.1");
  const double x = before.x + before.width / 2.0, y = before.y + before.height / 2.0;
  bench_.move(x, y);
  bench_.press();
  bench_.move(x - 10, y - 20);
  bench_.move(x - 30, y - 60);
  bench_.release();
  bench_.frame();
  EXPECT_EQ(editor().history.position(), steps + 1);
  EXPECT_EQ(editor().history.undo_label(), "Move label");
  EXPECT_GT(dimensions()[0].label.norm(), 1);
  const Marks::Rect after = bench_.workbench().marks().all().at("dimension.1");
  EXPECT_NEAR(after.x, before.x - 30, 2);
  EXPECT_NEAR(after.y, before.y - 60, 2);
  EXPECT_DOUBLE_EQ(value(), 100) << "the value does not care";
}

/// Labels of dimensions at one place lay over each other.
TEST_F(Measure, LabelsStandBesideEachOther) {
  for (int i = 0; i < 3; ++i) measure_edge();
  bench_.key("Ctrl+Alt+D");
  click({0, 0, 50});
  bench_.key("Enter");
  bench_.frame();
  ASSERT_EQ(dimensions().size(), 4U);
  std::vector<Marks::Rect> labels;
  for (const auto& [mark, rect] : bench_.workbench().marks().all())
    if (mark.starts_with("dimension.")) labels.push_back(rect);
  ASSERT_EQ(labels.size(), 4U);
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const bool apart =
          labels[i].x >= labels[j].x + labels[j].width || labels[j].x >= labels[i].x + labels[i].width ||
          labels[i].y >= labels[j].y + labels[j].height || labels[j].y >= labels[i].y + labels[i].height;
      EXPECT_TRUE(apart) << i << " lies over " << j;
    }
  // One that made way goes on from there when it is dragged.
  const Marks::Rect last = bench_.workbench().marks().all().at("dimension.3");
  const double x = last.x + last.width / 2.0, y = last.y + last.height / 2.0;
  bench_.move(x, y);
  bench_.press();
  bench_.move(x + 60, y - 120);
  bench_.move(x + 80, y - 160);
  bench_.release();
  bench_.frame();
  EXPECT_NEAR(bench_.workbench().marks().all().at("dimension.3").x, last.x + 80, 2);
  EXPECT_NEAR(bench_.workbench().marks().all().at("dimension.3").y, last.y - 160, 2);
}

TEST_F(Measure, TheListShowsCopiesAndDeletes) {
  measure_edge();
  bench_.move(5, 5);
  bench_.frame();
  ASSERT_TRUE(marked("dimension_row.1"));
  bench_.click("dimension_row.1");
  EXPECT_EQ(editor().dimensions.chosen(editor()), DimensionId{1});
  bench_.click("dimension_row.1.copy");
  EXPECT_STREQ(ImGui::GetClipboardText(), "100 mm");
  EXPECT_TRUE(bench_.workbench().commands().run("measure.copy").ran);
  bench_.click("dimension_row.1.delete");
  bench_.frame();
  EXPECT_TRUE(dimensions().empty());
  bench_.frame();
  EXPECT_FALSE(marked("dimension_row.1"));
  EXPECT_FALSE(bench_.workbench().commands().run("measure.copy").ran);
  EXPECT_FALSE(bench_.workbench().commands().run("measure.delete_all").ran);
}

TEST_F(Measure, OneCommandHidesAllDimensions) {
  measure_edge();
  ASSERT_TRUE(marked("dimension.1"));
  EXPECT_TRUE(bench_.workbench().commands().run("measure.show").ran);
  bench_.frame();
  EXPECT_FALSE(marked("dimension.1"));
  EXPECT_TRUE(marked("dimension_row.1")) << "they stay in the list";
  EXPECT_TRUE(bench_.workbench().commands().run("measure.show").ran);
  bench_.frame();
  EXPECT_TRUE(marked("dimension.1"));
  const ObjectId id = editor().document().objects[0]->id;
  editor().commit(set_visible(editor().history.current(), id, false), "Hide");
  bench_.frame();
  EXPECT_FALSE(marked("dimension.1")) << "what it measures is hidden";
}

TEST_F(Measure, PointsOfEdgesAndOfTheSurfaceAreTaken) {
  bench_.key("D");
  // Near the middle of the curve over an edge of the top, with Ctrl exactly there.
  const EdgeId top = EdgeId::of(VertexId{4}, VertexId{5});
  const Vector3 middle =
      *anchor_place(editor().document(), EdgeAnchor{editor().document().objects[0]->id, top, 0.47, false},
                    ready_surfaces(editor()));
  bench_.hold(false, true, false);
  click(middle);
  bench_.hold(false, false, false);
  click(vertex(4));
  ASSERT_EQ(dimensions().size(), 1U) << hint();
  const auto* edge = std::get_if<EdgeAnchor>(&dimensions()[0].anchors[0]);
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->share, 0.5);
  EXPECT_EQ(edge->edge, top);
  EXPECT_FALSE(edge->straight);
  click({0, 0, 50});
  click(vertex(4));
  ASSERT_EQ(dimensions().size(), 2U);
  EXPECT_TRUE(std::holds_alternative<PatchAnchor>(dimensions()[1].anchors[0]));
  EXPECT_GT(value(1), 60);
}

TEST_F(Measure, TheStatusLineTellsTheSizeOfWhatIsSelected) {
  const auto tells = [&](const std::string& text) {
    for (int i = 0; i < 3; ++i) bench_.frame();
    return hint().find(text) != std::string::npos;
  };
  const auto at = [](std::uint32_t id) { return element_of(VertexId{id}); };
  select(ElementMode::vertex, {at(6)});
  EXPECT_TRUE(tells("1 vertex   position 50  50  50 mm")) << hint();
  select(ElementMode::vertex, {at(4), at(5)});
  EXPECT_TRUE(tells("2 vertices   distance 100 mm")) << hint();
  select(ElementMode::vertex, {at(5), at(4), at(7)});
  EXPECT_TRUE(tells("3 vertices   angle 90\u00b0")) << hint();
  select(ElementMode::vertex, {at(4), at(5), at(6), at(7)});
  EXPECT_TRUE(tells("4 vertices   size 100 \u00d7 100 \u00d7 0 mm")) << hint();
  select(ElementMode::edge, {element_of(EdgeId::of(VertexId{4}, VertexId{5}))});
  EXPECT_TRUE(tells("1 edge   length 1")) << "longer than 100 mm, as the curve bulges: " << hint();
  EXPECT_FALSE(tells("length 100 mm")) << hint();
  select(ElementMode::face, {element_of(FaceId{0}), element_of(FaceId{1})});
  EXPECT_TRUE(tells("2 faces   area ")) << hint();
  EXPECT_TRUE(tells(" mm\u00b2")) << hint();
  select(ElementMode::object, {element_of(editor().document().objects[0]->id)});
  EXPECT_TRUE(tells("1 object   size ")) << hint();
}

TEST_F(Measure, TheAreasOfAllFacesAreThatOfTheSurface) {
  editor().mode = ElementMode::face;
  editor().selection.select_all(*editor().active_object(), ElementMode::face);
  bench_.move(5, 5);
  for (int i = 0; i < 4; ++i) bench_.frame();
  const std::string text = hint();
  const std::size_t at = text.find("area ");
  ASSERT_NE(at, std::string::npos) << text;
  const double area = std::stod(text.substr(at + 5));
  const Surface& surface = editor().view_of(editor().active_object()->id)->surface;
  std::vector<Index> all;
  for (Index p = 0; p < surface.patch_count(); ++p) all.push_back(p);
  EXPECT_NEAR(area, patch_area(surface, all), 1e-4 * area);
  EXPECT_GT(area, 60000) << "more than that of the cube";
}

}  // namespace
}  // namespace hariko

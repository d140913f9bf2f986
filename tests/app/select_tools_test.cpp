// Selecting by boxes, lassos, clicks and double clicks.

#include "tests/app/skin_rig.hpp"
#include "tests/app/tool_rig.hpp"
#include "ui/view/region_tool.hpp"
#include "ui/view/transform_tool.hpp"

namespace hariko::test {
namespace {

TEST(RegionTool, WindowTakesWhatLiesInsideAndCrossingWhatItTouches) {
  Rig rig(grid_document(4));
  Camera top = Camera::standard(StandardView::top);
  top.target = {2, 2, 0};
  top.distance = 20;
  top.orthographic = true;
  rig.editor.set_camera(top);
  rig.editor.mode = ElementMode::face;
  rig.scene.update(rig.editor);
  // Round the middle four faces and a bit of their neighbours.
  const Vector2 a = rig.pixel({0.5, 3.5, 0}), b = rig.pixel({3.5, 0.5, 0});
  const auto box = [&](const Vector2& from, const Vector2& to) {
    rig.start(make_region_tool(false), from);
    rig.move(to);
    rig.send(PointerEvent::Kind::release, to);
    return rig.editor.selection.of_active().faces.size();
  };
  EXPECT_EQ(box(a, b), 4U) << "left to right";
  EXPECT_EQ(box(b, a), 16U) << "right to left";
  rig.editor.mode = ElementMode::vertex;
  EXPECT_EQ((box(a, b), rig.editor.selection.of_active().vertices.size()), 9U);
  EXPECT_FALSE(rig.editor.history.can_undo());
}

TEST(RegionTool, HiddenElementsNeedSelectThrough) {
  Rig rig;
  rig.editor.mode = ElementMode::vertex;
  const auto all = [&] {
    rig.start(make_region_tool(false), {1, 1});
    rig.move({799, 599});
    rig.send(PointerEvent::Kind::release, {799, 599});
    return rig.editor.selection.of_active().vertices.size();
  };
  EXPECT_EQ(all(), 7U) << "one corner of a cube is behind";
  rig.editor.selecting.through = true;
  EXPECT_EQ(all(), 8U);
  rig.editor.mode = ElementMode::face;
  rig.editor.selecting.through = false;
  all();
  EXPECT_EQ(rig.editor.selection.of_active().faces.size(), 3U);
}

TEST(RegionTool, LassoTakesWhatItEnclosesAndEscRestores) {
  Rig rig(grid_document(4));
  Camera top = Camera::standard(StandardView::top);
  top.target = {2, 2, 0};
  top.distance = 20;
  rig.editor.set_camera(top);
  rig.editor.mode = ElementMode::vertex;
  rig.editor.selecting.lasso = true;
  rig.scene.update(rig.editor);
  rig.start(make_region_tool(false), rig.pixel({-0.5, -0.5, 0}));
  rig.move(rig.pixel({4.8, -0.5, 0}));
  rig.move(rig.pixel({-0.5, 4.8, 0}));
  EXPECT_EQ(rig.editor.selection.of_active().vertices.size(), 15U) << "the triangle below the diagonal";
  rig.escape();
  EXPECT_TRUE(rig.editor.selection.no_elements());
}

/// Vertices of the active object that a box from one pixel to another selects.
std::set<VertexId> boxed(Rig& rig, const Vector2& from, const Vector2& to) {
  rig.start(make_region_tool(false), from);
  rig.move(to);
  rig.send(PointerEvent::Kind::release, to);
  return rig.editor.selection.of_active().vertices;
}

TEST(RegionTool, SolidsAreTakenByTheirBodies) {
  EnvelopeInput input;
  for (const std::uint32_t id : {4U, 7U}) {
    Solid solid;
    solid.id = id;
    solid.position = {id == 4 ? -2.0 : 2.0, 0, 0};
    input.solids.push_back(solid);
  }
  Rig rig(add_object({}, "solids", SolidsSource{input, {}}).value().document);
  Camera top = Camera::standard(StandardView::top);
  top.distance = 20;
  top.orthographic = true;
  rig.editor.set_camera(top);
  rig.editor.selection.active = rig.editor.document().objects[0]->id;
  rig.editor.mode = ElementMode::vertex;
  rig.scene.update(rig.editor);
  // Round the first one and half of the other.
  const Vector2 a = rig.pixel({-3, 1, 0}), b = rig.pixel({2, -1, 0});
  EXPECT_EQ(boxed(rig, a, b), (std::set<VertexId>{VertexId{4}}));
  EXPECT_EQ(boxed(rig, b, a), (std::set<VertexId>{VertexId{4}, VertexId{7}})) << "crossing";
  EXPECT_EQ(boxed(rig, {1, 1}, {2, 2}), std::set<VertexId>());
  rig.editor.selection.select_all(*rig.editor.active_object(), ElementMode::vertex);
  EXPECT_EQ(rig.editor.selection.of_active().vertices.size(), 2U);
}

TEST(RegionTool, SkinsAreTakenByTheirPointsAndWholeByTheirCurves) {
  Skin skin;
  for (int i = 0; i < 4; ++i) skin.path.points.push_back(Vector3(0, 0, i));
  std::uint32_t id = 0;
  for (int k = 0; k < 3; ++k) {
    SkinSection section;
    section.id = std::uint32_t(k);
    section.v = k / 2.0;
    section.closed = true;
    for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
      section.points.push_back({id++, Vector3(x, y, 1.5 * k), false});
    skin.sections.push_back(section);
  }
  test::SkinRig rig(skin, StandardView::front);
  Editor& editor = rig.editor;
  editor.selection.active = rig.object().id;
  editor.selection.select_all(rig.object(), ElementMode::vertex);
  EXPECT_EQ(editor.selection.of_active().vertices.size(), 12U + 4U) << "points of sections and of the path";
  // Together they move as one.
  editor.mode = ElementMode::vertex;
  rig.start(make_transform_tool(TransformKind::move));
  rig.key(Key::x);
  rig.type("3");
  rig.enter();
  EXPECT_EQ(rig.skin().path.points[2], Vector3(3, 0, 2));
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(rig.skin().sections[k].points[i].position,
                Vector3(skin.sections[k].points[i].position + Vector3(3, 0, 0)));
  editor.undo();
  editor.selection.clear_elements();
  editor.selecting.through = true;
  rig.update();
  EXPECT_EQ(boxed(rig, {1, 1}, {799, 599}).size(), 16U);
  // The lowest section, of which the path's first point lies in the middle.
  const Vector2 low = rig.pixel({-1.3, 0, -0.4}), high = rig.pixel({1.3, 0, 0.4});
  EXPECT_EQ(boxed(rig, {low.x(), high.y()}, {high.x(), low.y()}).size(), 5U);
  editor.selecting.through = false;
  rig.update();
  const auto seen = boxed(rig, {1, 1}, {799, 599}).size();
  EXPECT_LT(seen, 16U) << "points behind the surface stay";
  EXPECT_GT(seen, 4U);
  editor.mode = ElementMode::object;
  editor.selection.clear_objects();
  rig.update();
  boxed(rig, {1, 1}, {799, 599});
  EXPECT_TRUE(editor.selection.objects().contains(rig.object().id));
  boxed(rig, {1, 1}, {3, 3});
  EXPECT_FALSE(editor.selection.objects().contains(rig.object().id));
}

TEST(SelectTool, DoubleClickTakesTheLoopAndRepeatedClicksWhatLiesBehind) {
  Rig rig(grid_document(4));
  Camera top = Camera::standard(StandardView::top);
  top.target = {2, 2, 0};
  top.distance = 20;
  rig.editor.set_camera(top);
  rig.editor.mode = ElementMode::edge;
  rig.scene.update(rig.editor);
  const auto click = [&](const Vector2& pixel, int clicks) {
    PointerEvent press{.kind = PointerEvent::Kind::press};
    press.pixel = pixel;
    press.clicks = clicks;
    rig.tool = make_select_tool();
    ToolContext now = rig.context();
    rig.tool->begin(now, press);
    rig.send(PointerEvent::Kind::release, pixel);
  };
  click(rig.pixel({1.5, 2, 0}), 1);
  EXPECT_EQ(rig.editor.selection.of_active().edges.size(), 1U);
  click(rig.pixel({1.5, 2, 0}), 2);
  EXPECT_EQ(rig.editor.selection.of_active().edges.size(), 4U) << "from border to border";
  // A cube from the front with x-ray: behind each vertex there is another one.
  Rig cube;
  Camera front = Camera::standard(StandardView::front);
  front.orthographic = true;
  cube.editor.set_camera(front);
  cube.editor.view.x_ray = true;
  cube.scene.update(cube.editor);
  const auto click_cube = [&] {
    PointerEvent press{.kind = PointerEvent::Kind::press};
    press.pixel = cube.pixel({1, -1, 1});
    cube.tool = make_select_tool();
    ToolContext now = cube.context();
    cube.tool->begin(now, press);
    cube.send(PointerEvent::Kind::release, press.pixel);
    return *cube.editor.selection.of_active().vertices.begin();
  };
  EXPECT_EQ(click_cube(), VertexId{5});
  EXPECT_EQ(click_cube(), VertexId{6});
  EXPECT_EQ(click_cube(), VertexId{5});
}

}  // namespace
}  // namespace hariko::test

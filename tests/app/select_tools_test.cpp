// Selecting by boxes, lassos, clicks and double clicks.

#include "tests/app/tool_rig.hpp"
#include "ui/tools/region_tool.hpp"

namespace hariko {
namespace {

using test::grid_document;
using test::Rig;

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

TEST(SelectTool, DoubleClickTakesTheLoopAndRepeatedClicksWhatLiesBehind) {
  Rig rig(grid_document(4));
  Camera top = Camera::standard(StandardView::top);
  top.target = {2, 2, 0};
  top.distance = 20;
  rig.editor.set_camera(top);
  rig.editor.mode = ElementMode::edge;
  rig.scene.update(rig.editor);
  const auto click = [&](const Vector2& pixel, int clicks) {
    PointerEvent press;
    press.kind = PointerEvent::Kind::press;
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
    PointerEvent press;
    press.kind = PointerEvent::Kind::press;
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
}  // namespace hariko

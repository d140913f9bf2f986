// Views from the side: grids with numbers, boxes that go through, buttons as in other programs, and the view
// that stays when four become one.

#include "render/grid_plane.hpp"
#include "tests/workbench/bench_hands.hpp"

namespace hariko {
namespace {

class SideViews : public test::BenchHands {
 protected:
  SideViews() : BenchHands(document_from_mesh(test::cube(), "Cube").value(), {1100, 760}) {
    bench_.wait_for_surfaces();
    editor().mode = ElementMode::vertex;
  }
  void look(const char* id) {
    run(id);
    frames(8);  // the flight
  }
  Vector2 middle_of(int view) {
    const Marks::Rect rect = bench_.workbench().marks().all().at("view." + std::to_string(view));
    return {rect.x + rect.width / 2.0, rect.y + rect.height / 2.0};
  }
  std::size_t box_all() {
    run("select.box");
    const PanelRect rect = bench_.workbench().viewport().rect();
    bench_.move(double(rect.min.x) + 10, double(rect.min.y) + 45);
    bench_.press();
    bench_.move(double(rect.max.x) - 5, double(rect.max.y) - 20);
    bench_.release();
    bench_.frame();
    return editor().selection.of_active().vertices.size();
  }
  void drag(const Vector2& from, const Vector2& by, int button) {
    bench_.move(from.x(), from.y());
    bench_.press(button);
    bench_.move(from.x() + by.x(), from.y() + by.y());
    bench_.release(button);
    bench_.frame();
  }
};

TEST_F(SideViews, BoxesGoThroughAndInPerspectiveTellWhatTheyLeftOut) {
  EXPECT_EQ(box_all(), 7U) << "in perspective one corner is hidden";
  EXPECT_NE(bench_.workbench().status().find("1 hidden element left out"), std::string::npos)
      << bench_.workbench().status();
  EXPECT_NE(bench_.workbench().status().find("Shift+Q"), std::string::npos);
  editor().selection.clear_elements();
  bench_.frame();
  EXPECT_EQ(bench_.workbench().status().find("left out"), std::string::npos);
  look("view.right");
  EXPECT_EQ(box_all(), 8U) << "in a side view what lies behind is taken too";
  EXPECT_EQ(bench_.workbench().status().find("left out"), std::string::npos);
  // The command is that of the view's projection.
  run("select.through");
  EXPECT_FALSE(editor().selecting.through_parallel);
  EXPECT_FALSE(editor().selecting.through);
}

TEST_F(SideViews, EverySideHasAGridWithNumbers) {
  const auto labels = [&](const std::string& way) {
    std::size_t count = 0;
    for (const auto& [name, rect] : bench_.workbench().marks().all())
      count += name.starts_with("grid." + way) ? 1 : 0;
    return count;
  };
  bench_.frame();
  EXPECT_EQ(labels(""), 0U) << "perspective";
  for (const char* side : {"view.front", "view.back", "view.left", "view.right", "view.top", "view.bottom"}) {
    look(side);
    EXPECT_GE(labels("across."), 2U) << side;
    EXPECT_GE(labels("up."), 2U) << side;
  }
  run("view.grid");
  EXPECT_EQ(labels(""), 0U);
}

TEST(GridPlane, NumbersStandWhereTheirLinesAre) {
  for (const double scale : {1e-3, 1.0, 1e6})
    for (const double shift : {0.0, 1e6})
      for (const StandardView side : {StandardView::front, StandardView::back, StandardView::left,
                                      StandardView::right, StandardView::top, StandardView::bottom}) {
        Camera camera = Camera::standard(side);
        EXPECT_FALSE(side_plane(camera)) << "perspective";
        camera.orthographic = true;
        camera.distance = 12 * scale;
        camera.target = scale * Vector3(shift + 0.3, shift - 0.7, shift + 1.1);
        const auto plane = side_plane(camera);
        ASSERT_TRUE(plane);
        EXPECT_EQ(plane->normal(), side == StandardView::top || side == StandardView::bottom   ? 2
                                   : side == StandardView::front || side == StandardView::back ? 1
                                                                                               : 0);
        const PixelSize size{900, 600};
        int decimals = 0;
        const auto labels = grid_labels(camera, size, {}, 64, decimals);
        EXPECT_GE(labels.size(), 6U);
        const Projector projector(camera, size);
        for (const GridLabel& label : labels) {
          Vector3 on_line = camera.target;
          on_line[label.upright ? plane->across : plane->up] = label.value;
          const auto pixel = projector.project(on_line);
          ASSERT_TRUE(pixel);
          EXPECT_NEAR(label.upright ? pixel->x() : pixel->y(), label.pixel, 0.01);
        }
      }
}

TEST_F(SideViews, RightDragPansInRhinosParallelViews) {
  editor().settings.navigation = NavigationPreset::rhino;
  look("view.top");
  const Camera before = editor().camera();
  const Vector2 at = middle_of(0) + Vector2(180, 90);
  drag(at, {40, 0}, 1);
  EXPECT_EQ(editor().camera().orientation.coeffs(), before.orientation.coeffs())
      << "the view from the top stays";
  EXPECT_GT((editor().camera().target - before.target).norm(), 0);
  bench_.hold(true, true, false);
  drag(at, {40, 10}, 1);
  bench_.hold(false, false, false);
  EXPECT_NE(editor().camera().orientation.coeffs(), before.orientation.coeffs()) << "Ctrl+Shift turns it";
}

TEST_F(SideViews, LeavingFourViewsKeepsTheOneThatWasWorkedIn) {
  run("view.four");
  bench_.frame();
  const Vector2 front = middle_of(2), top = middle_of(1);
  bench_.move(front.x(), front.y());
  bench_.press();
  bench_.release();
  EXPECT_EQ(editor().layout.active(), 2);
  // On the way to the menu the pointer crosses another view.
  bench_.move(top.x(), top.y());
  EXPECT_EQ(editor().layout.active(), 1) << "keys act where the pointer is";
  bench_.move(top.x(), 4);
  EXPECT_EQ(editor().layout.active(), 2);
  run("view.four");
  bench_.frame();
  EXPECT_EQ(editor().layout.arrangement(), Arrangement::one);
  EXPECT_EQ(editor().layout.active(), 2);
}

}  // namespace
}  // namespace hariko

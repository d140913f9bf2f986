// Several views by hand: a drag in each of four moves a vertex in its plane, splitters and titles, the axis
// gizmo, the probe that stays.

#include <cmath>

#include "tests/workbench/program_hands.hpp"
#include "ui/editor/object_kind.hpp"

namespace hariko::test {
namespace {

class FourViews : public ::testing::Test, protected ProgramHands {
 protected:
  FourViews() : ProgramHands(Begin::start_page, std::make_shared<TemporaryFolder>(), {1280, 800}) {}
  void SetUp() override {
    open_sample("fig2");
    ASSERT_TRUE(editor().active_object() && editor().active_object()->polyhedron()) << notice();
    press({"Ctrl+Alt+Q"});
    wait();
    for (const char* view : {"view.0", "view.1", "view.2", "view.3"})
      ASSERT_TRUE(marks().contains(view)) << view;
  }
  /// Makes the view under the pointer the active one.
  void go_to(int view) {
    const Vector2 middle = middle_of("view." + std::to_string(view));
    bench().move(middle.x(), middle.y());
    frames(4);
    ASSERT_EQ(editor().layout.active(), view);
  }
  static double area(const Marks::Rect& rect) { return double(rect.width) * rect.height; }
};

TEST_F(FourViews, ADragInEachMovesAVertexInItsPlane) {
  double sum = 0;
  for (int view = 0; view < 4; ++view) sum += area(marks().at("view." + std::to_string(view)));
  EXPECT_GT(sum, 0.97 * area(marks().at("viewport"))) << "the views do not fill the viewport";
  std::size_t steps = 0;
  for (const int view : {1, 2, 3, 0}) {
    SCOPED_TRACE(view);
    go_to(view);
    const Document before = editor().document();
    const Vector2 from = nearest_corner(), to = from + Vector2(24, -16);
    drag(from, to);
    wait();
    EXPECT_EQ(editor().history.position(), ++steps);
    EXPECT_EQ(editor().layout.active(), view);
    ASSERT_EQ(selected(), "1 vertex");
    const ElementRef vertex{editor().selection.active,
                            element_of(*editor().selection.of_active().vertices.begin())};
    const Vector3 now = *place_of(editor().document(), vertex), way = now - *place_of(before, vertex);
    EXPECT_LT((pixel(now) - to).cwiseAbs().maxCoeff(), 2) << "the vertex is not under the pointer";
    EXPECT_LT(std::abs(way.dot(editor().camera().forward())), 1e-6 * way.norm());
  }
}

TEST_F(FourViews, TheSplitterIsDraggedAndATitleMaximisesItsView) {
  const Vector2 before = middle_of("splitter.middle");
  drag(before, before + Vector2(-100, 60));
  wait();
  EXPECT_LE((middle_of("splitter.middle") - before - Vector2(-100, 60)).cwiseAbs().maxCoeff(), 2);
  click(middle_of("view.2.title"), 2);
  wait();
  EXPECT_FALSE(marks().contains("view.0"));
  EXPECT_EQ(marks().at("view.2"), marks().at("viewport")) << "it does not fill the viewport";
  press({"Ctrl+Space"});
  wait();
  EXPECT_TRUE(marks().contains("view.0"));
}

TEST_F(FourViews, TheGizmoLooksAlongItsAxesAndTurnsTheView) {
  go_to(0);
  click(middle_of("view.0.axes+z"));
  wait();
  // From the top x points to the right and y upwards.
  const Vector2 z = middle_of("view.0.axes+z"), x = middle_of("view.0.axes+x") - z,
                y = middle_of("view.0.axes+y") - z;
  EXPECT_GT(x.x(), 20);
  EXPECT_LE(std::abs(x.y()), 2);
  EXPECT_LT(y.y(), -20);
  EXPECT_LE(std::abs(y.x()), 2);
  drag(z + Vector2(8, 8), z + Vector2(60, 40));
  wait();
  EXPECT_GT(std::abs(middle_of("view.0.axes+x").y() - z.y() - x.y()), 1) << "the view did not turn";
}

TEST_F(FourViews, TheProbeReadsTheSurfaceAndStays) {
  press({"Ctrl+Alt+Q"});
  wait();
  bench().workbench().commands().run("analyse.mean");
  wait();
  for (const double x : {0.5, 0.45, 0.55, 0.4, 0.6}) {
    if (marks().contains("probe")) break;
    const Vector2 at = in_view(x, 0.47);
    bench().move(at.x(), at.y());
    frames(6);
  }
  EXPECT_TRUE(marks().contains("probe"));
  press({"Ctrl+Alt+P"});
  wait();
  EXPECT_TRUE(marks().contains("probe.kept"));
}

}  // namespace
}  // namespace hariko::test

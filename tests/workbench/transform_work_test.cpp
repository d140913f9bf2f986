// Selecting and transforming by hand, on a flat grid whose numbers are easy to read: typed and dragged
// transforms, handles, boxes, loops, soft selection, a view that turns meanwhile, tension.

#include <sstream>
#include <string>

#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

/// 4 x 4 squares of side 10, seen from above; vertex 5 y + x is at (10 x, 10 y, 0).
class GridWork : public ::testing::Test, protected ProgramHands {
 protected:
  static constexpr unsigned middle = 12;

  void SetUp() override {
    constexpr int side = 4, step = 10;
    std::ostringstream text;
    for (int y = 0; y <= side; ++y)
      for (int x = 0; x <= side; ++x) text << "v " << step * x << ' ' << step * y << " 0\n";
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const int a = y * (side + 1) + x + 1;
        text << "f " << a << ' ' << a + 1 << ' ' << a + side + 2 << ' ' << a + side + 1 << '\n';
      }
    spill(folder() / "grid.obj", text.str());
    session().open(folder() / "grid.obj");
    wait();
    press({"Num 7", "Home"});
    wait();
    ASSERT_EQ(place(middle), Vector3(20, 20, 0));
  }
  const PolyhedronSource& source() { return *editor().active_object()->polyhedron(); }
  Vector3 place(unsigned vertex) {
    return source().origin + source().polyhedron.position(source().polyhedron.find(VertexId{vertex}));
  }
  Vector2 at(unsigned vertex) { return pixel(place(vertex)); }
  bool moving() { return editor().history.in_gesture(); }
  void take_the_middle() {
    click(at(middle));
    frames(2);
    ASSERT_EQ(selected(), "1 vertex");
  }
  void undo(int steps = 1) {
    for (int i = 0; i < steps; ++i) press({"Ctrl+Z"});
    wait();
  }
};

TEST_F(GridWork, ATypedMoveIsExact) {
  take_the_middle();
  press({"G", "X", "1", "0", "Enter"});
  wait();
  expect_step(1, "Move vertex");
  EXPECT_EQ(place(middle), Vector3(30, 20, 0));
}

TEST_F(GridWork, AnArrowMovesAlongItsAxisAndAsksForANumberWhenItIsClicked) {
  take_the_middle();
  const Vector2 grip = middle_of("gizmo.move.y");
  drag(grip, grip + Vector2(25, -60));
  wait();
  expect_step(1, "Move vertex");
  EXPECT_EQ(place(middle).x(), 20);
  EXPECT_EQ(place(middle).z(), 0);
  EXPECT_GT(place(middle).y(), 21);
  undo();
  click("gizmo.move.x");
  type("-3");
  press({"Enter"});
  wait();
  expect_step(1, "Move vertex");
  EXPECT_EQ(place(middle), Vector3(17, 20, 0));
}

TEST_F(GridWork, ABoxToTheRightTakesWhatLiesInsideAndOneToTheLeftWhatItTouches) {
  // Round the four faces in the middle.
  const Vector2 a = at(6), b = at(18);
  const Vector2 low = a.cwiseMin(b) - Vector2(12, 12), high = a.cwiseMax(b) + Vector2(12, 12);
  press({"3", "B"});
  drag(low, high);
  EXPECT_EQ(selected(), "4 faces");
  press({"B"});
  drag(high, low);
  EXPECT_EQ(selected(), "16 faces");
}

TEST_F(GridWork, ALoopOfADoubleClickIsTurnedAndScaledAboutItsMiddle) {
  press({"2"});
  click((at(11) + at(middle)) / 2, 2);
  EXPECT_EQ(selected(), "4 edges");
  press({"Ctrl+1"});
  EXPECT_EQ(selected(), "5 vertices");
  press({"R", "Z", "9", "0", "Enter"});
  wait();
  expect_step(1, "Rotate 5 vertices");
  EXPECT_LT((place(10) - Vector3(20, 0, 0)).norm(), 1e-9);
  press({"S", "2", "Enter"});
  wait();
  expect_step(2, "Scale 5 vertices");
  EXPECT_LT((place(10) - Vector3(20, -20, 0)).norm(), 1e-9);
  undo(2);
  EXPECT_EQ(selected(), "5 vertices");
}

TEST_F(GridWork, NeighboursFollowSoftlyAndTheSurfaceIsWholeBeforeTheEnd) {
  press({"Num 0"});
  wait();
  take_the_middle();
  press({"O", "G", "Z", "8"});
  EXPECT_TRUE(moving());
  for (int i = 0; i < 2; ++i) wait();  // a gesture counts as at rest after a while
  EXPECT_TRUE(moving());
  const SurfaceView* view = editor().view_of(editor().selection.active);
  ASSERT_TRUE(view && view->mesh);
  EXPECT_EQ(view->quality, Quality::final);
  press({"Enter"});
  wait();
  expect_step(1, "Move vertex");
  EXPECT_EQ(place(middle).z(), 8);
  EXPECT_GT(place(middle + 1).z(), 0);
  EXPECT_LT(place(middle + 1).z(), 8);
}

TEST_F(GridWork, TheViewTurnsInTheMiddleOfAMoveWithoutEndingIt) {
  press({"Num 0"});
  wait();
  take_the_middle();
  const Document before = editor().document();
  const Eigen::Vector4d turned = editor().camera().orientation.coeffs();
  const Vector2 from = at(middle);
  press({"G"});
  bench().move(from.x() + 40, from.y());
  EXPECT_TRUE(moving());
  drag(from + Vector2(40, 0), from + Vector2(120, 10), 2);
  EXPECT_TRUE(moving());
  EXPECT_GT((editor().camera().orientation.coeffs() - turned).norm(), 1e-3);
  press({"Esc"});
  EXPECT_EQ(editor().history.position(), 0U);
  EXPECT_EQ(editor().document(), before);
}

TEST_F(GridWork, TensionIsDraggedAndTyped) {
  take_the_middle();
  bench().move(640, 500);
  press({"T"});
  bench().move(720, 500);
  EXPECT_TRUE(moving());
  click(Vector2(720, 500));
  wait();
  expect_step(1, "Tension of vertices");
  press({"T", "7", "Enter"});
  wait();
  expect_step(2, "Tension of vertices");
  EXPECT_EQ(source().shaping->alpha.get_or(VertexId{middle}, 0), 7);
}

}  // namespace
}  // namespace hariko::test

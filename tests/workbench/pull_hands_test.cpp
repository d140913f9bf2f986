// The surface around solids pulled by hand.

#include <algorithm>

#include "core/document/edits/edit_solids.hpp"
#include "core/envelope/solid.hpp"
#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

class PullByHand : public ::testing::Test, protected ProgramHands {
 protected:
  void SetUp() override {
    ASSERT_TRUE(bench().workbench().commands().run("solid.sphere").ran);
    wait();
  }
  const Object& object() { return *editor().document().objects.front(); }
  const Solid& solid() { return object().solids()->input->solids.front(); }
  Vector2 pixel(const Vector3& world) {
    const ImVec2 corner = bench().workbench().viewport().rect().min;
    return Projector(editor().camera(), editor().viewport).project(world)->head<2>() +
           Vector2(double(corner.x), double(corner.y));
  }
  Vector3 pulled_place() { return object().transform.apply(placed(solid(), solid().pulls.front().place)); }
  void begin() {
    press({"F3"});
    type("Pull surface");
    press({"Enter"});
    wait();
  }
  /// From a pixel to another one, with some frames between.
  void drag_by(const Vector2& from, const Vector2& way) {
    bench().move(from.x(), from.y());
    bench().press();
    for (int k = 1; k <= 4; ++k) bench().move(from.x() + way.x() * k / 4, from.y() + way.y() * k / 4);
    bench().release();
    wait();
  }
  /// Distance of the shown surface from a point of the world.
  double distance_to(const Vector3& point) {
    const Surface& surface = editor().view_of(object().id)->surface;
    double least = 1e300;
    constexpr int steps = 12;
    for (Index p = 0; p < surface.patch_count(); ++p)
      for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
          const Vector2 at(i / double(steps), j / double(steps));
          const Vector3 here = surface.origin() + surface.patches().evaluate(p, at, Order::first).position;
          least = std::min(least, (object().transform.apply(here) - point).norm());
        }
    return least;
  }
};

TEST_F(PullByHand, TheSurfaceFollowsThePointerAndPlacesCanBeMovedAndRemoved) {
  const double radius = object().transform.scale * solid().radius;
  const Vector2 middle = pixel(object().transform.apply(solid().position));
  begin();
  EXPECT_NE(bench().workbench().viewport().hint().find("Pull surface"), std::string::npos);
  drag_by(middle, {0, -90});
  ASSERT_EQ(solid().pulls.size(), 1U) << notice();
  EXPECT_EQ(editor().history.undo_label(), "Pull surface");
  EXPECT_LT(distance_to(pulled_place()), 0.05 * radius);
  EXPECT_GT(distance_to(object().transform.apply(solid().position)), 0.9 * radius) << "the ball stays inside";

  // The tool goes on: the same place, farther.
  const Vector2 first = pixel(pulled_place());
  EXPECT_LT((first - (middle + Vector2(0, -90))).norm(), 2);
  drag_by(first, {40, -20});
  ASSERT_EQ(solid().pulls.size(), 1U);
  EXPECT_EQ(editor().history.undo_label(), "Move pull");
  EXPECT_LT((pixel(pulled_place()) - first - Vector2(40, -20)).norm(), 2);
  EXPECT_LT(distance_to(pulled_place()), 0.05 * radius);

  // It moves with its solid.
  const Vector3 before = pulled_place();
  bench().key("Esc");
  const std::uint32_t id = solid().id;
  ASSERT_TRUE(editor().commit(change_solids(editor().history.current(), object().id, {&id, 1},
                                            [&](Solid& moved) { moved.position.x() += radius; }),
                              "Move"));
  EXPECT_NEAR((pulled_place() - before).norm(), object().transform.scale * radius, 1e-6 * radius);
  press({"Ctrl+Z"});
  wait();

  begin();
  const Vector2 place = pixel(pulled_place());
  bench().move(place.x(), place.y());
  bench().key("Del");
  wait();
  EXPECT_TRUE(solid().pulls.empty());
  bench().key("Esc");
  press({"Ctrl+Z"});
  ASSERT_EQ(solid().pulls.size(), 1U);
  ASSERT_TRUE(bench().workbench().commands().run("solid.sphere").ran);
  EXPECT_FALSE(bench().workbench().commands().run("solid.remove_pulls").ran) << "another solid is selected";
  editor().mode = ElementMode::object;  // an object is selected as a whole only
  EXPECT_TRUE(bench().workbench().commands().run("solid.remove_pulls").ran);
  EXPECT_TRUE(solid().pulls.empty());
  EXPECT_FALSE(bench().workbench().commands().run("solid.remove_pulls").ran) << "there are none";
}

TEST_F(PullByHand, EscapeTakesADragBackAndTheWheelChangesTheRadius) {
  const Vector2 middle = pixel(object().transform.apply(solid().position));
  begin();
  bench().move(middle.x(), middle.y());
  bench().press();
  bench().move(middle.x() + 60, middle.y());
  ASSERT_EQ(solid().pulls.size(), 1U) << "it is seen while it is dragged";
  const double usual = solid().pulls.front().radius;
  bench().wheel(2);
  EXPECT_GT(solid().pulls.front().radius, 1.1 * usual);
  bench().key("Esc");
  bench().release();
  EXPECT_TRUE(solid().pulls.empty());
}

}  // namespace
}  // namespace hariko::test

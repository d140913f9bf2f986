#include "ui/editor/view_layout.hpp"

#include "tests/support/random.hpp"
#include "ui/view/axis_gizmo.hpp"
#include "ui/view/navigation.hpp"
#include "ui/view/view_frame.hpp"

namespace hariko {
namespace {

TEST(View, AxisViewsAreOrthographicUntilTheViewIsTurned) {
  View view;
  EXPECT_FALSE(view.goal().orthographic);
  view.look_from(StandardView::top, 0);
  EXPECT_TRUE(view.goal().orthographic);
  EXPECT_FALSE(view.camera(0.05).orthographic) << "the flight itself is in perspective";
  EXPECT_TRUE(view.camera(1).orthographic);
  EXPECT_EQ(side_of(view.camera(1)), StandardView::top);
  view.look_from(StandardView::right, 1);
  view.begin_turning(2);
  EXPECT_FALSE(view.goal().orthographic);

  view.toggle_orthographic();
  view.look_from(StandardView::front, 3);
  view.begin_turning(4);
  EXPECT_TRUE(view.goal().orthographic) << "who asked for parallel projection keeps it";
}

TEST(View, GoesBackAndForward) {
  View view;
  const Camera first = view.goal();
  view.look_from(StandardView::top, 0);
  const Camera second = view.goal();
  view.remember();
  Camera moved = second;
  moved.target = {1, 2, 3};
  view.set(moved);
  view.go_back(1);
  EXPECT_EQ(view.goal(), second);
  view.go_back(2);
  EXPECT_EQ(view.goal(), first);
  EXPECT_FALSE(view.can_go_back());
  view.go_forward(3);
  view.go_forward(4);
  EXPECT_EQ(view.goal(), moved);
  EXPECT_FALSE(view.can_go_forward());
}

TEST(ViewLayout, PanesCoverTheViewportAndTheActiveViewShows) {
  test::for_random(20'302, 200, [](std::mt19937_64& rng) {
    ViewLayout layout;
    for (int i = 0; i < 20; ++i) {
      switch (test::uniform_int(rng, 0, 3)) {
        case 0:
          layout.arrange(static_cast<Arrangement>(test::uniform_int(rng, 0, 2)));
          break;
        case 1:
          layout.toggle_maximised();
          break;
        case 2:
          layout.activate(test::uniform_int(rng, 0, ViewLayout::count - 1));
          break;
        default:
          layout.split_x = static_cast<float>(test::uniform(rng));
          layout.split_y = static_cast<float>(test::uniform(rng));
      }
      float area = 0;
      for (const Pane& pane : layout.panes()) {
        EXPECT_LT(pane.left, pane.right);
        EXPECT_LT(pane.top, pane.bottom);
        area += (pane.right - pane.left) * (pane.bottom - pane.top);
      }
      EXPECT_NEAR(area, 1, 1e-5);
      EXPECT_TRUE(layout.shows(layout.active()));
    }
  });
}

TEST(AxisGizmo, ABallLooksFromItsSideAndFromTheOtherOneWhenItFacesUs) {
  for (const StandardView from :
       {StandardView::iso, StandardView::front, StandardView::top, StandardView::left}) {
    const AxisGizmo gizmo(Camera::standard(from), {100, 100}, 40);
    for (const AxisGizmo::Ball& ball : gizmo.balls()) {
      if (ball.depth < -0.99) continue;  // hidden behind its opposite
      const StandardView expected = side_of_axis(ball.axis, ball.positive != (ball.depth > 0.999));
      EXPECT_EQ(gizmo.side_at(gizmo.centre_of(ball)), expected);
      EXPECT_TRUE(gizmo.holds(gizmo.centre_of(ball)));
      // The side shows the ball in the middle, towards us.
      const AxisGizmo there(Camera::standard(side_of_axis(ball.axis, ball.positive)), {0, 0}, 1);
      const AxisGizmo::Ball& nearest = there.balls().back();
      EXPECT_EQ(nearest.axis, ball.axis);
      EXPECT_EQ(nearest.positive, ball.positive);
    }
    EXPECT_FALSE(gizmo.holds({150, 100}));
  }
}

PointerEvent press(PointerButton button, bool shift = false, bool control = false, bool alt = false) {
  PointerEvent event{.kind = PointerEvent::Kind::press};
  event.button = button;
  event.shift = shift;
  event.control = control;
  event.alt = alt;
  return event;
}

TEST(Navigation, PresetsFollowTheirProducts) {
  using enum NavigationPreset;
  using enum NavigationAction;
  constexpr auto left = PointerButton::left, middle = PointerButton::middle, right = PointerButton::right;
  struct Case {
    NavigationPreset preset;
    PointerEvent event;
    std::optional<NavigationAction> action;
  };
  const std::vector<Case> cases{
      {hariko, press(middle), orbit},
      {hariko, press(right, true), pan},
      {hariko, press(middle, false, true), zoom},
      {hariko, press(left, false, false, true), orbit},
      {hariko, press(left), {}},
      {blender, press(middle), orbit},
      {blender, press(middle, true), pan},
      {blender, press(middle, false, true), zoom},
      {blender, press(right), {}},
      {blender, press(left, false, false, true), {}},
      {maya, press(left, false, false, true), orbit},
      {maya, press(middle, false, false, true), pan},
      {maya, press(right, false, false, true), zoom},
      {maya, press(middle), {}},
      {rhino, press(right), orbit},
      {rhino, press(right, true), pan},
      {rhino, press(right, false, true), zoom},
      {rhino, press(middle), {}},
      {trackpad, press(left, false, false, true), orbit},
      {trackpad, press(left, true, false, true), pan},
      {trackpad, press(left, false, true, true), zoom},
      {trackpad, press(right), {}},
  };
  for (std::size_t i = 0; i < cases.size(); ++i)
    EXPECT_EQ(navigation_action(cases[i].preset, cases[i].event), cases[i].action) << "case " << i;
  for (const NavigationPreset preset : {hariko, blender, maya, rhino, trackpad}) {
    EXPECT_EQ(navigation_action(preset, press(left)), std::nullopt) << "left alone selects";
    EXPECT_EQ(navigation_action(preset, press(left, true)), std::nullopt);
    EXPECT_EQ(wheel_action(preset, false, false), preset == trackpad ? orbit : zoom);
    EXPECT_EQ(wheel_action(preset, true, false), pan);
  }
}

TEST(ScaleBar, IsTheLongestRoundLengthThatFits) {
  test::for_random(20'303, 200, [](std::mt19937_64& rng) {
    const double longest = std::pow(10.0, test::uniform(rng, -6, 6));
    const double length = scale_bar_length(longest);
    EXPECT_LE(length, longest);
    EXPECT_GT(length, longest / 2.5001);
    const double digit = length / std::pow(10.0, std::floor(std::log10(length * 1.0000001)));
    EXPECT_TRUE(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6)
        << digit;
  });
}

}  // namespace
}  // namespace hariko

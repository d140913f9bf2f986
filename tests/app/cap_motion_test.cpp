// 3D mice: what a push and a turn of the cap do to the camera, and their events.

#include <limits>

#include "app/input/space_mouse.hpp"
#include "tests/support/random.hpp"
#include "ui/view/navigation.hpp"

namespace hariko::test {
namespace {

constexpr PixelSize cap_picture{800, 600};

Camera any_camera(std::mt19937_64& rng) {
  Camera camera = Camera::standard(StandardView::front).orbit(uniform(rng, -3, 3), uniform(rng, -1.2, 1.2));
  camera.target = random_vector(rng, 10);
  camera.distance = log_uniform(rng, 0.1, 100);
  camera.orthographic = chance(rng, 0.5);
  return camera;
}

CapMotion push(const Vector3& by) {
  return {by, Vector3::Zero(), 0.02};
}
CapMotion turn(const Vector3& by) {
  return {Vector3::Zero(), by, 0.02};
}

/// Pixel of a point that did not move, in the view of another camera.
Vector2 seen(const Camera& camera, const Vector3& point) {
  return Projector(camera, cap_picture).project(point)->head<2>();
}

TEST(CapMotion, TheModelGoesWhereTheCapIsPushed) {
  for_random(41, 100, [](std::mt19937_64& rng) {
    const Camera camera = any_camera(rng);
    const CapEffect effect;
    const double full = 0.02 * cap_pan * 600;  // pixels
    const Vector2 right = seen(moved_by_cap(camera, push({1, 0, 0}), effect), camera.target);
    EXPECT_NEAR(right.x(), 400 + full, 1e-6);
    EXPECT_NEAR(right.y(), 300, 1e-6);
    const Vector2 up = seen(moved_by_cap(camera, push({0, 0.5, 0}), effect), camera.target);
    EXPECT_NEAR(up.x(), 400, 1e-6);
    EXPECT_NEAR(up.y(), 300 - full / 2, 1e-6);
    EXPECT_LT(moved_by_cap(camera, push({0, 0, 1}), effect).distance, camera.distance) << "pulled nearer";
    // There and back again.
    const Camera away = moved_by_cap(camera, push({0, 0, -0.8}), effect);
    EXPECT_GT(away.distance, camera.distance);
    EXPECT_NEAR(moved_by_cap(away, push({0, 0, 0.8}), effect).distance, camera.distance,
                1e-12 * camera.distance);
  });
}

TEST(CapMotion, TheModelTurnsWithTheCapAboutTheTarget) {
  for_random(42, 100, [](std::mt19937_64& rng) {
    const Camera camera = any_camera(rng);
    for (const bool rolls : {false, true}) {
      CapEffect effect;
      effect.rolls = rolls;
      const Vector3 front = camera.target + 0.1 * camera.distance * camera.towards_eye();
      const Camera spun = moved_by_cap(camera, turn({0, 0.5, 0}), effect);
      EXPECT_LT((spun.target - camera.target).norm(), 1e-9 * camera.distance);
      EXPECT_NEAR(spun.distance, camera.distance, 1e-12 * camera.distance);
      EXPECT_GT(seen(spun, front).x(), 400) << "about the axis up, what is in front goes to the right";
      const Camera tipped = moved_by_cap(camera, turn({0.5, 0, 0}), effect);
      EXPECT_GT(seen(tipped, front).y(), 300) << "about the axis to the right, what is in front goes down";
      // About the axis to the viewer: counter-clockwise, or not at all where the horizon stays level.
      const Vector3 side = camera.target + 0.1 * camera.distance * camera.right();
      const Vector2 rolled = seen(moved_by_cap(camera, turn({0, 0, 0.5}), effect), side);
      if (rolls)
        EXPECT_LT(rolled.y(), 300 - 1e-3);
      else
        EXPECT_NEAR(rolled.y(), 300, 1e-6);
    }
  });
}

TEST(CapMotion, HorizonsStayLevelAndAnglesAddUp) {
  for_random(43, 100, [](std::mt19937_64& rng) {
    Camera camera = any_camera(rng);
    for (int i = 0; i < 20; ++i) camera = moved_by_cap(camera, turn(random_vector(rng, 1)), {});
    EXPECT_NEAR(camera.right().z(), 0, 1e-9);
    CapEffect free{.rolls = true};
    const Camera once = moved_by_cap(camera, {Vector3::Zero(), Vector3(0.3, -0.2, 0.4), 0.04}, free);
    const CapMotion half{Vector3::Zero(), Vector3(0.3, -0.2, 0.4), 0.02};
    const Camera twice = moved_by_cap(moved_by_cap(camera, half, free), half, free);
    EXPECT_LT(once.orientation.angularDistance(twice.orientation), 1e-7);
    EXPECT_NEAR(camera.orientation.angularDistance(once.orientation),
                cap_turn * 0.04 * Vector3(0.3, -0.2, 0.4).norm(), 1e-7);
  });
}

TEST(CapMotion, NothingRunsAway) {
  const Camera camera = Camera::standard(StandardView::iso);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(moved_by_cap(camera, {}, {}) == camera);
  EXPECT_TRUE(moved_by_cap(camera, push({std::nan(""), 0, 1}), {}) == camera);
  EXPECT_TRUE(moved_by_cap(camera, {Vector3(1, 1, 1), Vector3(1, 1, 1), -1}, {}) == camera);
  EXPECT_TRUE(moved_by_cap(camera, {Vector3(1, 1, 1), Vector3(1, 1, 1), infinity}, {}) == camera);
  // The first motion after a rest comes with the time of the rest.
  EXPECT_TRUE(moved_by_cap(camera, {Vector3(1, 0, 0), Vector3::Zero(), 3600}, {}) ==
              moved_by_cap(camera, {Vector3(1, 0, 0), Vector3::Zero(), longest_cap_motion}, {}));
  // A hand that pushes turns the cap a little, too.
  const Camera pushed = moved_by_cap(camera, {Vector3(1, 0, 0), Vector3(0, 0.01, 0), 0.02}, {});
  EXPECT_EQ(pushed.orientation.coeffs(), camera.orientation.coeffs());
  CapEffect plan{.turns = false};
  EXPECT_TRUE(moved_by_cap(camera, turn({1, 1, 1}), plan) == camera);
}

TEST(CapMotion, EventsOfTheDaemonHaveTheAxesOfTheCamera) {
  const InputEvent event = cap_event({350, -175, 70}, {35, 0, -350}, 16);
  EXPECT_EQ(event.kind, InputEvent::Kind::cap);
  EXPECT_EQ(event.cap, (std::array<double, 6>{1, -0.5, -0.2, -0.1, 0, -1}));
  EXPECT_DOUBLE_EQ(event.seconds, 0.016);
}

TEST(CapMotion, WithoutADaemonThereIsNoEvent) {
  SpaceMouse mouse([] { FAIL() << "nobody moves anything"; });
  EXPECT_TRUE(mouse.take().empty());
}

TEST(CapMotion, AFrameGetsAllMotionsThatWaitButButtonsAlone) {
  InputQueue queue;
  const auto add = [&](InputEvent::Kind kind) { queue.push({.kind = kind}); };
  using Kind = InputEvent::Kind;
  for (const Kind kind : {Kind::cap, Kind::cap, Kind::move, Kind::cap, Kind::cap_button, Kind::cap_button})
    add(kind);
  std::vector<std::size_t> sizes;
  while (!queue.empty()) sizes.push_back(queue.take().size());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{2, 1, 1, 1, 1}));
}

TEST(CapMotion, MotionsInARowAreOneStepToGoBackFrom) {
  Editor editor;
  editor.has_document = true;
  CapGesture gesture;
  const Camera before = editor.layout.active_view().goal();
  for (int i = 0; i < 10; ++i) {
    editor.now = 10 + 0.02 * i;
    gesture.move(editor, {Vector3(1, 0, 0), Vector3(0, 1, 0), 0.02});
  }
  EXPECT_FALSE(editor.camera() == before);
  editor.layout.active_view().go_back(editor.now);
  EXPECT_TRUE(editor.layout.active_view().goal() == before);
  EXPECT_FALSE(editor.layout.active_view().can_go_back());
}

}  // namespace
}  // namespace hariko::test

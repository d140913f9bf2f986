// The gizmo: which handle lies where, and what its drag does.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/app/tool_rig.hpp"
#include "tests/support/random.hpp"
#include "ui/view/gizmo.hpp"
#include "ui/view/transform_tool.hpp"

namespace hariko::test {
namespace {

TEST(Gizmo, AnArrowMovesAlongItsAxisOnlyAndAClickAsksForANumber) {
  Rig rig;
  rig.choose({6});
  Gizmo gizmo;
  gizmo.update(rig.editor, false);
  const double pixel = Projector(rig.editor.camera(), rig.editor.viewport).pixel_length_at({1, 1, 1});
  for (int axis = 0; axis < 3; ++axis) {
    const Vector2 grip = rig.pixel(Vector3(1, 1, 1) + 60 * pixel * Vector3::Unit(axis));
    const auto handle = gizmo.hit(grip);
    ASSERT_TRUE(handle.has_value());
    EXPECT_EQ(*handle, (GizmoHandle{TransformKind::move, {AxisLock::Kind::axis, axis, false}}));
    EXPECT_TRUE(gizmo.hit(grip + Vector2(4, 4)).has_value()) << "eight pixels are near enough";
    rig.start(make_transform_tool(handle->kind, DrivenBy::handle, handle->lock), grip);
    rig.move(grip + Vector2(20, -30));
    const Vector3 moved = rig.place({6}) - Vector3(1, 1, 1);
    EXPECT_GT(std::abs(moved[axis]), 1e-3);
    EXPECT_EQ(moved[(axis + 1) % 3], 0);
    EXPECT_EQ(moved[(axis + 2) % 3], 0);
    rig.escape();
  }
  const Vector2 grip = rig.pixel(Vector3(1, 1, 1) + 60 * pixel * Vector3::UnitZ());
  rig.start(make_transform_tool(TransformKind::move, DrivenBy::handle, {AxisLock::Kind::axis, 2, false}),
            grip);
  rig.send(PointerEvent::Kind::release, grip);
  ASSERT_NE(rig.tool, nullptr);
  EXPECT_TRUE(rig.tool->modal());
  rig.move({10, 10});
  EXPECT_EQ(rig.place({6}), Vector3(1, 1, 1)) << "only what is typed counts";
  rig.type("2.5");
  rig.enter();
  EXPECT_EQ(rig.place({6}), Vector3(1, 1, 3.5));
}

/// From whatever side one looks: no handle is shown that cannot be taken, and there is one of each kind.
TEST(Gizmo, EveryHandleThatIsShownHasRoomAndSomethingTurns) {
  Rig rig;
  rig.choose({6});
  test::for_random(20261126, 60, [&](auto& rng) {
    const double aside = test::uniform(rng, 0, 2 * std::numbers::pi), up = test::uniform(rng, -2, 0.8);
    rig.editor.set_camera(Camera::standard(StandardView::iso).orbit(aside, up));
    rig.editor.frame_all(true);
    Gizmo gizmo;
    gizmo.update(rig.editor, false);
    const Vector2 centre = rig.pixel({1, 1, 1});
    constexpr int reach = 150, step = 2;
    std::vector<std::pair<GizmoHandle, int>> rooms;
    for (int x = -reach; x <= reach; x += step)
      for (int y = -reach; y <= reach; y += step) {
        const auto handle = gizmo.hit(centre + Vector2(x, y));
        if (!handle) continue;
        auto found =
            std::find_if(rooms.begin(), rooms.end(), [&](const auto& each) { return each.first == *handle; });
        if (found == rooms.end()) found = rooms.insert(found, {*handle, 0});
        found->second += step * step;
      }
    std::array<int, 3> kinds{};
    for (const auto& [handle, room] : rooms) {
      EXPECT_GE(room, 80) << "kind " << int(handle.kind) << ", axis " << handle.lock.axis;
      ++kinds[static_cast<std::size_t>(handle.kind)];
    }
    for (const int kind : kinds) EXPECT_GE(kind, 1) << "nothing moves, nothing turns or nothing scales";
  });
}

TEST(Gizmo, HidesWithoutASelection) {
  Rig rig;
  Gizmo gizmo;
  gizmo.update(rig.editor, false);
  for (int x = 0; x < 800; x += 8)
    for (int y = 0; y < 600; y += 8) ASSERT_FALSE(gizmo.hit(Vector2(x, y)).has_value());
}

}  // namespace
}  // namespace hariko::test

// The gizmo: which handle lies where, and what its drag does.

#include <cmath>

#include "tests/app/tool_rig.hpp"
#include "ui/tools/gizmo.hpp"
#include "ui/tools/transform_tool.hpp"

namespace hariko {
namespace {

using test::Rig;

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

TEST(Gizmo, HidesWithoutASelection) {
  Rig rig;
  Gizmo gizmo;
  gizmo.update(rig.editor, false);
  for (int x = 0; x < 800; x += 8)
    for (int y = 0; y < 600; y += 8) ASSERT_FALSE(gizmo.hit(Vector2(x, y)).has_value());
}

}  // namespace
}  // namespace hariko

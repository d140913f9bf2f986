// On displays of many pixels the hand must hit what the eye sees: radii, thresholds and ways follow the
// scale.

#include "tests/app/tool_rig.hpp"
#include "ui/polyhedron/tension_tool.hpp"
#include "ui/view/gizmo.hpp"
#include "ui/view/snapping.hpp"

namespace hariko::test {
namespace {

TEST(PixelScale, ReachesTheSceneTheGizmoAndTheThresholdOfDrags) {
  for (const double scale : {1.0, 1.5, 2.0}) {
    Rig rig;
    rig.editor.pixel_scale = scale;
    rig.choose({6});
    EXPECT_EQ(rig.scene.scene().pixel_scale, scale);
    Gizmo gizmo;
    gizmo.update(rig.editor, false);
    const double pixel =
        scale * Projector(rig.editor.camera(), rig.editor.viewport).pixel_length_at({1, 1, 1});
    const Vector2 grip = rig.pixel(Vector3(1, 1, 1) + 91 * pixel * Vector3::UnitZ());  // beyond the arcs
    ASSERT_TRUE(gizmo.hit(grip).has_value());
    EXPECT_TRUE(gizmo.hit(grip + Vector2(0.95 * Gizmo::hit_radius * scale, 0)).has_value());
    EXPECT_FALSE(gizmo.hit(grip + Vector2(1.05 * Gizmo::hit_radius * scale, 0)).has_value());

    rig.editor.selection.clear_elements();
    const Vector2 corner = rig.pixel({1, 1, 1});
    rig.start(make_select_tool(), corner);
    rig.move(corner + Vector2(0.9 * drag_threshold * scale, 0));
    EXPECT_FALSE(rig.editor.history.in_gesture()) << "still a click";
    rig.move(corner + Vector2(1.1 * drag_threshold * scale, 0));
    EXPECT_TRUE(rig.editor.history.in_gesture());
    rig.escape();
  }
}

TEST(PixelScale, SnappingReachesAsFarAsItLooks) {
  Rig rig;
  const Vector2 other = rig.pixel({1, -1, 1});
  for (const double scale : {1.0, 2.0}) {
    rig.editor.pixel_scale = scale;
    rig.choose({6});
    const TransformTarget target = TransformTarget::of(rig.editor);
    const SnapPlaces places(rig.context(), SnapSettings{});
    const SnapGesture gesture{SnapSettings{}, {}, Vector3::UnitZ(), &target};
    const Vector2 away(0, -1);  // above the model: nothing else is near
    EXPECT_TRUE(places.nearest(rig.context(), gesture, other + 0.95 * snap_radius * scale * away));
    EXPECT_FALSE(places.nearest(rig.context(), gesture, other + 1.05 * snap_radius * scale * away));
  }
}

TEST(PixelScale, ATensionDoublesOverTheSameWayOfTheHand) {
  for (const double scale : {1.0, 2.0}) {
    Rig rig;
    rig.editor.pixel_scale = scale;
    rig.editor.mode = ElementMode::edge;
    const ObjectId id = rig.editor.document().objects[0]->id;
    const EdgeId edge = EdgeId::of({5}, {6});
    rig.editor.selection.select({id, element_of(edge)}, Selection::How::replace);
    rig.start(std::make_unique<TensionTool>(), {300, 300});
    rig.move({300 + scale * TensionTool::doubling_pixels, 300});
    EXPECT_NEAR(rig.source().shaping->beta.get_or(edge, 1), 2, 1e-9);
  }
}

}  // namespace
}  // namespace hariko::test

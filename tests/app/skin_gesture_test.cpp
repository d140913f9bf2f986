// Strokes over a skin, and dragging of its points, without a window.

#include <algorithm>

#include "core/skinning/simple_skin.hpp"
#include "tests/app/tool_rig.hpp"
#include "ui/tools/correspond_tool.hpp"
#include "ui/tools/skin_tool.hpp"

namespace hariko::test {
namespace {

Document skin_document(const Skin& skin) {
  return add_object({}, "skin", Source(SkinSource{skin, {}}), {}).value().document;
}

struct SkinRig : Rig {
  explicit SkinRig(const Skin& skin = arched_skin(6, 4, 1, 7)) : Rig(skin_document(skin)) {
    editor.set_camera(Camera::standard(StandardView::top));
    editor.frame_all(true);
    view = view_of(this->skin(), surfacer);
  }
  const Object& object() const { return *editor.document().objects[0]; }
  const Skin& skin() const { return *object().skin()->skin; }
  /// The pixel of a section point: of its place on the curve.
  Vector2 point(std::uint32_t id) const {
    Vector2 out = Vector2::Zero();
    for (const SkinView::Handle& handle : view.handles)
      if (handle.id == id) out = pixel(handle.position);
    return out;
  }
  Vector2 between(std::uint32_t a, std::uint32_t b) const { return (point(a) + point(b)) / 2; }
  Result<CorrespondenceEdit> draw(StrokeKind kind, std::vector<Vector2> points) const {
    return gesture_edit(skin(), view, object(), Projector(editor.camera(), editor.viewport),
                        {kind, std::move(points)}, 1);
  }
  SkinSurfacer surfacer;
  SkinView view;
};

using Ids = std::vector<std::uint32_t>;

TEST(SkinGesture, ALineJoinsPointsNearItsEnds) {
  const SkinRig rig;
  const auto edit =
      rig.draw(StrokeKind::line, {rig.point(2) + Vector2(5, -4), rig.point(10) + Vector2(3, 6)});
  ASSERT_TRUE(edit.ok()) << to_string(edit.error());
  ASSERT_EQ(edit->skin.links.size(), 1U);
  EXPECT_EQ(edit->skin.links[0].a, Ids{2});
  EXPECT_EQ(edit->skin.links[0].b, Ids{10});
  EXPECT_EQ(rig.draw(StrokeKind::line, {rig.point(2), rig.point(5)}).error().code, e_no_gesture);
  EXPECT_EQ(rig.draw(StrokeKind::line, {Vector2(2, 2), rig.point(5)}).error().code, e_no_gesture);
}

TEST(SkinGesture, ALineOverThreeSectionsMakesAChain) {
  Skin skin = arched_skin(6, 4, 1, 7);
  SkinSection middle = skin.sections[0];
  middle.id = 2, middle.v = 0.5;
  for (SectionPoint& p : middle.points) p.id += 100, p.position.x() = 0;
  skin.sections.insert(skin.sections.begin() + 1, middle);
  const SkinRig rig(skin);
  const auto edit = rig.draw(StrokeKind::line, {rig.point(2), rig.point(9)});
  ASSERT_TRUE(edit.ok()) << to_string(edit.error());
  ASSERT_EQ(edit->skin.links.size(), 2U);
  EXPECT_EQ(edit->skin.links[0].b, Ids{102});
  EXPECT_EQ(edit->skin.links[1].a, Ids{102});
}

TEST(SkinGesture, ACurveGroupsWhatIsInside) {
  const SkinRig rig;
  const Vector2 out = (rig.point(3) - rig.point(10)).normalized() * 15;
  const auto edit = rig.draw(StrokeKind::lasso, {rig.between(1, 2) + out, rig.between(3, 4) + out,
                                                 rig.between(10, 11) - out, rig.between(9, 8) - out});
  ASSERT_TRUE(edit.ok()) << to_string(edit.error());
  ASSERT_EQ(edit->skin.links.size(), 1U);
  EXPECT_TRUE(edit->skin.links[0].lasso);
  EXPECT_EQ(edit->skin.links[0].a, (Ids{2, 3}));
  EXPECT_EQ(edit->skin.links[0].b, (Ids{9, 10}));
  EXPECT_EQ(rig.draw(StrokeKind::lasso, {{1, 1}, {9, 1}, {5, 9}}).error().code, e_no_gesture);
}

TEST(SkinGesture, AWedgeMergesAtItsTipFromEitherSide) {
  const SkinRig rig;
  const Vector2 tip = (rig.point(3) + rig.point(10)) / 2;
  const auto edit = rig.draw(StrokeKind::wedge, {rig.between(1, 2), tip, rig.between(4, 5)});
  ASSERT_TRUE(edit.ok()) << to_string(edit.error());
  ASSERT_EQ(edit->skin.merges.size(), 1U);
  const SkinMerge& merge = edit->skin.merges[0];
  EXPECT_EQ(merge.members, (Ids{2, 3, 4}));
  EXPECT_EQ(merge.target, 10U);
  EXPECT_EQ(merge.side, StripSide::a);
  EXPECT_NEAR(merge.v, 0.5, 0.05);
  const auto back = rig.draw(StrokeKind::wedge, {rig.between(8, 9), tip, rig.between(11, 12)});
  ASSERT_TRUE(back.ok()) << to_string(back.error());
  EXPECT_EQ(back->skin.merges[0].side, StripSide::b);
  EXPECT_EQ(back->skin.merges[0].members, (Ids{9, 10, 11}));
  EXPECT_EQ(back->skin.merges[0].target, 3U);
  // With its tip at a point of the other section it is a group.
  const auto group = rig.draw(StrokeKind::wedge, {rig.between(1, 2), rig.point(10), rig.between(4, 5)});
  ASSERT_TRUE(group.ok()) << to_string(group.error());
  EXPECT_TRUE(group->skin.merges.empty());
  EXPECT_EQ(group->skin.links.at(0).b, Ids{10});
  EXPECT_EQ(rig.draw(StrokeKind::wedge, {{2, 2}, {30, 30}, {60, 2}}).error().code, e_no_gesture);
}

TEST(SkinTool, DragsPointsInThePlaneOfTheirSection) {
  SkinRig rig;
  rig.editor.set_camera(Camera::standard(StandardView::iso));
  rig.editor.frame_all(true);
  const Skin before = rig.skin();
  PointerEvent press;
  press.kind = PointerEvent::Kind::press;
  press.pixel = rig.point(3);
  auto tool = skin_tool_at(rig.context(), press);
  ASSERT_NE(tool, nullptr);
  ToolContext context = rig.context();
  tool->begin(context, press);
  PointerEvent move = press;
  move.kind = PointerEvent::Kind::move;
  move.pixel += Vector2(4, -60);
  EXPECT_EQ(tool->update(context, move), ToolState::stay);
  EXPECT_TRUE(rig.editor.history.in_gesture());
  move.kind = PointerEvent::Kind::release;
  EXPECT_EQ(tool->update(context, move), ToolState::commit);
  EXPECT_EQ(rig.editor.history.position(), 1U);
  const auto old = limit_points(before.sections[0].curve()),
             now = limit_points(rig.skin().sections[0].curve());
  EXPECT_NEAR(now[3].x(), old[3].x(), 1e-9) << "it left the plane of its section";
  EXPECT_GT(now[3].z(), old[3].z() + 0.1);
  for (const std::size_t i : {0U, 1U, 2U, 4U, 5U, 6U}) EXPECT_LT((now[i] - old[i]).norm(), 1e-9);
  EXPECT_LT((rig.pixel(now[3]) - move.pixel).norm(), 1) << "it is not under the pointer";
  // Undo brings all back, and beside the points there is no tool.
  rig.editor.undo();
  EXPECT_EQ(rig.skin(), before);
  press.pixel = {3, 3};
  EXPECT_EQ(skin_tool_at(rig.context(), press), nullptr);
}

}  // namespace
}  // namespace hariko::test

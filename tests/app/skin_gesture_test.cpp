// Strokes over a skin, and dragging of its points, without a window.

#include <algorithm>
#include <string>

#include "core/skinning/columns/simple_skin.hpp"
#include "core/skinning/edit/add_section.hpp"
#include "tests/app/skin_rig.hpp"
#include "ui/editor/skin_edits.hpp"
#include "ui/skin/correspondence_drag.hpp"
#include "ui/skin/skin_tools.hpp"

namespace hariko::test {
namespace {

struct GestureRig : SkinRig {
  explicit GestureRig(const Skin& skin = arched_skin(6, 4, 1, 7)) : SkinRig(skin, StandardView::top) {}
  /// The pixel of a section point: of its place on the curve.
  Vector2 point(std::uint32_t id) const {
    Vector2 out = Vector2::Zero();
    for (const SkinView::Handle& handle : view.handles)
      if (handle.id == id && handle.section >= 0 && handle.kind != SkinView::Handle::Kind::place)
        out = pixel(handle.position);
    return out;
  }
  Vector2 between(std::uint32_t a, std::uint32_t b) const { return (point(a) + point(b)) / 2; }
  Result<CorrespondenceEdit> draw(StrokeKind kind, std::vector<Vector2> points) const {
    return gesture_edit(skin(), view, object(), Projector(editor.camera(), editor.viewport),
                        {kind, std::move(points)}, 1);
  }
  void press(const Vector2& pixel) { send(PointerEvent::Kind::press, pixel); }
  void release(const Vector2& pixel) { send(PointerEvent::Kind::release, pixel); }
  void click(const Vector2& pixel) { move(pixel), press(pixel), release(pixel); }
  void drag(const Vector2& from, const Vector2& to) {
    move(from), press(from);
    for (int i = 1; i <= 4; ++i) move(from + (to - from) * i / 4);
    release(to);
  }
  std::size_t line_between(std::uint32_t a, std::uint32_t b) const {
    for (std::size_t l = 0; l < view.lines.size(); ++l)
      if (view.lines[l].a == a && view.lines[l].b == b) return l;
    ADD_FAILURE() << "no line from " << a << " to " << b;
    return 0;
  }
};

/// A third section in the middle.
Skin three_sections() {
  const Skin skin = arched_skin(6, 4, 1, 7);
  return add_section(skin, 0.5).value().skin;
}

using Ids = std::vector<std::uint32_t>;

TEST(SkinGesture, ALineJoinsPointsNearItsEnds) {
  const GestureRig rig;
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
  const GestureRig rig(skin);
  const auto edit = rig.draw(StrokeKind::line, {rig.point(2), rig.point(9)});
  ASSERT_TRUE(edit.ok()) << to_string(edit.error());
  ASSERT_EQ(edit->skin.links.size(), 2U);
  EXPECT_EQ(edit->skin.links[0].b, Ids{102});
  EXPECT_EQ(edit->skin.links[1].a, Ids{102});
}

TEST(SkinGesture, ACurveGroupsWhatIsInside) {
  const GestureRig rig;
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
  const GestureRig rig;
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
  GestureRig rig;
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

/// The curve of the first section after point 2 was dragged upwards.
std::vector<Vector3> dragged(const Skin& skin, bool control) {
  GestureRig rig(skin);
  rig.editor.set_camera(Camera::standard(StandardView::iso));
  rig.editor.frame_all(true);
  PointerEvent press;
  press.kind = PointerEvent::Kind::press;
  press.pixel = rig.point(2);
  rig.tool = skin_tool_at(rig.context(), press);
  EXPECT_NE(rig.tool, nullptr);
  if (!rig.tool) return {};
  ToolContext context = rig.context();
  rig.tool->begin(context, press);
  rig.move(press.pixel + Vector2(0, -50), false, control);
  rig.release(press.pixel + Vector2(0, -50));
  return limit_points(rig.skin().sections[0].curve());
}

TEST(SkinTool, WithControlOrAMirrorBothHalvesMove) {
  const Skin plain = arched_skin(6, 4, 1, 7);
  Skin mirrored = plain;
  mirrored.mirror = MirrorPlane{1, 0};
  const auto before = limit_points(plain.sections[0].curve());
  for (const bool mirror : {false, true})
    for (const bool control : {false, true}) {
      SCOPED_TRACE(std::to_string(mirror) + std::to_string(control));
      const auto limits = dragged(mirror ? mirrored : plain, control);
      ASSERT_EQ(limits.size(), before.size());
      EXPECT_GT(limits[2].z(), before[2].z() + 0.1);
      const Vector3 image(limits[4].x(), -limits[4].y(), limits[4].z());
      // With the mirror Ctrl is for one half, without for both.
      EXPECT_LT(mirror != control ? (limits[2] - image).norm() : (limits[4] - before[4]).norm(), 1e-9);
    }
}

TEST(SkinEdits, PointsGoWithTheirPartnersWhereThereIsAMirror) {
  Skin skin = arched_skin(6, 4, 1, 7);
  skin.mirror = MirrorPlane{1, 0};
  GestureRig rig(skin);
  rig.editor.selection.select({rig.object().id, element_of(VertexId{2})}, Selection::How::replace);
  rig.editor.selection.active = rig.object().id;
  EXPECT_EQ(with_mirrored(skin, {2}), (Ids{2, 4}));
  delete_selected_points(rig.editor);
  ASSERT_EQ(rig.skin().sections[0].size(), 5);
  EXPECT_EQ(find_point(rig.skin().sections[0], 4), -1);
  rig.editor.undo();
  skin.mirror.reset();
  EXPECT_EQ(with_mirrored(skin, {2}), (Ids{2}));
}

TEST(SkinView, TheSelectedPointsAreFramed) {
  GestureRig rig;
  rig.editor.mode = ElementMode::vertex;
  rig.editor.selection.select({rig.object().id, element_of(VertexId{2})}, Selection::How::replace);
  const Box3 box = rig.editor.selected_box();
  ASSERT_FALSE(box.isEmpty());
  EXPECT_TRUE(box.contains(rig.skin().sections[0].points[2].position));
  EXPECT_FALSE(box.contains(rig.skin().sections[0].points[4].position));
}

TEST(SkinGesture, LinesGoOnAcrossAllSections) {
  const GestureRig rig(three_sections());
  const Skin& skin = rig.skin();
  const auto point = [&](int k, int i) { return skin.sections[std::size_t(k)].points[std::size_t(i)].id; };
  for (int i = 0; i < 7; ++i) {
    const auto lines = connected_lines(rig.view, rig.line_between(point(1, i), point(2, i)));
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(rig.view.lines[lines[1]].a, point(0, i));
    EXPECT_EQ(rig.view.lines[lines[1]].b, point(1, i));
  }
  // The sketch of a section runs once over every line.
  EXPECT_EQ(section_sketch(rig.view, 0.25).size(), 7U);
  for (const Vector3& p : section_sketch(rig.view, 0.25)) EXPECT_NEAR(p.x(), -1.5, 0.2);
}

TEST(CorrespondTool, EndsOfLinesAreDraggedToOtherPoints) {
  GestureRig rig;
  rig.start(make_correspond_tool());
  const std::size_t line = rig.line_between(3, 10);
  const Projector projector(rig.editor.camera(), rig.editor.viewport);
  const auto ends = line_ends(rig.view, rig.object(), projector, line, rig.point(10), 1);
  ASSERT_EQ(ends.size(), 2U);
  ASSERT_TRUE(ends[0].at_b);
  rig.drag(ends[0].pixel, rig.point(11) + Vector2(4, 3));
  EXPECT_EQ(rig.editor.history.position(), 1U);
  ASSERT_EQ(rig.skin().links.size(), 1U);
  EXPECT_EQ(rig.skin().links[0].a, Ids{3});
  EXPECT_EQ(rig.skin().links[0].b, Ids{11});
  rig.update();
  const auto again = line_ends(rig.view, rig.object(), projector, rig.line_between(3, 11), rig.point(3), 1);
  ASSERT_EQ(again.size(), 2U);
  rig.drag(again[0].pixel, rig.point(4));
  ASSERT_EQ(rig.skin().links.size(), 1U);
  EXPECT_EQ(rig.skin().links[0].a, Ids{4});
  // Each drag is one step, which the tool undoes.
  rig.key(Key::z);
  EXPECT_EQ(rig.editor.history.position(), 2U) << "without Ctrl";
  ToolContext context = rig.context();
  rig.tool->key(context, {{Key::z, true, false, false}, 0});
  rig.tool->key(context, {{Key::z, true, false, false}, 0});
  EXPECT_EQ(rig.editor.history.position(), 0U);
  EXPECT_TRUE(rig.skin().links.empty());
  rig.tool->key(context, {{Key::y, true, false, false}, 0});
  EXPECT_EQ(rig.editor.history.position(), 1U);
}

TEST(CorrespondTool, DiamondsSnapToRowsUnlessTheyAreFree) {
  Skin skin = arched_skin(6, 4, 1, 7);
  skin = merge_points(skin, Ids{2, 3, 4}, 10, 0.37).value().skin;
  const GestureRig rig(skin);
  ASSERT_EQ(rig.view.diamonds.size(), 1U);
  const SkinView::Line& line = rig.view.lines[rig.line_between(3, 10)];
  MergeDrag drag(skin, rig.view, 0);
  const Projector projector(rig.editor.camera(), rig.editor.viewport);
  ASSERT_GT(line.points.size(), 3U);
  for (std::size_t i = 1; i + 1 < line.points.size(); ++i) {
    const Vector2 row = rig.pixel(line.points[i]);
    const auto snapped = drag.to({rig.object(), projector, row + Vector2(3, 2), 1, false});
    ASSERT_TRUE(snapped.ok()) << to_string(snapped.error());
    EXPECT_EQ(snapped->skin.merges.at(0).v, line.along[i]);
    const auto free = drag.to({rig.object(), projector, row + Vector2(3, 2), 1, true});
    ASSERT_TRUE(free.ok());
    EXPECT_NE(free->skin.merges.at(0).v, line.along[i]);
    EXPECT_NEAR(free->skin.merges.at(0).v, line.along[i], 0.05);
  }
}

TEST(SlideSectionTool, FollowsThePointerAndTypedNumbers) {
  GestureRig rig(three_sections());
  const std::uint32_t middle = rig.skin().sections[1].id;
  const auto place = [&](double v) { return rig.pixel(evaluate(rig.skin().path, v).position); };
  rig.start(make_slide_section_tool(middle, true), place(0.5));
  rig.move(place(0.5) + Vector2(10, 0));
  rig.move(place(0.7));
  EXPECT_NEAR(rig.skin().sections[1].v, 0.7, 0.01);
  EXPECT_NEAR(rig.skin().sections[1].points[0].position.x(), 6 * (0.7 - 0.5), 0.1) << "it is not carried";
  // Points of the path attract, except with Alt.
  rig.move(place(0.747));
  EXPECT_EQ(rig.skin().sections[1].v, 0.75);
  rig.type("40");
  EXPECT_NEAR(rig.skin().sections[1].v, 0.4, 1e-12);
  rig.enter();
  EXPECT_EQ(rig.tool, nullptr);
  EXPECT_EQ(rig.editor.history.position(), 1U);
  EXPECT_EQ(rig.editor.history.undo_label(), "Slide section");
  // Beyond its neighbours it does not go: what was good last stays, and Esc takes all back.
  rig.start(make_slide_section_tool(middle, true), place(0.4));
  rig.type("120");
  rig.enter();
  EXPECT_NE(rig.tool, nullptr) << "an error was confirmed";
  rig.escape();
  EXPECT_NEAR(rig.skin().sections[1].v, 0.4, 1e-12);
  EXPECT_EQ(rig.editor.history.position(), 1U);
}

TEST(SlideSectionTool, BeginsAtThePlaceOnThePath) {
  GestureRig rig(three_sections());
  const std::uint32_t middle = rig.skin().sections[1].id;
  // Beside the point of the path that lies there, too.
  PointerEvent press;
  press.kind = PointerEvent::Kind::press;
  press.pixel = rig.pixel(evaluate(rig.skin().path, 0.5).position) + Vector2(0, 9);
  rig.tool = skin_tool_at(rig.context(), press);
  ASSERT_NE(rig.tool, nullptr);
  ToolContext context = rig.context();
  rig.tool->begin(context, press);
  // A click selects the section.
  rig.release(press.pixel);
  EXPECT_EQ(rig.editor.selection.of(rig.object().id).vertices.size(), rig.skin().sections[1].points.size());
  rig.tool = skin_tool_at(rig.context(), press);
  ASSERT_NE(rig.tool, nullptr);
  rig.tool->begin(context, press);
  const Vector2 by = rig.pixel(evaluate(rig.skin().path, 0.63).position) -
                     rig.pixel(evaluate(rig.skin().path, 0.5).position);
  rig.move(press.pixel + by / 2);
  rig.move(press.pixel + by);
  rig.release(press.pixel + by);
  EXPECT_NEAR(rig.skin().sections[1].v, 0.63, 1e-3);
  EXPECT_EQ(rig.skin().sections[1].id, middle);
  EXPECT_EQ(rig.editor.history.position(), 1U);
}

TEST(AddSectionTool, AddsWhereTheSurfaceIsClicked) {
  for (const SkinMethod method : {SkinMethod::pleat, SkinMethod::smooth}) {
    Skin skin = arched_skin(6, 4, 1, 7);
    skin.method = method;
    skin.smooth.parameters = ColumnParameters::uniform;
    GestureRig rig(skin);
    rig.start(make_add_section_tool([&](ObjectId object, double place) {
      commit_skin(rig.editor, object, add_section(rig.skin(), place), "Add section");
    }));
    const Vector2 at = rig.pixel({-3 + 6 * 0.3, 0.5, 0.7});
    rig.click(at);
    ASSERT_EQ(rig.skin().section_count(), 3);
    EXPECT_NEAR(rig.skin().sections[1].v, 0.3, 0.03);
    EXPECT_EQ(rig.skin().sections[1].size(), 7);
    EXPECT_EQ(rig.editor.history.undo_label(), "Add section");
    rig.update();
    // Beside the surface nothing happens.
    rig.click({5, 5});
    EXPECT_EQ(rig.skin().section_count(), 3);
    rig.enter();
    EXPECT_EQ(rig.tool, nullptr);
  }
}

struct DrawingRig : Rig {
  DrawingRig() : Rig(Document{}) {
    editor.has_document = true;
    editor.set_camera(Camera::standard(StandardView::top));
  }
  void click(const Vector2& pixel) {
    move(pixel);
    send(PointerEvent::Kind::press, pixel);
    send(PointerEvent::Kind::release, pixel);
  }
  void stroke(const std::vector<Vector2>& pixels) {
    move(pixels.front());
    send(PointerEvent::Kind::press, pixels.front());
    for (const Vector2& pixel : pixels) move(pixel);
    send(PointerEvent::Kind::release, pixels.back());
  }
  /// The camera arrives.
  void wait() { editor.now += 1; }
};

TEST(DrawSkinTool, DrawsAPathAndTwoSections) {
  DrawingRig rig;
  rig.start(make_draw_skin_tool());
  rig.enter();
  ASSERT_NE(rig.tool, nullptr) << "there is nothing yet";
  for (const double x : {150.0, 300.0, 500.0, 650.0}) rig.click({x, 300});
  rig.enter();
  rig.wait();
  // The view looks along the path: an arch by hand.
  std::vector<Vector2> arch;
  for (int i = 0; i <= 60; ++i)
    arch.push_back({400 - 200 * std::cos(3.14159265 * i / 60), 380 - 150 * std::sin(3.14159265 * i / 60)});
  rig.stroke(arch);
  rig.enter();
  rig.wait();
  for (const auto& p : {Vector2(250, 380), Vector2(400, 300), Vector2(550, 380)}) rig.click(p);
  // Backspace takes the last point, then it is drawn anew.
  rig.key(Key::backspace);
  rig.click({560, 380});
  rig.enter();
  ASSERT_EQ(rig.tool, nullptr);
  ASSERT_EQ(rig.editor.document().objects.size(), 1U);
  EXPECT_EQ(rig.editor.history.position(), 1U);
  EXPECT_EQ(rig.editor.history.undo_label(), "Draw skin");
  const Skin& skin = *rig.editor.document().objects[0]->skin()->skin;
  EXPECT_EQ(skin.path.size(), 4);
  ASSERT_EQ(skin.section_count(), 2);
  EXPECT_GE(skin.sections[0].size(), 5);
  EXPECT_EQ(skin.sections[1].size(), 3);
  // In planes across the path, arching upwards.
  for (const SkinSection& section : skin.sections) {
    const CurvePoint at = evaluate(skin.path, section.v);
    for (const SectionPoint& p : section.points)
      EXPECT_NEAR((p.position - at.position).dot(at.first.normalized()), 0, 1e-9);
    const auto limits = limit_points(section.curve());
    EXPECT_GT(limits[limits.size() / 2].z(), limits.front().z() + 0.1);
  }
  EXPECT_TRUE(SkinSurfacer().surface(skin, Vector3::Zero()).ok());
}

TEST(DrawSkinTool, EscapeLeavesNothingAndTheViewAsItWas) {
  DrawingRig rig;
  const Camera before = rig.editor.camera();
  rig.start(make_draw_skin_tool());
  rig.click({200, 300});
  rig.click({600, 300});
  rig.enter();
  rig.wait();
  EXPECT_GT(rig.editor.camera().orientation.angularDistance(before.orientation), 0.5);
  rig.escape();
  rig.wait();
  EXPECT_TRUE(rig.editor.document().objects.empty());
  EXPECT_LT(rig.editor.camera().orientation.angularDistance(before.orientation), 1e-6);
}

TEST(DrawSectionTool, DrawsInThePlaneAcrossThePath) {
  GestureRig rig;
  rig.start(make_draw_section_tool());
  const Vector2 at = rig.pixel(evaluate(rig.skin().path, 0.4).position);
  rig.click(at + Vector2(0, 6));
  rig.editor.now += 1;
  rig.click({300, 320});
  rig.click({400, 200});
  rig.click({500, 320});
  rig.enter();
  ASSERT_EQ(rig.tool, nullptr);
  ASSERT_EQ(rig.skin().section_count(), 3);
  const SkinSection& section = rig.skin().sections[1];
  EXPECT_NEAR(section.v, 0.4, 1e-3);
  ASSERT_EQ(section.size(), 3);
  for (const SectionPoint& p : section.points) EXPECT_NEAR(p.position.x(), 6 * (section.v - 0.5), 1e-9);
  EXPECT_EQ(rig.editor.history.undo_label(), "Draw section");
}

}  // namespace
}  // namespace hariko::test

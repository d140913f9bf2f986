#include "ui/editor/editor.hpp"

#include "tests/app/tool_rig.hpp"
#include "ui/view/navigation.hpp"

namespace hariko {
namespace {

using test::cube_document;

/// An editor with a cube and a viewport, driven by pointer events as the window drives it.
struct EditorRig {
  Editor editor;
  SceneBuilder scene;
  std::unique_ptr<Tool> tool;
  PointerEvent press_event;

  EditorRig() {
    editor.viewport = {800, 600};
    editor.open(cube_document(), {});
    editor.frame_all(true);
    scene.update(editor);
  }
  Vector2 pixel_of(VertexId id) const {
    const PolyhedronSource& source = *editor.document().objects[0]->polyhedron();
    const Projector projector(editor.camera(), editor.viewport);
    return projector.project(source.origin + source.polyhedron.position(source.polyhedron.find(id)))
        ->head<2>();
  }
  ToolContext context() { return {editor, scene}; }
  void press(const Vector2& pixel, PointerButton button = PointerButton::left, bool shift = false,
             bool control = false) {
    press_event = {PointerEvent::Kind::press, button, pixel, shift, control, false};
    tool = tool_for(editor, press_event);
    ToolContext now = context();
    tool->begin(now, press_event);
  }
  /// Moves or releases; hands over to the successor like the viewport.
  ToolState send(PointerEvent::Kind kind, const Vector2& pixel) {
    PointerEvent event = press_event;
    event.kind = kind;
    event.pixel = pixel;
    ToolContext now = context();
    ToolState state = tool->update(now, event);
    if (state == ToolState::stay) return state;
    tool = state == ToolState::commit ? tool->successor() : nullptr;
    if (tool) {
      tool->begin(now, press_event);
      state = tool->update(now, event);
    }
    scene.update(editor);
    return state;
  }
  void click(const Vector2& pixel, bool shift = false, bool control = false) {
    press(pixel, PointerButton::left, shift, control);
    send(PointerEvent::Kind::release, pixel);
  }
  const ElementSelection& selected() { return editor.selection.of_active(); }
};

constexpr VertexId near_vertex{5};  // (1, -1, 1), in front in the three-quarter view
constexpr VertexId top_vertex{6};

TEST(SelectTool, ClicksChooseAddAndRemove) {
  EditorRig rig;
  rig.click(rig.pixel_of(near_vertex));
  EXPECT_EQ(rig.selected().vertices, std::set<VertexId>{near_vertex});
  rig.click(rig.pixel_of(top_vertex) + Vector2(2, 1), true);
  EXPECT_EQ(rig.selected().vertices, (std::set<VertexId>{near_vertex, top_vertex}));
  rig.click(rig.pixel_of(near_vertex), false, true);
  EXPECT_EQ(rig.selected().vertices, std::set<VertexId>{top_vertex});
  rig.click({3, 3}, true);
  EXPECT_EQ(rig.selected().vertices, std::set<VertexId>{top_vertex})
      << "Shift keeps the selection on an empty click";
  rig.click({3, 3});
  EXPECT_TRUE(rig.selected().empty());
  EXPECT_FALSE(rig.editor.history.can_undo());
}

TEST(SelectTool, ModeDecidesWhatAClickTakes) {
  EditorRig rig;
  const Vector2 middle = (rig.pixel_of(near_vertex) + rig.pixel_of(top_vertex)) / 2;
  rig.editor.mode = ElementMode::edge;
  rig.click(middle);
  EXPECT_EQ(rig.selected().edges, std::set<EdgeId>{EdgeId::of(near_vertex, top_vertex)});
  rig.editor.mode = ElementMode::face;
  rig.click((rig.pixel_of(near_vertex) + rig.pixel_of(VertexId{7})) / 2);
  EXPECT_EQ(rig.selected().faces, std::set<FaceId>{FaceId{1}});
  EXPECT_TRUE(rig.selected().edges.empty());
}

TEST(MoveTool, DragsTheGrabbedVertexUnderThePointerInOneStep) {
  EditorRig rig;
  const Vector2 from = rig.pixel_of(near_vertex), to = from + Vector2(60, -35);
  rig.press(from);
  EXPECT_EQ(rig.send(PointerEvent::Kind::move, from + Vector2(2, 1)), ToolState::stay);
  EXPECT_FALSE(rig.editor.history.in_gesture()) << "a drag begins after three pixels";
  rig.send(PointerEvent::Kind::move, from + Vector2(20, 0));
  EXPECT_TRUE(rig.editor.history.in_gesture());
  EXPECT_FALSE(rig.editor.history.can_undo());
  rig.send(PointerEvent::Kind::move, to);
  EXPECT_LT((rig.pixel_of(near_vertex) - to).norm(), 1e-6);
  rig.send(PointerEvent::Kind::release, to);
  EXPECT_FALSE(rig.editor.history.in_gesture());
  EXPECT_EQ(rig.editor.history.position(), 1U);
  EXPECT_EQ(rig.editor.history.undo_label(), "Move vertex");
  EXPECT_LT((rig.pixel_of(near_vertex) - to).norm(), 1e-6);
  const Document moved = rig.editor.document();
  rig.editor.undo();
  EXPECT_EQ(rig.editor.document(), cube_document());
  rig.editor.redo();
  EXPECT_EQ(rig.editor.document(), moved);
}

TEST(MoveTool, MovesAllThatIsSelectedByTheSameAmount) {
  EditorRig rig;
  rig.click(rig.pixel_of(near_vertex));
  rig.click(rig.pixel_of(top_vertex), true);
  const Vector2 from = rig.pixel_of(near_vertex);
  rig.press(from);
  rig.send(PointerEvent::Kind::move, from + Vector2(30, 10));
  rig.send(PointerEvent::Kind::release, from + Vector2(30, 10));
  EXPECT_EQ(rig.editor.history.undo_label(), "Move 2 vertices");
  const Polyhedron& after = rig.editor.document().objects[0]->polyhedron()->polyhedron;
  const Document before_document = cube_document();
  const Polyhedron& before = before_document.objects[0]->polyhedron()->polyhedron;
  const Vector3 a = after.position(5) - before.position(5), b = after.position(6) - before.position(6);
  EXPECT_GT(a.norm(), 0.01);
  EXPECT_LT((a - b).norm(), 1e-12);
  EXPECT_EQ(after.position(0), before.position(0));
}

TEST(MoveTool, CancelRestoresExactly) {
  EditorRig rig;
  const Document before = rig.editor.document();
  const Vector2 from = rig.pixel_of(near_vertex);
  rig.press(from);
  rig.send(PointerEvent::Kind::move, from + Vector2(50, 50));
  EXPECT_FALSE(rig.editor.document() == before);
  ToolContext context = rig.context();
  rig.tool->cancel(context);
  EXPECT_EQ(rig.editor.document(), before);
  EXPECT_FALSE(rig.editor.history.can_undo());
  EXPECT_FALSE(rig.editor.history.dirty());
}

TEST(MoveTool, DragThatEndsWhereItBeganIsNoStep) {
  EditorRig rig;
  const Vector2 from = rig.pixel_of(near_vertex);
  rig.press(from);
  rig.send(PointerEvent::Kind::move, from + Vector2(50, 50));
  rig.send(PointerEvent::Kind::move, from);
  rig.send(PointerEvent::Kind::release, from);
  EXPECT_FALSE(rig.editor.history.can_undo());
}

TEST(MoveTool, LockedObjectSaysSoAndStays) {
  EditorRig rig;
  rig.editor.commit(set_locked(rig.editor.history.current(), rig.editor.document().objects[0]->id, true),
                    "Lock");
  rig.scene.update(rig.editor);
  const Document before = rig.editor.document();
  const Vector2 from = rig.pixel_of(near_vertex);
  rig.press(from);
  EXPECT_EQ(rig.send(PointerEvent::Kind::move, from + Vector2(50, 50)), ToolState::cancel);
  EXPECT_EQ(rig.editor.document(), before);
  EXPECT_EQ(rig.editor.notices().size(), 1U);
}

TEST(ViewTools, TurnTheCameraAndGoBackOnCancel) {
  EditorRig rig;
  const Camera before = rig.editor.camera();
  rig.press({400, 300}, PointerButton::middle);
  rig.send(PointerEvent::Kind::move, {460, 330});
  EXPECT_GT(rig.editor.camera().orientation.angularDistance(before.orientation), 0.1);
  ToolContext context = rig.context();
  rig.tool->cancel(context);
  EXPECT_EQ(rig.editor.camera().orientation.coeffs(), before.orientation.coeffs());
  rig.press({400, 300}, PointerButton::middle, true);
  rig.send(PointerEvent::Kind::release, {460, 330});
  EXPECT_EQ(rig.editor.camera().orientation.coeffs(), before.orientation.coeffs());
  EXPECT_GT((rig.editor.camera().target - before.target).norm(), 0.01);
  EXPECT_FALSE(rig.editor.history.can_undo()) << "the camera is not part of the document";
}

TEST(ViewTools, WheelKeepsThePointUnderThePointer) {
  EditorRig rig;
  const Vector2 pixel(250, 180);
  const auto under = [&] {
    return Projector(rig.editor.camera(), rig.editor.viewport)
        .on_facing_plane(pixel, rig.editor.camera().target);
  };
  const Vector3 before = under();
  const double distance = rig.editor.camera().distance;
  ToolContext context = rig.context();
  turn_wheel(context, {{0, 3}, pixel}, true);
  EXPECT_LT(rig.editor.camera().distance, distance);
  EXPECT_LT((Projector(rig.editor.camera(), rig.editor.viewport).project(before)->head<2>() - pixel).norm(),
            1e-6);
}

TEST(Selection, SurvivesUndoAndDropsWhatIsGone) {
  EditorRig rig;
  rig.click(rig.pixel_of(near_vertex));
  const ObjectId id = rig.editor.selection.active;
  rig.editor.commit(delete_objects(rig.editor.history.current(), {&id, 1}), "Delete object");
  EXPECT_TRUE(rig.editor.selection.no_elements());
  EXPECT_EQ(rig.editor.active_object(), nullptr);
  rig.editor.undo();
  ASSERT_NE(rig.editor.active_object(), nullptr);
  EXPECT_EQ(rig.editor.active_object()->id, id);
}

TEST(Selection, TouchedVerticesOfEdgesAndFaces) {
  const Document document = cube_document();
  const Polyhedron& polyhedron = document.objects[0]->polyhedron()->polyhedron;
  ElementSelection selection;
  selection.edges.insert(EdgeId::of({1}, {0}));
  selection.faces.insert(FaceId{1});
  EXPECT_EQ(touched_vertices(selection, polyhedron), (std::vector<VertexId>{{0}, {1}, {4}, {5}, {6}, {7}}));
  EXPECT_EQ(describe(selection), "1 edge, 1 face");
}

TEST(SceneBuilder, VersionRisesOnlyWhenThePictureChanges) {
  EditorRig rig;
  const auto version = rig.scene.version();
  rig.scene.update(rig.editor);
  EXPECT_EQ(rig.scene.version(), version);
  rig.editor.hovered = ElementRef{rig.editor.selection.active, element_of(near_vertex)};
  rig.scene.update(rig.editor);
  EXPECT_GT(rig.scene.version(), version);
  const auto polyhedron = rig.scene.scene().objects[0].polyhedron;
  rig.editor.commit(rename_object(rig.editor.history.current(), rig.editor.selection.active, "other"),
                    "Rename");
  rig.scene.update(rig.editor);
  EXPECT_EQ(rig.scene.scene().objects[0].polyhedron, polyhedron) << "renaming makes no new lines";
}

}  // namespace
}  // namespace hariko

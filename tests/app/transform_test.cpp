// Transform, selection and tension tools, driven as the viewport drives them, without a window.

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/document/edits.hpp"
#include "tests/support/random.hpp"
#include "ui/tools/gizmo.hpp"
#include "ui/tools/navigation.hpp"
#include "ui/tools/region_tool.hpp"
#include "ui/tools/tension_tool.hpp"
#include "ui/tools/transform_tool.hpp"

namespace hariko {
namespace {

Document cube_document() {
  PolygonMesh mesh;
  mesh.positions = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  mesh.add_face({0, 3, 2, 1});
  mesh.add_face({4, 5, 6, 7});
  mesh.add_face({0, 1, 5, 4});
  mesh.add_face({1, 2, 6, 5});
  mesh.add_face({2, 3, 7, 6});
  mesh.add_face({3, 0, 4, 7});
  return document_from_mesh(mesh, "cube").value();
}

/// n x n squares of side 1 in the plane z = 0.
Document grid_document(int n) {
  PolygonMesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) mesh.positions.emplace_back(x, y, 0);
  const auto at = [n](int x, int y) { return static_cast<Index>(y * (n + 1) + x); };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) mesh.add_face({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
  return document_from_mesh(mesh, "grid").value();
}

struct Rig {
  Editor editor;
  SceneBuilder scene;
  std::unique_ptr<Tool> tool;
  PointerEvent at;

  explicit Rig(Document document = cube_document()) {
    editor.viewport = {800, 600};
    editor.open(std::move(document), {});
    editor.frame_all(true);
    scene.update(editor);
  }
  ToolContext context() { return {editor, scene}; }
  const PolyhedronSource& source(std::size_t object = 0) const {
    return *editor.document().objects[object]->polyhedron();
  }
  Vector3 place(VertexId id, std::size_t object = 0) const {
    const PolyhedronSource& s = source(object);
    return editor.document().objects[object]->transform.apply(s.origin +
                                                              s.polyhedron.position(s.polyhedron.find(id)));
  }
  Vector2 pixel(const Vector3& world) const {
    return Projector(editor.camera(), editor.viewport).project(world)->head<2>();
  }
  void choose(std::initializer_list<unsigned> vertices) {
    editor.mode = ElementMode::vertex;
    editor.selection.clear_elements();
    for (const unsigned v : vertices)
      editor.selection.select({editor.document().objects[0]->id, element_of(VertexId{v})},
                              Selection::How::add);
    scene.update(editor);
  }
  void start(std::unique_ptr<Tool> next, const Vector2& pixel = {400, 300}) {
    at = {};
    at.pixel = pixel;
    tool = std::move(next);
    ToolContext now = context();
    tool->begin(now, at);
  }
  void handle(ToolState state) {
    if (state == ToolState::stay) return;
    const std::unique_ptr<Tool> done = std::move(tool);
    if (auto next = state == ToolState::commit ? done->successor() : nullptr) {
      tool = std::move(next);
      ToolContext now = context();
      tool->begin(now, at);
      handle(tool->update(now, at));
    }
    scene.update(editor);
  }
  void send(PointerEvent::Kind kind, const Vector2& pixel, bool shift = false, bool control = false) {
    ASSERT_NE(tool, nullptr);
    PointerEvent event;
    event.kind = kind;
    event.pixel = pixel;
    event.shift = shift;
    event.control = control;
    at.pixel = at.pixel;
    ToolContext now = context();
    handle(tool->update(now, event));
  }
  void move(const Vector2& pixel, bool shift = false, bool control = false) {
    send(PointerEvent::Kind::move, pixel, shift, control);
  }
  void key(int code, bool shift = false, char32_t text = 0) {
    ASSERT_NE(tool, nullptr);
    ToolContext now = context();
    const auto state = tool->key(now, {{code, false, shift, false}, text});
    if (state) handle(*state);
  }
  void type(std::string_view text) {
    for (const char c : text) {
      const int code = c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c;
      key(code, false, static_cast<char32_t>(c));
    }
  }
  void enter() { key(GLFW_KEY_ENTER); }
  void escape() {
    ToolContext now = context();
    tool->cancel(now);
    tool.reset();
    scene.update(editor);
  }
};

TEST(TransformTool, TypedMovesAreExact) {
  Rig rig;
  const Document before = rig.editor.document();
  rig.choose({5, 6});
  const Selection chosen = rig.editor.selection;
  rig.start(make_transform_tool(TransformKind::move));
  rig.key(GLFW_KEY_X);
  rig.type("10");
  EXPECT_EQ(rig.place({5}), Vector3(11, -1, 1)) << "shown while typing";
  EXPECT_FALSE(rig.editor.history.can_undo());
  rig.enter();
  EXPECT_EQ(rig.tool, nullptr);
  EXPECT_EQ(rig.place({5}), Vector3(11, -1, 1));
  EXPECT_EQ(rig.place({6}), Vector3(11, 1, 1));
  EXPECT_EQ(rig.place({0}), Vector3(-1, -1, -1));
  EXPECT_EQ(rig.editor.history.position(), 1U);
  EXPECT_EQ(rig.editor.history.undo_label(), "Move 2 vertices");
  const Document after = rig.editor.document();
  rig.editor.selection.clear_elements();
  rig.editor.undo();
  EXPECT_EQ(rig.editor.document(), before);
  EXPECT_EQ(rig.editor.selection, chosen) << "undo brings back the selection";
  rig.editor.redo();
  EXPECT_EQ(rig.editor.document(), after);
}

TEST(TransformTool, UnitsExpressionsAndFields) {
  Rig rig;
  rig.choose({0});
  rig.start(make_transform_tool(TransformKind::move));
  rig.type("1cm+2");
  rig.key(GLFW_KEY_TAB);
  rig.type("-1/2");
  rig.key(GLFW_KEY_TAB);
  rig.type("37");
  rig.key(GLFW_KEY_BACKSPACE);
  rig.enter();
  EXPECT_EQ(rig.place({0}), Vector3(11, -1.5, 2));
  rig.choose({0});
  rig.start(make_transform_tool(TransformKind::move));
  rig.key(GLFW_KEY_Z, true);  // the plane across z
  rig.type("1");
  rig.key(GLFW_KEY_TAB);
  rig.type("2");
  rig.enter();
  EXPECT_EQ(rig.place({0}), Vector3(12, 0.5, 2));
  rig.start(make_transform_tool(TransformKind::move));
  rig.key(GLFW_KEY_Z);
  rig.type("3+");
  rig.enter();
  ASSERT_NE(rig.tool, nullptr) << "half an expression is not taken for a number";
  rig.type("1");
  rig.key(GLFW_KEY_Y, false, U'y');  // the axis may be chosen after the number
  rig.enter();
  EXPECT_EQ(rig.place({0}), Vector3(12, 4.5, 2));
}

TEST(TransformTool, QuarterTurnsAndScalesAreExact) {
  Rig rig;
  rig.choose({4, 5, 6, 7});  // the top, round (0, 0, 1)
  rig.start(make_transform_tool(TransformKind::rotate));
  rig.key(GLFW_KEY_Z);
  rig.type("90");
  rig.enter();
  EXPECT_EQ(rig.place({5}), Vector3(1, 1, 1));
  EXPECT_EQ(rig.editor.history.undo_label(), "Rotate 4 vertices");
  rig.start(make_transform_tool(TransformKind::scale));
  rig.type("2");
  rig.enter();
  EXPECT_EQ(rig.place({5}), Vector3(2, 2, 1));
  rig.start(make_transform_tool(TransformKind::scale));
  rig.key(GLFW_KEY_X);
  rig.type(".5");
  rig.enter();
  EXPECT_EQ(rig.place({5}), Vector3(1, 2, 1));
  rig.start(make_transform_tool(TransformKind::scale));
  rig.key(GLFW_KEY_X, true);  // all but x
  rig.type("3");
  rig.enter();
  EXPECT_EQ(rig.place({5}), Vector3(1, 6, 1));
}

/// Whatever the pointer does: a locked axis moves along itself, a locked plane within itself, and Esc
/// restores.
TEST(TransformTool, LocksAreExactAndEscRestores) {
  test::for_random(7, 40, [](std::mt19937_64& rng) {
    Rig rig;
    const Document before = rig.editor.document();
    rig.editor.set_camera(rig.editor.camera().orbit(test::uniform(rng, -3, 3), test::uniform(rng, -1, 1)));
    rig.choose({6, 7});
    const Selection chosen = rig.editor.selection;
    const int axis = test::uniform_int(rng, 0, 2);
    const bool plane = test::chance(rng, 0.5);
    rig.start(make_transform_tool(TransformKind::move));
    rig.move({test::uniform(rng, 0, 800), test::uniform(rng, 0, 600)});
    rig.key(GLFW_KEY_X + axis, plane);
    for (int i = 0; i < 5; ++i) {
      rig.move({test::uniform(rng, 0, 800), test::uniform(rng, 0, 600)}, test::chance(rng, 0.3),
               test::chance(rng, 0.3));
      if (test::chance(rng, 0.3))
        rig.editor.set_camera(
            rig.editor.camera().orbit(test::uniform(rng, -1, 1), test::uniform(rng, -0.3, 0.3)));
      const Vector3 moved = rig.place({6}) - Vector3(1, 1, 1);
      for (int k = 0; k < 3; ++k) {
        if ((k == axis) == plane) {
          EXPECT_EQ(moved[k], 0) << "axis " << k << (plane ? ", plane " : ", axis ") << axis;
        }
      }
    }
    rig.escape();
    EXPECT_EQ(rig.editor.document(), before);
    EXPECT_EQ(rig.editor.selection, chosen);
    EXPECT_FALSE(rig.editor.history.can_undo());
  });
}

TEST(TransformTool, ThirdPressOfAnAxisFreesAndSecondIsLocal) {
  Rig rig;
  Similarity turned;
  turned.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Vector3::UnitZ()));
  rig.editor.commit(set_transform(rig.editor.document(), rig.editor.document().objects[0]->id, turned),
                    "Turn");
  rig.choose({6});
  const Vector3 before = rig.place({6});
  rig.start(make_transform_tool(TransformKind::move));
  rig.key(GLFW_KEY_X);
  rig.key(GLFW_KEY_X);
  rig.type("3");
  EXPECT_LT((rig.place({6}) - before - Vector3(0, 3, 0)).norm(), 1e-12) << "the object's x is the world's y";
  rig.key(GLFW_KEY_X);
  EXPECT_LT((rig.place({6}) - before - Vector3(3, 0, 0)).norm(), 1e-12);
  rig.escape();
}

TEST(TransformTool, FineIsATenth) {
  Rig rig;
  rig.choose({6});
  const Vector3 before = rig.place({6});
  rig.start(make_transform_tool(TransformKind::move));
  rig.move({450, 300});
  const Vector3 whole = rig.place({6}) - before;
  rig.escape();
  rig.start(make_transform_tool(TransformKind::move));
  rig.move({450, 300}, true);
  EXPECT_LT((rig.place({6}) - before - whole / 10).norm(), 1e-9);
  rig.escape();
}

TEST(TransformTool, SnapsOntoVerticesMidpointsAndTheGrid) {
  Rig rig;
  rig.editor.view.x_ray = true;
  rig.choose({6});
  rig.start(make_transform_tool(TransformKind::move), rig.pixel({1, 1, 1}));
  rig.move(rig.pixel({1, -1, 1}) + Vector2(3, 2), false, true);
  EXPECT_LT((rig.place({6}) - Vector3(1, -1, 1)).norm(), 1e-12);
  // The middle of the edge from 4 to 5, which do not move.
  rig.move(rig.pixel({0, -1, 1}) + Vector2(-2, 1), false, true);
  EXPECT_LT((rig.place({6}) - Vector3(0, -1, 1)).norm(), 1e-12);
  // Locked to an axis it goes as far as the target does.
  rig.key(GLFW_KEY_Y);
  rig.move(rig.pixel({1, -1, -1}), false, true);
  EXPECT_EQ(rig.place({6}), Vector3(1, -1, 1));
  rig.key(GLFW_KEY_Y);
  rig.key(GLFW_KEY_Y);
  rig.move(rig.pixel({2.31, 2.02, 0.9}), false, true);
  const DecimalStep step = grid_step(rig.context().projector(), {1, 1, 1});
  for (const double x : rig.place({6})) EXPECT_NEAR(x, step.nearest(x), 1e-12);
  rig.escape();
  rig.choose({4, 5, 6, 7});
  rig.start(make_transform_tool(TransformKind::rotate), {500, 300});
  rig.key(GLFW_KEY_Z);
  rig.move({490, 340}, false, true);
  const double degrees = std::atan2(rig.place({6}).y(), rig.place({6}).x()) * 180 / M_PI - 45;
  EXPECT_NEAR(degrees, std::round(degrees / 15) * 15, 1e-9);
  EXPECT_GT(std::abs(degrees), 1);
  rig.escape();
}

TEST(TransformTool, PivotsAreWhatTheySay) {
  Rig rig(grid_document(3));
  rig.editor.mode = ElementMode::face;
  const ObjectId id = rig.editor.document().objects[0]->id;
  const auto double_size = [&](PivotMode mode) {
    rig.editor.transform.pivot = mode;
    rig.start(make_transform_tool(TransformKind::scale));
    rig.type("2");
    rig.enter();
    const Vector3 first = rig.place({0}), last = rig.place({15});
    rig.editor.undo();
    rig.scene.update(rig.editor);
    return std::pair(first, last);
  };
  rig.editor.selection.select({id, element_of(FaceId{0})}, Selection::How::add);
  rig.editor.selection.select({id, element_of(FaceId{8})}, Selection::How::add);
  EXPECT_EQ(double_size(PivotMode::median).first, Vector3(-1.5, -1.5, 0));
  EXPECT_EQ(double_size(PivotMode::box_centre).second, Vector3(4.5, 4.5, 0));
  EXPECT_EQ(double_size(PivotMode::individual).first, Vector3(-0.5, -0.5, 0));
  EXPECT_EQ(double_size(PivotMode::individual).second, Vector3(3.5, 3.5, 0));
  EXPECT_EQ(double_size(PivotMode::active).second, Vector3(3.5, 3.5, 0));
  EXPECT_EQ(double_size(PivotMode::active).first, Vector3(-2.5, -2.5, 0));
}

TEST(TransformTool, SoftSelectionFallsOffWithTheDistance) {
  Rig rig(grid_document(8));
  rig.choose({40});  // the middle, (4, 4)
  rig.editor.transform.soft = {true, 3, Falloff::linear};
  rig.start(make_transform_tool(TransformKind::move));
  rig.key(GLFW_KEY_Z);
  rig.type("3");
  EXPECT_EQ(rig.place({40}).z(), 3);
  EXPECT_NEAR(rig.place({41}).z(), 2, 1e-12);
  EXPECT_NEAR(rig.place({42}).z(), 1, 1e-12);
  EXPECT_EQ(rig.place({43}).z(), 0);
  EXPECT_EQ(rig.place({41}).x(), 5);
  ToolContext now = rig.context();
  EXPECT_TRUE(rig.tool->wheel(now, -100, {})) << "the wheel changes the radius";
  EXPECT_EQ(rig.place({41}).z(), 0) << "what does not follow any more goes back";
  rig.key(GLFW_KEY_O);
  EXPECT_FALSE(rig.editor.transform.soft.on);
  rig.enter();
  EXPECT_EQ(rig.place({40}).z(), 3);
}

TEST(TransformTool, WholeObjectsKeepTheirShapeUnlessStretched) {
  Rig rig;
  const ObjectId id = rig.editor.document().objects[0]->id;
  rig.editor.mode = ElementMode::object;
  rig.editor.selection.select({id, element_of(id)}, Selection::How::replace);
  const PolyhedronSource before = rig.source();
  rig.start(make_transform_tool(TransformKind::rotate));
  rig.key(GLFW_KEY_Z);
  rig.type("30");
  rig.enter();
  EXPECT_EQ(rig.editor.history.undo_label(), "Rotate object");
  rig.start(make_transform_tool(TransformKind::move));
  rig.key(GLFW_KEY_X);
  rig.type("5");
  rig.enter();
  rig.start(make_transform_tool(TransformKind::scale));
  rig.type("2");
  rig.enter();
  EXPECT_EQ(rig.source(), before) << "similarities are the object's place";
  EXPECT_NEAR(rig.editor.document().objects[0]->transform.scale, 2, 1e-15);
  const Vector3 centre(5, 0, 0);
  const Vector3 corner = rig.place({6});
  EXPECT_NEAR((corner - centre).norm(), 2 * std::sqrt(3.0), 1e-12);
  rig.start(make_transform_tool(TransformKind::scale));
  rig.key(GLFW_KEY_X);
  rig.type("-2");
  rig.enter();
  EXPECT_LT((rig.place({6}) - Vector3(5 - 2 * (corner.x() - 5), corner.y(), corner.z())).norm(), 1e-9);
  // Mirrored, it is turned outside out: its volume stays positive.
  double volume = 0;
  const Polyhedron& polyhedron = rig.source().polyhedron;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const auto corners = polyhedron.topology().face_vertices(f);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      volume += polyhedron.position(corners[0])
                    .dot(polyhedron.position(corners[i]).cross(polyhedron.position(corners[i + 1]))) /
                6;
  }
  EXPECT_NEAR(volume, 16, 1e-9);
}

TEST(TransformTool, SeveralObjectsInOneStep) {
  Rig rig;
  const auto added = duplicate_object(rig.editor.document(), rig.editor.document().objects[0]->id);
  rig.editor.commit(added->document, "Duplicate object");
  rig.editor.mode = ElementMode::object;
  for (const auto& object : rig.editor.document().objects)
    rig.editor.selection.select({object->id, element_of(object->id)}, Selection::How::add);
  rig.scene.update(rig.editor);
  rig.start(make_transform_tool(TransformKind::move));
  rig.type("4");
  rig.enter();
  EXPECT_EQ(rig.editor.history.undo_label(), "Move 2 objects");
  EXPECT_EQ(rig.place({6}, 0), Vector3(5, 1, 1));
  EXPECT_EQ(rig.place({6}, 1), Vector3(5, 1, 1));
  EXPECT_EQ(rig.editor.history.position(), 2U);
}

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

TEST(RegionTool, WindowTakesWhatLiesInsideAndCrossingWhatItTouches) {
  Rig rig(grid_document(4));
  Camera top = Camera::standard(StandardView::top);
  top.target = {2, 2, 0};
  top.distance = 20;
  top.orthographic = true;
  rig.editor.set_camera(top);
  rig.editor.mode = ElementMode::face;
  rig.scene.update(rig.editor);
  // Round the middle four faces and a bit of their neighbours.
  const Vector2 a = rig.pixel({0.5, 3.5, 0}), b = rig.pixel({3.5, 0.5, 0});
  const auto box = [&](const Vector2& from, const Vector2& to) {
    rig.start(make_region_tool(false), from);
    rig.move(to);
    rig.send(PointerEvent::Kind::release, to);
    return rig.editor.selection.of_active().faces.size();
  };
  EXPECT_EQ(box(a, b), 4U) << "left to right";
  EXPECT_EQ(box(b, a), 16U) << "right to left";
  rig.editor.mode = ElementMode::vertex;
  EXPECT_EQ((box(a, b), rig.editor.selection.of_active().vertices.size()), 9U);
  EXPECT_FALSE(rig.editor.history.can_undo());
}

TEST(RegionTool, HiddenElementsNeedSelectThrough) {
  Rig rig;
  rig.editor.mode = ElementMode::vertex;
  const auto all = [&] {
    rig.start(make_region_tool(false), {1, 1});
    rig.move({799, 599});
    rig.send(PointerEvent::Kind::release, {799, 599});
    return rig.editor.selection.of_active().vertices.size();
  };
  EXPECT_EQ(all(), 7U) << "one corner of a cube is behind";
  rig.editor.selecting.through = true;
  EXPECT_EQ(all(), 8U);
  rig.editor.mode = ElementMode::face;
  rig.editor.selecting.through = false;
  all();
  EXPECT_EQ(rig.editor.selection.of_active().faces.size(), 3U);
}

TEST(RegionTool, LassoTakesWhatItEnclosesAndEscRestores) {
  Rig rig(grid_document(4));
  Camera top = Camera::standard(StandardView::top);
  top.target = {2, 2, 0};
  top.distance = 20;
  rig.editor.set_camera(top);
  rig.editor.mode = ElementMode::vertex;
  rig.editor.selecting.lasso = true;
  rig.scene.update(rig.editor);
  rig.start(make_region_tool(false), rig.pixel({-0.5, -0.5, 0}));
  rig.move(rig.pixel({4.8, -0.5, 0}));
  rig.move(rig.pixel({-0.5, 4.8, 0}));
  EXPECT_EQ(rig.editor.selection.of_active().vertices.size(), 15U) << "the triangle below the diagonal";
  rig.escape();
  EXPECT_TRUE(rig.editor.selection.no_elements());
}

TEST(SelectTool, DoubleClickTakesTheLoopAndRepeatedClicksWhatLiesBehind) {
  Rig rig(grid_document(4));
  Camera top = Camera::standard(StandardView::top);
  top.target = {2, 2, 0};
  top.distance = 20;
  rig.editor.set_camera(top);
  rig.editor.mode = ElementMode::edge;
  rig.scene.update(rig.editor);
  const auto click = [&](const Vector2& pixel, int clicks) {
    PointerEvent press;
    press.kind = PointerEvent::Kind::press;
    press.pixel = pixel;
    press.clicks = clicks;
    rig.tool = make_select_tool();
    ToolContext now = rig.context();
    rig.tool->begin(now, press);
    rig.send(PointerEvent::Kind::release, pixel);
  };
  click(rig.pixel({1.5, 2, 0}), 1);
  EXPECT_EQ(rig.editor.selection.of_active().edges.size(), 1U);
  click(rig.pixel({1.5, 2, 0}), 2);
  EXPECT_EQ(rig.editor.selection.of_active().edges.size(), 4U) << "from border to border";
  // A cube from the front with x-ray: behind each vertex there is another one.
  Rig cube;
  Camera front = Camera::standard(StandardView::front);
  front.orthographic = true;
  cube.editor.set_camera(front);
  cube.editor.view.x_ray = true;
  cube.scene.update(cube.editor);
  const auto click_cube = [&] {
    PointerEvent press;
    press.kind = PointerEvent::Kind::press;
    press.pixel = cube.pixel({1, -1, 1});
    cube.tool = make_select_tool();
    ToolContext now = cube.context();
    cube.tool->begin(now, press);
    cube.send(PointerEvent::Kind::release, press.pixel);
    return *cube.editor.selection.of_active().vertices.begin();
  };
  EXPECT_EQ(click_cube(), VertexId{5});
  EXPECT_EQ(click_cube(), VertexId{6});
  EXPECT_EQ(click_cube(), VertexId{5});
}

TEST(Selection, ConvertsBetweenModes) {
  const Document document = cube_document();
  const ObjectId id = document.objects[0]->id;
  Selection selection;
  selection.select({id, element_of(FaceId{1})}, Selection::How::replace);
  const Selection corners = converted(selection, document, ElementMode::face, ElementMode::vertex);
  EXPECT_EQ(corners.of(id).vertices, (std::set<VertexId>{{4}, {5}, {6}, {7}}));
  EXPECT_TRUE(corners.of(id).faces.empty());
  EXPECT_EQ(converted(corners, document, ElementMode::vertex, ElementMode::face).of(id).faces,
            std::set<FaceId>{FaceId{1}});
  EXPECT_EQ(converted(corners, document, ElementMode::vertex, ElementMode::edge).of(id).edges.size(), 4U);
  const Selection object = converted(selection, document, ElementMode::face, ElementMode::object);
  EXPECT_EQ(object.objects(), std::set<ObjectId>{id});
  EXPECT_EQ(converted(object, document, ElementMode::object, ElementMode::vertex).of(id).vertices.size(), 8U);
}

TEST(SelectionMemory, KeepsWhatBelongsToStepsAndForgetsTheRest) {
  SelectionMemory memory(20);
  const auto chosen = [](unsigned first, unsigned count) {
    ChosenElements result;
    ElementSelection elements;
    for (unsigned i = 0; i < count; ++i) elements.vertices.insert(VertexId{first + i});
    result.selection.select(ObjectId{1}, elements, Selection::How::add);
    return result;
  };
  memory.step(0, chosen(0, 1), 0);
  memory.step(1, chosen(1, 1), 0);
  memory.leave(2, chosen(2, 1));
  memory.leave(2, chosen(9, 1));
  EXPECT_EQ(*memory.find(2), chosen(2, 1)) << "what a state was left with first stays";
  memory.step(1, chosen(3, 1), 0);
  EXPECT_EQ(memory.find(2), nullptr) << "what could be redone is gone";
  EXPECT_EQ(*memory.find(1), chosen(3, 1));
  memory.step(5, chosen(4, 12), 1);
  EXPECT_EQ(memory.find(0), nullptr) << "states that the history forgot are forgotten";
  memory.step(6, chosen(5, 12), 1);
  EXPECT_EQ(memory.find(5), nullptr) << "the limit";
  EXPECT_NE(memory.find(6), nullptr);
}

TEST(TensionTool, DragsInProportionAndTypesAbsolutely) {
  Rig rig;
  const ObjectId id = rig.editor.document().objects[0]->id;
  const EdgeId first = EdgeId::of({4}, {5}), second = EdgeId::of({5}, {6});
  rig.editor.commit(set_beta(rig.editor.document(), id, {&first, 1}, 4), "Tension");
  const Document before = rig.editor.document();
  rig.editor.mode = ElementMode::edge;
  rig.editor.selection.select({id, element_of(first)}, Selection::How::add);
  rig.editor.selection.select({id, element_of(second)}, Selection::How::add);
  const auto beta = [&](EdgeId edge) { return rig.source().shaping->beta.get_or(edge, 1); };
  rig.start(std::make_unique<TensionTool>(), {300, 300});
  rig.move({300 + TensionTool::doubling_pixels, 320});
  EXPECT_DOUBLE_EQ(beta(first), 8);
  EXPECT_DOUBLE_EQ(beta(second), 2);
  rig.escape();
  EXPECT_EQ(rig.editor.document(), before);
  rig.start(std::make_unique<TensionTool>(), {300, 300});
  rig.move({300 + TensionTool::doubling_pixels, 320}, true);
  EXPECT_NEAR(beta(second), std::exp2(0.1), 0.01) << "Shift is fine";
  rig.type("25");
  EXPECT_EQ(beta(first), 25);
  EXPECT_EQ(beta(second), 25);
  rig.enter();
  EXPECT_EQ(rig.tool, nullptr);
  EXPECT_EQ(rig.editor.history.undo_label(), "Tension of edges");
  rig.editor.undo();
  EXPECT_EQ(rig.editor.document(), before);
  rig.choose({5});
  rig.start(std::make_unique<TensionTool>(), {300, 300});
  rig.type("5000");
  rig.enter();
  ASSERT_NE(rig.tool, nullptr) << "out of range: nothing happens but an explanation";
  rig.escape();
  EXPECT_EQ(rig.editor.document(), before);
}

TEST(NumericInput, TakesNumbersAndLeavesKeys) {
  NumericInput input;
  const auto press = [&](int key, char32_t text) { return input.key({{key, false, false, false}, text}); };
  EXPECT_FALSE(press('X', U'x')) << "an axis";
  EXPECT_FALSE(press('P', U'p')) << "letters begin no number";
  EXPECT_FALSE(press(GLFW_KEY_BACKSPACE, 0));
  EXPECT_FALSE(input.active());
  EXPECT_TRUE(press('2', U'2'));
  EXPECT_FALSE(press('X', U'x'));
  EXPECT_TRUE(press('8', U'*')) << "by the character, not by the key";
  EXPECT_FALSE(input.value().has_value());
  EXPECT_TRUE(input.error().has_value());
  for (const char c : std::string("max(1,3)")) EXPECT_TRUE(press(0, static_cast<char32_t>(c))) << c;
  EXPECT_EQ(input.value(), 6);
  EXPECT_TRUE(press(GLFW_KEY_BACKSPACE, 0));
  EXPECT_EQ(input.text(0), "2*max(1,3");
  input.clear();
  EXPECT_FALSE(input.active());
}

}  // namespace
}  // namespace hariko

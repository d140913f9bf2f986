// The knife: clicked paths over several faces, snapping, taking points back, refusals.

#include <cmath>

#include "core/modeling/objects/edit_modeling.hpp"
#include "tests/app/tool_rig.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "ui/polyhedron/cutting_tools.hpp"

namespace hariko {
namespace {

using test::grid_document;
using test::Rig;

Camera above(double x, double y) {
  Camera camera = Camera::standard(StandardView::top);
  camera.target = {x, y, 0};
  camera.distance = 20;
  camera.orthographic = true;
  return camera;
}

/// A grid of n x n squares, seen from above, with the knife in hand.
Rig grid_rig(int n) {
  Rig rig(grid_document(n));
  rig.editor.set_camera(above(n / 2.0, n / 2.0));
  rig.scene.update(rig.editor);
  rig.start(make_knife_tool());
  return rig;
}

void click(Rig& rig, const Vector2& pixel, bool control = false) {
  rig.move(pixel, false, control);
  rig.send(PointerEvent::Kind::press, pixel, false, control);
  rig.send(PointerEvent::Kind::release, pixel, false, control);
}

int euler(const Polyhedron& p) {
  return static_cast<int>(p.vertex_count()) - static_cast<int>(p.edge_count()) +
         static_cast<int>(p.face_count());
}

TEST(KnifeTool, CutsStraightOverSeveralFacesInOneStep) {
  Rig rig = grid_rig(4);
  const Document before = rig.editor.document();
  click(rig, rig.pixel({0, 0.5, 0}));
  click(rig, rig.pixel({4, 0.5, 0}));
  EXPECT_FALSE(rig.editor.history.can_undo());
  rig.enter();
  EXPECT_EQ(rig.tool, nullptr);
  const Polyhedron& cut = rig.source().polyhedron;
  EXPECT_EQ(cut.vertex_count(), 30U);
  EXPECT_EQ(cut.face_count(), 20U);
  for (Index v = 25; v < 30; ++v) EXPECT_NEAR(cut.position(v).y() + rig.source().origin.y(), 0.5, 0.02);
  EXPECT_EQ(rig.editor.history.undo_label(), "Knife");
  EXPECT_EQ(rig.editor.history.position(), 1U);
  EXPECT_FALSE(rig.editor.selection.of_active().empty());
  rig.editor.undo();
  EXPECT_EQ(rig.editor.document(), before);
}

TEST(KnifeTool, SnapsToVerticesAndWithControlToMiddles) {
  Rig rig = grid_rig(4);
  click(rig, rig.pixel({0, 0, 0}) + Vector2(4, -3));
  click(rig, rig.pixel({4, 4, 0}) + Vector2(-3, 2));
  rig.key(Key::space, false, U' ');
  EXPECT_EQ(rig.tool, nullptr);
  EXPECT_EQ(rig.source().polyhedron.vertex_count(), 25U) << "the diagonal runs through vertices";
  EXPECT_EQ(rig.source().polyhedron.face_count(), 20U);

  Rig middles = grid_rig(2);
  click(middles, middles.pixel({0.1, 0, 0}), true);
  click(middles, middles.pixel({0.9, 2, 0}), true);
  middles.enter();
  const PolyhedronSource& source = middles.source();
  ASSERT_EQ(source.polyhedron.vertex_count(), 12U);
  for (Index v = 9; v < 12; ++v) EXPECT_EQ(source.polyhedron.position(v).x() + source.origin.x(), 0.5);
}

TEST(KnifeTool, BackspaceTakesPointsBackAndEscLeavesNothing) {
  Rig rig = grid_rig(3);
  const Document before = rig.editor.document();
  click(rig, rig.pixel({0, 0, 0}));
  click(rig, rig.pixel({1, 1, 0}));
  click(rig, rig.pixel({2, 1, 0}));
  rig.key(Key::backspace);
  click(rig, rig.pixel({0, 2, 0}));
  rig.enter();
  EXPECT_EQ(rig.source().polyhedron.face_count(), 11U);
  EXPECT_EQ(rig.source().polyhedron.vertex_count(), 16U);
  rig.editor.undo();
  EXPECT_EQ(rig.editor.document(), before);
  rig.scene.update(rig.editor);
  rig.start(make_knife_tool());
  click(rig, rig.pixel({0, 0, 0}));
  click(rig, rig.pixel({3, 3, 0}));
  rig.escape();
  EXPECT_EQ(rig.editor.document(), before);
  EXPECT_FALSE(rig.editor.history.can_undo());
}

TEST(KnifeTool, APathCanBeClosed) {
  Rig rig = grid_rig(2);
  const std::array<Vector3, 4> corners{Vector3(1, 0.4, 0), {1.6, 1, 0}, {1, 1.6, 0}, {0.4, 1, 0}};
  for (const Vector3& corner : corners) click(rig, rig.pixel(corner));
  click(rig, rig.pixel(corners[0]) + Vector2(3, 3));
  rig.enter();
  EXPECT_EQ(rig.source().polyhedron.vertex_count(), 13U);
  EXPECT_EQ(rig.source().polyhedron.face_count(), 8U) << "four corners are cut off round the middle";
}

TEST(KnifeTool, RefusesWhereNoCutLeads) {
  Rig rig = grid_rig(3);
  rig.enter();
  ASSERT_NE(rig.tool, nullptr) << "nothing to cut yet";
  click(rig, rig.pixel({0.5, 0.5, 0}));  // the middle of a face
  click(rig, rig.pixel({0, 0.5, 0}));
  rig.enter();
  ASSERT_NE(rig.tool, nullptr) << "one point is no cut";
  click(rig, rig.pixel({1, 0.5, 0}));
  click(rig, rig.pixel({0.5, 1, 0}));
  click(rig, rig.pixel({0.5, 0, 0}));  // would cross the cut: the point is not taken
  rig.enter();
  EXPECT_EQ(rig.tool, nullptr);
  EXPECT_EQ(rig.source().polyhedron.face_count(), 11U);
}

/// Whatever is clicked: the result is a valid manifold of the same Euler number, or nothing changed.
TEST(KnifeTool, RandomPathsOnRandomPolyhedra) {
  int cuts = 0, several = 0;
  test::for_random(8100, 300, [&](std::mt19937_64& rng) {
    Rig rig(document_from_mesh(test::random_polyhedron(rng), "random").value());
    Camera camera = rig.editor.camera().orbit(test::uniform(rng, -3, 3), test::uniform(rng, -1, 1));
    camera.orthographic = test::chance(rng, 0.5);
    rig.editor.set_camera(camera);
    rig.editor.view.x_ray = test::chance(rng, 0.2);
    rig.scene.update(rig.editor);
    const Document before = rig.editor.document();
    const Polyhedron& polyhedron = rig.source().polyhedron;
    rig.start(make_knife_tool());
    for (int i = test::uniform_int(rng, 2, 7); i > 0; --i) {
      // Mostly where something is.
      const Index v = static_cast<Index>(rng() % polyhedron.vertex_count());
      const EdgeId edge = polyhedron.edge_id(static_cast<Index>(rng() % polyhedron.edge_count()));
      const double share = test::uniform(rng);
      const Vector3 at = test::chance(rng, 0.4)
                             ? rig.place(polyhedron.vertex_id(v))
                             : Vector3((1 - share) * rig.place(edge.low) + share * rig.place(edge.high));
      const Vector2 pixel = test::chance(rng, 0.1)
                                ? Vector2(test::uniform(rng, 0, 800), test::uniform(rng, 0, 600))
                                : rig.pixel(at);
      click(rig, pixel, test::chance(rng, 0.2));
      if (test::chance(rng, 0.1)) rig.key(Key::backspace);
    }
    rig.enter();
    if (rig.tool) {
      rig.escape();
      EXPECT_EQ(rig.editor.document(), before);
      EXPECT_FALSE(rig.editor.history.can_undo());
      return;
    }
    if (!rig.editor.history.can_undo()) {
      EXPECT_EQ(rig.editor.document(), before);
      return;
    }
    ++cuts;
    const auto* old = before.objects[0]->polyhedron();
    if (rig.source().polyhedron.face_count() > old->polyhedron.face_count() + 1) ++several;
    EXPECT_EQ(euler(rig.source().polyhedron), euler(old->polyhedron));
    EXPECT_TRUE(HalfEdgeMesh::build(rig.source().polyhedron.to_mesh()).ok());
    for (const EdgeId edge : rig.editor.selection.of_active().edges)
      EXPECT_NE(rig.source().polyhedron.find(edge), no_index);
    const Document after = rig.editor.document();
    rig.editor.undo();
    EXPECT_EQ(rig.editor.document(), before);
    rig.editor.redo();
    EXPECT_EQ(rig.editor.document(), after);
  });
  EXPECT_GT(cuts, test::repetitions(300) / 4);
  EXPECT_GT(several, test::repetitions(300) / 12);
  RecordProperty("cuts", cuts);
  std::printf("%d cuts, %d over several faces\n", cuts, several);
}

}  // namespace
}  // namespace hariko

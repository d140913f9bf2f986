// The transform tool: typed and dragged moves, turns and scales, locks, snapping, pivots, soft selection.

#include <cmath>

#include "tests/app/tool_rig.hpp"
#include "tests/support/random.hpp"
#include "ui/view/snapping.hpp"
#include "ui/view/transform_target.hpp"
#include "ui/view/transform_tool.hpp"

namespace hariko::test {
namespace {

TEST(TransformTool, TypedMovesAreExact) {
  Rig rig;
  const Document before = rig.editor.document();
  rig.choose({5, 6});
  const Selection chosen = rig.editor.selection;
  rig.start(make_transform_tool(TransformKind::move));
  rig.key(Key::x);
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

TEST(TransformTool, AttachedEndsAreTakenWhereTheyAreSeen) {
  Rig rig(grid_document(1));
  const ObjectId grid = rig.editor.document().objects[0]->id;
  const BicubicNet net = [] {
    BicubicNet out{1, 1, {}};
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) out.points.emplace_back(i / 3.0, -j / 3.0, 0);
    return out;
  }();
  const auto added =
      add_object(rig.editor.document(), "Patch", PatchSource::from_net(net).value(), Similarity{}).value();
  const EdgeId edge{VertexId{0}, VertexId{1}};
  auto document = attach_edge(added.document, grid, edge,
                              *nearest_side(added.document, *added.document.find(grid), edge));
  Similarity moved{.translation = {0, 0, 2}};
  document = test::must(set_transform(*document, added.id, moved));
  rig.editor.open(*document, {});
  rig.scene.update(rig.editor);
  rig.choose({0, 1});
  EXPECT_TRUE(TransformTarget::of(rig.editor).pivot().isApprox(Vector3(0.5, 0, 2), 1e-12));
}

TEST(TransformTool, UnitsExpressionsAndFields) {
  Rig rig;
  rig.choose({0});
  rig.start(make_transform_tool(TransformKind::move));
  rig.type("1cm+2");
  rig.key(Key::tab);
  rig.type("-1/2");
  rig.key(Key::tab);
  rig.type("37");
  rig.key(Key::backspace);
  rig.enter();
  EXPECT_EQ(rig.place({0}), Vector3(11, -1.5, 2));
  rig.choose({0});
  rig.start(make_transform_tool(TransformKind::move));
  rig.key(Key::z, true);  // the plane across z
  rig.type("1");
  rig.key(Key::tab);
  rig.type("2");
  rig.enter();
  EXPECT_EQ(rig.place({0}), Vector3(12, 0.5, 2));
  rig.start(make_transform_tool(TransformKind::move));
  rig.key(Key::z);
  rig.type("3+");
  rig.enter();
  ASSERT_NE(rig.tool, nullptr) << "half an expression is not taken for a number";
  rig.type("1");
  rig.key(Key::y, false, U'y');  // the axis may be chosen after the number
  rig.enter();
  EXPECT_EQ(rig.place({0}), Vector3(12, 4.5, 2));
}

TEST(TransformTool, QuarterTurnsAndScalesAreExact) {
  Rig rig;
  rig.choose({4, 5, 6, 7});  // the top, round (0, 0, 1)
  rig.start(make_transform_tool(TransformKind::rotate));
  rig.key(Key::z);
  rig.type("90");
  rig.enter();
  EXPECT_EQ(rig.place({5}), Vector3(1, 1, 1));
  EXPECT_EQ(rig.editor.history.undo_label(), "Rotate 4 vertices");
  rig.start(make_transform_tool(TransformKind::scale));
  rig.type("2");
  rig.enter();
  EXPECT_EQ(rig.place({5}), Vector3(2, 2, 1));
  rig.start(make_transform_tool(TransformKind::scale));
  rig.key(Key::x);
  rig.type(".5");
  rig.enter();
  EXPECT_EQ(rig.place({5}), Vector3(1, 2, 1));
  rig.start(make_transform_tool(TransformKind::scale));
  rig.key(Key::x, true);  // all but x
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
    rig.key(Key::x + axis, plane);
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
  rig.key(Key::x);
  rig.key(Key::x);
  rig.type("3");
  EXPECT_LT((rig.place({6}) - before - Vector3(0, 3, 0)).norm(), 1e-12) << "the object's x is the world's y";
  rig.key(Key::x);
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
  rig.key(Key::y);
  rig.move(rig.pixel({1, -1, -1}), false, true);
  EXPECT_EQ(rig.place({6}), Vector3(1, -1, 1));
  rig.key(Key::y);
  rig.key(Key::y);
  rig.move(rig.pixel({2.31, 2.02, 0.9}), false, true);
  const DecimalStep step = grid_step(rig.context(), {1, 1, 1});
  for (const double x : rig.place({6})) EXPECT_NEAR(x, step.nearest(x), 1e-12);
  rig.escape();
  rig.choose({4, 5, 6, 7});
  rig.start(make_transform_tool(TransformKind::rotate), {500, 300});
  rig.key(Key::z);
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
  rig.key(Key::z);
  rig.type("3");
  EXPECT_EQ(rig.place({40}).z(), 3);
  EXPECT_NEAR(rig.place({41}).z(), 2, 1e-12);
  EXPECT_NEAR(rig.place({42}).z(), 1, 1e-12);
  EXPECT_EQ(rig.place({43}).z(), 0);
  EXPECT_EQ(rig.place({41}).x(), 5);
  ToolContext now = rig.context();
  EXPECT_TRUE(rig.tool->wheel(now, -100, {})) << "the wheel changes the radius";
  EXPECT_EQ(rig.place({41}).z(), 0) << "what does not follow any more goes back";
  rig.key(Key::o);
  EXPECT_FALSE(rig.editor.transform.soft.on);
  rig.enter();
  EXPECT_EQ(rig.place({40}).z(), 3);
}

TEST(TransformTool, SoftSelectionFollowsAlongOutlines) {
  // A square loop with sides of four steps of length 1.
  OutlineLoop loop;
  for (int side = 0; side < 4; ++side)
    for (int k = 0; k < 4; ++k) {
      const Vector3 from(side == 1 || side == 2 ? 4 : 0, side >= 2 ? 4 : 0, 0);
      const Vector3 along[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
      loop.points.push_back(from + k * along[side]);
      loop.normals.push_back(Vector3::UnitZ());
    }
  Rig rig(add_object({}, "outline", OutlineSource{Outline{{loop}}, {}, {}}).value().document);
  rig.choose({2});
  rig.editor.transform.soft = {true, 3, Falloff::linear};
  rig.start(make_transform_tool(TransformKind::move));
  rig.key(Key::z);
  rig.type("3");
  rig.enter();
  const auto height = [&](std::size_t point) {
    return rig.editor.document().objects[0]->outline()->outline->loops[0].points[point].z();
  };
  EXPECT_NEAR(height(2), 3, 1e-12);
  EXPECT_NEAR(height(1), 2, 1e-12);
  EXPECT_NEAR(height(3), 2, 1e-12);
  EXPECT_NEAR(height(4), 1, 1e-12) << "by the distance along the loop";
  EXPECT_NEAR(height(0), 1, 1e-12);
  EXPECT_EQ(height(5), 0);
  EXPECT_EQ(height(10), 0);
}

TEST(TransformTool, WholeObjectsKeepTheirShapeUnlessStretched) {
  Rig rig;
  const ObjectId id = rig.editor.document().objects[0]->id;
  rig.editor.mode = ElementMode::object;
  rig.editor.selection.select({id, element_of(id)}, Selection::How::replace);
  const PolyhedronSource before = rig.source();
  rig.start(make_transform_tool(TransformKind::rotate));
  rig.key(Key::z);
  rig.type("30");
  rig.enter();
  EXPECT_EQ(rig.editor.history.undo_label(), "Rotate object");
  rig.start(make_transform_tool(TransformKind::move));
  rig.key(Key::x);
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
  rig.key(Key::x);
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

}  // namespace
}  // namespace hariko::test

// Attaching border edges to patch objects, by commands.

#include "tests/workbench/bench_hands.hpp"

namespace hariko::test {
namespace {

class AttachCommands : public BenchHands {
 protected:
  AttachCommands() : BenchHands(document(), {800, 560}) {}

  /// A wing above the hood: side 0 of the wing faces the hood's edge 2-3.
  static Document document() {
    BicubicNet net{1, 1, {}};
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) net.points.emplace_back(-1 + i / 1.5, 1.1 + j / 3.0, 0.1 * j * j);
    Document made = add_object({}, "Wing", PatchSource::from_net(net).value()).value().document;
    return add_object(made, "Hood", PolyhedronSource::from_mesh(grid(1, 1)).value()).value().document;
  }
  const Object& wing() { return *bench_.editor().document().objects.front(); }
  const Object& hood() { return *bench_.editor().document().objects.back(); }
  void select_edge() {
    Editor& editor = bench_.editor();
    editor.mode = ElementMode::edge;
    editor.selection.active = hood().id;
    editor.selection.select({hood().id, element_of(EdgeId::of({2}, {3}))}, Selection::How::replace);
    bench_.frame();
  }
};

TEST_F(AttachCommands, AnEdgeFollowsTheNearestSideUntilItIsReleased) {
  select_edge();
  run("shape.attach");
  ASSERT_EQ(hood().polyhedron()->attachments->size(), 1U);
  const Attachment& attachment = hood().polyhedron()->attachments->begin()->second;
  EXPECT_EQ(attachment.patch, wing().id);
  EXPECT_EQ(attachment.side, (NetSide{0, 0}));
  EXPECT_EQ(attachment.continuity, Continuity::g1);
  // Control points can be moved, and the edge follows.
  const Vector3 before = attached_polyhedron(bench_.editor().document(), hood()).position(2);
  const VertexId corner{0};
  const Vector3 to = wing().patches()->net.position(0) + Vector3(0, 0, 0.3);
  ASSERT_TRUE(bench_.editor().commit(
      move_vertices(bench_.editor().history.current(), wing().id, std::span(&corner, 1), std::span(&to, 1)),
      "Move"));
  bench_.frame();
  EXPECT_NEAR((attached_polyhedron(bench_.editor().document(), hood()).position(2) - before).norm(), 0.3,
              1e-12);
  run("shape.release_edges");
  EXPECT_TRUE(hood().polyhedron()->attachments->empty());
  bench_.editor().undo();
  EXPECT_EQ(hood().polyhedron()->attachments->size(), 1U);
}

TEST_F(AttachCommands, DeletingThePatchSaysThatItsSideIsKept) {
  select_edge();
  run("shape.attach");
  Editor& editor = bench_.editor();
  editor.mode = ElementMode::object;
  editor.selection.clear_elements();
  editor.selection.clear_objects();
  editor.selection.active = wing().id;
  editor.selection.select({wing().id, element_of(wing().id)}, Selection::How::add);
  const std::size_t notices = editor.notices().size();
  run("object.delete");
  ASSERT_EQ(editor.document().objects.size(), 1U);
  EXPECT_TRUE(hood().polyhedron()->attachments->begin()->second.frozen.has_value());
  EXPECT_GT(editor.notices().size(), notices);
}

TEST_F(AttachCommands, PatchesCanBeAddedAndTheirPointsSelected) {
  run("add.patches");
  const Object& added = *bench_.editor().document().objects.back();
  ASSERT_TRUE(added.patches());
  EXPECT_EQ(added.patches()->net.vertex_count(), 16U);
  bench_.editor().mode = ElementMode::vertex;
  bench_.editor().selection.active = added.id;
  run("select.all");
  EXPECT_EQ(bench_.editor().selection.of(added.id).vertices.size(), 16U);
}

TEST_F(AttachCommands, PointsOfPatchesMoveInLocalEditing) {
  // There are no tangents to fix; looking for them crashed.
  Editor& editor = bench_.editor();
  editor.mode = ElementMode::vertex;
  editor.selection.active = wing().id;
  run("select.all");
  run("transform.local_edit");
  ASSERT_TRUE(editor.transform.local_edit);
  const Vector3 before = wing().patches()->origin + wing().patches()->net.position(5);
  for (const char* key : {"G", "X", "2", "Enter"}) bench_.key(key);
  const Vector3 moved = wing().patches()->origin + wing().patches()->net.position(5) - before;
  EXPECT_NEAR((moved - Vector3(2, 0, 0)).norm(), 0, 1e-9) << moved.transpose();
}

}  // namespace
}  // namespace hariko::test

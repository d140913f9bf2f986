// Commands of the Mesh menu on what is selected: what they make of it, and why they refuse.

#include <map>
#include <set>

#include "core/document/edits/edits.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"
#include "ui/editor/command_table.hpp"

namespace hariko::test {
namespace {

class MeshCommands : public ::testing::Test {
 protected:
  HeadlessWorkbench bench{document_from_mesh(test::prism(4), "Box").value()};
  Editor& editor = bench.editor();

  const PolyhedronSource& source() { return *editor.active_object()->polyhedron(); }
  Vector3 place(unsigned vertex) {
    return source().origin + source().polyhedron.position(source().polyhedron.find(VertexId{vertex}));
  }
  void choose(std::initializer_list<unsigned> vertices) {
    editor.mode = ElementMode::vertex;
    editor.selection.clear_elements();
    for (const unsigned v : vertices)
      editor.selection.select({editor.selection.active, element_of(VertexId{v})}, Selection::How::add);
  }
  CommandTable::Outcome run(std::string_view id) {
    const auto outcome = bench.workbench().commands().run(id);
    bench.frame();
    return outcome;
  }
};

TEST(MeshCommandsWithoutASurface, RefinementsSayThatTheyDoNotKeepIt) {
  // Faces with more sides than the surface takes.
  Document document = document_from_mesh(test::prism(129), "Prism").value();
  const ObjectId object = document.objects[0]->id;
  HeadlessWorkbench bench{set_frames(document, object, Frames::metric).value()};
  Editor& editor = bench.editor();
  const auto& edge = editor.active_object()->polyhedron()->polyhedron.edge_id(0);
  editor.mode = ElementMode::edge;
  editor.selection.select({object, element_of(edge)}, Selection::How::replace);
  ASSERT_TRUE(bench.workbench().commands().run("mesh.subdivide").ran);
  EXPECT_EQ(editor.history.undo_label(), "Subdivide edges");
  ASSERT_FALSE(editor.notices().empty());
  EXPECT_EQ(editor.notices().back().kind, Notice::Kind::warning);
  EXPECT_NE(editor.notices().back().text.find("straight edges"), std::string::npos)
      << editor.notices().back().text;
  EXPECT_NE(editor.notices().back().remedy.find("129 sides"), std::string::npos)
      << editor.notices().back().remedy;
  editor.undo();
  editor.notices().clear();
  editor.settings.refine_on_surface = false;
  ASSERT_TRUE(bench.workbench().commands().run("mesh.subdivide").ran);
  EXPECT_TRUE(editor.notices().empty()) << "straight edges were asked for";
}

TEST_F(MeshCommands, MergeWhereTheFirstTheLastOrTheirCentreIs) {
  const Document before = editor.document();
  const Vector3 a = place(0), b = place(1);
  const auto merged = [&](std::string_view id) {
    choose({1, 0});
    EXPECT_TRUE(run(id).ran) << id;
    EXPECT_EQ(source().polyhedron.vertex_count(), 7U);
    EXPECT_EQ(editor.selection.of_active().vertices.size(), 1U);
    const VertexId left = *editor.selection.of_active().vertices.begin();
    const Vector3 at = place(left.value);
    editor.undo();
    EXPECT_EQ(editor.document(), before);
    return at;
  };
  EXPECT_EQ(merged("mesh.merge_first"), b);
  EXPECT_EQ(merged("mesh.merge_last"), a);
  EXPECT_LT((merged("mesh.merge_centre") - (a + b) / 2).norm(), 1e-12);
}

TEST_F(MeshCommands, FirstAndLastAreNotGuessed) {
  const Document before = editor.document();
  ElementSelection several;
  several.vertices = {VertexId{0}, VertexId{1}};
  editor.mode = ElementMode::vertex;
  editor.selection.select(editor.selection.active, several, Selection::How::replace);
  for (const char* id : {"mesh.merge_first", "mesh.merge_last"}) {
    const auto outcome = run(id);
    EXPECT_FALSE(outcome.ran) << id;
    EXPECT_GT(outcome.reason.size(), 8U);
  }
  EXPECT_EQ(editor.document(), before);
}

TEST_F(MeshCommands, MergeByDistanceCanBeAdjusted) {
  editor.mode = ElementMode::vertex;
  editor.selection.select_all(*editor.active_object(), ElementMode::vertex);
  run("mesh.merge_distance");
  EXPECT_EQ(source().polyhedron.vertex_count(), 8U) << "nothing is so near: refused with a notice";
  EXPECT_FALSE(editor.notices().empty());
}

TEST_F(MeshCommands, RefinementsKeepTheSurfaceUnlessTheDesignerSaysOtherwise) {
  editor.commit(set_frames(editor.history.current(), editor.selection.active, Frames::metric), "By measure");
  const Vector3 straight = (place(0) + place(1)) / 2;
  const auto subdivided = [&] {
    editor.mode = ElementMode::face;
    editor.selection.select_all(*editor.active_object(), ElementMode::face);
    EXPECT_TRUE(run("mesh.subdivide").ran);
    double nearest = 1e300;
    for (const Vector3& p : source().polyhedron.positions())
      nearest = std::min(nearest, (source().origin + p - straight).norm());
    const bool remembers = !source().shaping->form.empty();
    editor.undo();
    return std::pair(nearest, remembers);
  };
  ASSERT_TRUE(editor.settings.refine_on_surface) << "the default";
  const auto on_surface = subdivided();
  EXPECT_GT(on_surface.first, 0.05);
  EXPECT_TRUE(on_surface.second);

  for (const char* tool : {"mesh.loop_cut", "mesh.knife"}) {
    for (const bool then : {false, true}) {
      run(tool);
      ASSERT_TRUE(bench.workbench().viewport().tool_active());
      bench.key("E");
      EXPECT_EQ(editor.settings.refine_on_surface, then) << tool;
      bench.key("Esc");
    }
  }
  run("mesh.on_surface");
  EXPECT_FALSE(editor.settings.refine_on_surface);
  const auto on_edges = subdivided();
  EXPECT_LT(on_edges.first, 1e-12);
  EXPECT_FALSE(on_edges.second);
}

std::set<std::string> offered(const std::vector<MenuNode>& nodes) {
  std::set<std::string> ids;
  for (const MenuNode& node : nodes) {
    if (node.command) ids.insert(node.command->id);
    for (const std::string& id : offered(node.children)) ids.insert(id);
  }
  return ids;
}

TEST_F(MeshCommands, ContextMenusOfferWhatADesignerLooksFor) {
  const std::map<Context, std::vector<const char*>> expected{
      {Context::vertex,
       {"mesh.bevel_vertices", "mesh.knife", "mesh.connect", "mesh.merge_centre", "mesh.merge_first",
        "mesh.merge_last", "mesh.merge_distance", "mesh.dissolve", "mesh.delete", "shape.tension",
        "shape.corner"}},
      {Context::edge,
       {"mesh.bevel_edges", "mesh.loop_cut", "mesh.knife", "mesh.bridge", "mesh.fill_hole", "mesh.dissolve",
        "mesh.delete", "shape.crease", "shape.tension", "mesh.extrude", "mesh.collapse"}},
      {Context::face,
       {"mesh.extrude", "mesh.inset", "mesh.triangulate", "mesh.decompose", "mesh.bridge", "mesh.flip",
        "mesh.delete", "mesh.duplicate_faces", "mesh.detach", "mesh.knife"}},
      {Context::object,
       {"object.duplicate", "object.rename", "object.hide", "mesh.join", "mesh.delete", "mirror.live_x",
        "mirror.object_x", "mirror.apply"}},
      {Context::empty, {"add.box", "add.sphere", "add.icosahedron", "file.import", "view.frame_all"}}};
  for (const auto& [context, ids] : expected) {
    const auto tree = context_menu_tree(bench.workbench().commands(), context);
    EXPECT_LE(tree.size(), 30U) << "it must fit a low window";
    EXPECT_FALSE(tree.front().separator_before);
    const auto there = offered(tree);
    for (const char* id : ids)
      EXPECT_TRUE(there.contains(id)) << id << " for " << static_cast<unsigned>(context);
  }
  const auto empty = context_menu_tree(bench.workbench().commands(), Context::empty);
  EXPECT_EQ(empty.front().submenu, "Add");
}

TEST_F(MeshCommands, TheToolColumnBevelsWhatIsSelected) {
  choose({0});
  bench.frame();
  EXPECT_TRUE(bench.workbench().marks().all().contains("button.mesh.bevel_vertices"));
  bench.key("2");
  bench.frame();
  EXPECT_TRUE(bench.workbench().marks().all().contains("button.mesh.bevel_edges"));
  for (const char* id : {"select.lasso", "mesh.extrude", "mesh.inset", "mesh.loop_cut", "mesh.knife"})
    EXPECT_TRUE(bench.workbench().marks().all().contains(std::string("button.") + id)) << id;
}

TEST_F(MeshCommands, AnotherPlaneKeepsTheImageOfTheLiveMirror) {
  run("mirror.live_x");
  ASSERT_TRUE(source().mirror.has_value());
  bench.frame();
  const std::string badge = "mirror." + std::to_string(editor.selection.active.value);
  EXPECT_TRUE(bench.workbench().marks().all().contains(badge));
  EXPECT_TRUE(bench.workbench().marks().all().contains("button.apply_mirror"));
  run("mirror.live_y");
  EXPECT_EQ(source().mirror->axis, Axis::y);
  const auto xs = [&] {
    std::pair<double, double> range{1e9, -1e9};
    for (Index v = 0; v < source().polyhedron.vertex_count(); ++v) {
      const double x = source().origin.x() + source().polyhedron.position(v).x();
      range = {std::min(range.first, x), std::max(range.second, x)};
    }
    return range;
  }();
  EXPECT_NEAR(xs.first, -xs.second, 1e-9) << "both sides of x are there";
  run("mirror.apply");
  EXPECT_FALSE(source().mirror.has_value());
  bench.frame();
  EXPECT_FALSE(bench.workbench().marks().all().contains(badge));
}

}  // namespace
}  // namespace hariko::test

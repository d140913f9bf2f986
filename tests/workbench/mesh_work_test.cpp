// Modelling a cube by hand: a face is extruded and inset, edges and corners are bevelled, loops are cut, and
// all of it goes back and forth.

#include <optional>
#include <string_view>
#include <vector>

#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

/// The face of a cube that is nearest to the eye is selected.
class MeshWork : public ::testing::Test, protected ProgramHands {
 protected:
  void SetUp() override {
    open_copy("tests/golden/cube.obj");
    EXPECT_EQ(editor().history.position(), 0U) << "an opened mesh begins with a step";
    const Polyhedron& mesh = source().polyhedron;
    double least = 1e300;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      std::vector<VertexId> corners;
      for (const Index v : mesh.topology().face_vertices(f)) corners.push_back(mesh.vertex_id(v));
      const double far = depth(between(corners));
      if (far < least) least = far, face_ = corners;
    }
    at_ = pixel(between(face_));
    press({"3"});
    click(at_);
    ASSERT_EQ(selected(), "1 face");
  }
  const PolyhedronSource& source() { return *editor().active_object()->polyhedron(); }
  Vector3 place(VertexId v) {
    return source().origin + source().polyhedron.position(source().polyhedron.find(v));
  }
  Vector3 between(const std::vector<VertexId>& vertices) {
    Vector3 sum = Vector3::Zero();
    for (const VertexId v : vertices) sum += place(v);
    return sum / double(vertices.size());
  }
  bool moving() { return editor().history.in_gesture(); }
  void undo(int steps = 1) {
    for (int i = 0; i < steps; ++i) press({"Ctrl+Z"});
    wait();
  }
  /// Begins with a key, types an amount and ends with Enter.
  void by_number(const char* key, std::string_view amount) {
    press({key});
    type(amount);
    press({"Enter"});
    wait();
  }
  /// Insets by the pointer: to the right is more.
  void inset() {
    bench().move(at_.x(), at_.y());
    press({"I"});
    bench().move(at_.x() + 30, at_.y());
    bench().move(at_.x() + 60, at_.y());
    EXPECT_TRUE(moving());
    click(at_ + Vector2(60, 0));
    wait();
  }
  void extrude_and_inset() {
    by_number("E", "1.5");
    expect_step(1, "Extrude face");
    EXPECT_EQ(selected(), "1 face") << "the extruded face";
    inset();
    expect_step(2, "Inset face");
  }
  /// The middle of the curve of an edge between two corners of the face as it was that the pointer finds.
  std::optional<Vector2> rim() {
    for (std::size_t k = 0; k < face_.size(); ++k) {
      const VertexId a = face_[k], b = face_[(k + 1) % face_.size()];
      const Vector2 middle = curve_near(between({a, b}));
      bench().move(middle.x(), middle.y());
      frames(2);
      if (editor().hovered && editor().hovered->element == element_of(EdgeId::of(a, b))) return middle;
    }
    return {};
  }

  std::vector<VertexId> face_;
  Vector2 at_ = Vector2::Zero();  ///< window pixels of its middle
};

TEST_F(MeshWork, EscInTheMiddleOfAnExtrusionLeavesNothing) {
  const Document before = editor().document();
  press({"E"});
  bench().move(at_.x() + 40, at_.y() - 60);
  EXPECT_TRUE(moving());
  press({"Esc"});
  EXPECT_EQ(editor().history.position(), 0U);
  EXPECT_EQ(editor().document(), before);
  EXPECT_EQ(selected(), "1 face");
}

TEST_F(MeshWork, AnInsetThatIsWiderThanTheFaceIsRefusedAndWaitsForAnotherNumber) {
  extrude_and_inset();
  const Document before = editor().document();
  by_number("I", "50");
  EXPECT_EQ(editor().document(), before);
  EXPECT_EQ(editor().history.position(), 2U);
  EXPECT_TRUE(bench().workbench().viewport().tool_active());
  press({"Esc"});
  EXPECT_FALSE(bench().workbench().viewport().tool_active());
  expect_step(2, "Inset face");
}

TEST_F(MeshWork, AllEdgesAndAllCornersAreBevelled) {
  extrude_and_inset();
  press({"2", "Ctrl+A"});
  EXPECT_EQ(selected(), "28 edges");
  by_number("Ctrl+B", "0.05");
  expect_step(3, "Bevel 28 edges");
  undo();
  expect_step(2, "Inset face");
  press({"1", "Ctrl+A"});
  EXPECT_EQ(selected(), "16 vertices");
  by_number("Ctrl+Shift+B", "0.02");
  EXPECT_EQ(editor().history.position(), 3U);
  EXPECT_TRUE(editor().history.undo_label().starts_with("Bevel ")) << editor().history.undo_label();
}

TEST_F(MeshWork, LoopsAreCutAtTheRimAndEverythingGoesBackAndForth) {
  extrude_and_inset();
  press({"2", "Ctrl+Shift+A"});
  const auto edge = rim();
  ASSERT_TRUE(edge.has_value()) << "no edge of the rim is under the pointer where its curve is";
  press({"Ctrl+R"});
  bench().move(edge->x() + 1, edge->y() + 1);
  type("2");
  click(*edge + Vector2(1, 1));
  EXPECT_TRUE(moving()) << "the cut slides";
  press({"Enter"});
  wait();
  expect_step(3, "2 loop cuts");
  const Polyhedron& mesh = source().polyhedron;
  EXPECT_EQ(mesh.vertex_count() + mesh.face_count(), mesh.edge_count() + 2);

  press({"Ctrl+S"});
  name_file("a.hariko");
  wait();
  EXPECT_FALSE(editor().history.dirty()) << notice();
  const Document saved = editor().document();
  undo(3);
  EXPECT_EQ(editor().history.position(), 0U);
  EXPECT_TRUE(editor().history.dirty());
  for (std::size_t position = 1; position <= 3; ++position) {
    press({"Ctrl+Y"});
    EXPECT_EQ(editor().history.position(), position);
  }
  wait();
  EXPECT_FALSE(editor().history.dirty()) << "undo and redo led to another document";
  EXPECT_EQ(editor().document(), saved);
}

}  // namespace
}  // namespace hariko::test

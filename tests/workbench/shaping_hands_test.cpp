// Local editing and joins by hand, through the whole interface: a vertex is moved and its tangent plane
// turned with the tangents round it pinned and released; border edges of the wheel arch are released,
// attached again and joined by their position only.

#include <algorithm>

#include "tests/workbench/program_hands.hpp"
#include "ui/editor/object_kind.hpp"

namespace hariko::test {
namespace {

class ShapingByHand : public ::testing::Test, protected ProgramHands {
 protected:
  ShapingByHand() : ProgramHands(Begin::start_page, std::make_shared<TemporaryFolder>(), {1280, 800}) {}
};

TEST_F(ShapingByHand, LocalEditingPinsTheTangentsRoundAVertex) {
  open_sample("fig2");
  ASSERT_TRUE(editor().active_object() && editor().active_object()->polyhedron()) << notice();
  const auto pins = [&]() -> const auto& {
    return editor().active_object()->polyhedron()->shaping->pin;
  };
  ASSERT_EQ(pins().size(), 0U);
  press({"Shift+O"});
  wait();
  EXPECT_TRUE(editor().transform.local_edit);
  click(nearest_corner());
  wait();
  ASSERT_EQ(selected(), "1 vertex");
  const VertexId vertex = *editor().selection.of_active().vertices.begin();
  // Turning the tangent plane fixes it and the tangents round it.
  press({"R", "X"});
  type("20");
  press({"Enter"});
  wait();
  EXPECT_EQ(editor().history.position(), 1U);
  EXPECT_EQ(surface_error(), "");
  const std::size_t pinned = pins().size();
  EXPECT_GT(pinned, 3U) << "the tangents round it are free";
  ASSERT_TRUE(pins().contains(vertex));
  EXPECT_EQ(pins().find(vertex)->kind, Pin::Kind::tangents);
  // Moving changes the position and keeps the pins.
  press({"G", "Z"});
  type("1");
  press({"Enter"});
  wait();
  EXPECT_EQ(editor().history.position(), 2U);
  EXPECT_EQ(surface_error(), "");
  EXPECT_GE(pins().size(), pinned) << "moving has released pins";
  // A released pin is gone and comes back by undo.
  press({"Shift+P"});
  wait_for_step(3, "Release pins");
  EXPECT_FALSE(pins().contains(vertex));
  press({"Ctrl+Z"});
  wait();
  EXPECT_TRUE(pins().contains(vertex));
  press({"Ctrl+Z", "Ctrl+Z"});
  wait();
  EXPECT_EQ(editor().history.position(), 0U);
  EXPECT_EQ(pins().size(), 0U) << "undo leaves pins";
}

/// The edge of the cover's outer ring whose middle is nearest to the eye.
class JoinsByHand : public ShapingByHand {
 protected:
  void SetUp() override {
    open_sample("wheel_arch");
    const auto& objects = editor().document().objects;
    const auto cover = std::find_if(objects.begin(), objects.end(), [](const auto& object) {
      return object->polyhedron() && !object->polyhedron()->attachments->empty();
    });
    ASSERT_TRUE(cover != objects.end()) << notice();
    cover_ = (*cover)->id;
    double least = 1e300;
    for (const auto& [edge, attachment] : attachments())
      if (const double far = depth(end(edge.low)) + depth(end(edge.high)); far < least)
        least = far, edge_ = edge;
    press({"2"});
    wait();
    click((pixel(end(edge_.low)) + pixel(end(edge_.high))) / 2);
    wait();
    ASSERT_EQ(editor().selection.active, cover_);
    ASSERT_EQ(selected(), "1 edge");
    ASSERT_TRUE(editor().selection.of(cover_).edges.contains(edge_));
    ASSERT_TRUE(marks().contains("combo.join"));
  }
  const Attachments& attachments() { return *editor().document().find(cover_)->polyhedron()->attachments; }
  Vector3 end(VertexId vertex) { return *place_of(editor().document(), {cover_, element_of(vertex)}); }

  ObjectId cover_;
  EdgeId edge_;
};

TEST_F(JoinsByHand, OnlyThePositionCanBeJoined) {
  const Attachments before = attachments();
  choose("join", 0);
  wait_for_step(1, "Joint");
  EXPECT_EQ(surface_error(), "");
  EXPECT_EQ(attachments().find(edge_)->continuity, Continuity::g0);
  press({"Ctrl+Z"});
  wait();
  EXPECT_TRUE(attachments() == before) << "undo changed the attachments";
}

TEST_F(JoinsByHand, NeitherCanFollowTheOther) {
  // The fender cannot follow one edge of a cover that follows it at the others.
  choose("adapts", 1);
  wait();
  EXPECT_EQ(editor().history.position(), 0U);
  EXPECT_NE(notice().find("follow the other"), std::string::npos) << notice();
}

TEST_F(JoinsByHand, AReleasedEdgeIsAttachedAgain) {
  const Attachments before = attachments();
  click("button.release_edges");
  wait_for_step(1, "Release edges");
  EXPECT_EQ(surface_error(), "");
  EXPECT_FALSE(attachments().contains(edge_));
  press({"Ctrl+Shift+P"});
  frames(3);
  type("Attach to patch side");
  frames(2);
  press({"Enter"});
  wait_for_step(2, "Attach edge");
  EXPECT_EQ(surface_error(), "");
  EXPECT_TRUE(attachments().contains(edge_)) << "the edge was not attached";
  EXPECT_EQ(attachments().size(), before.size());
  press({"Ctrl+Z", "Ctrl+Z"});
  wait();
  EXPECT_TRUE(attachments() == before) << "undo changed the attachments";
}

}  // namespace
}  // namespace hariko::test

// Skins by hand, through the whole interface: drawn by points and strokes, closed, given rails, more sections
// and lines of correspondence, converted, exported and saved.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "core/document/file.hpp"
#include "core/subdivision/subdivision_curve.hpp"
#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

/// Places of the pointer on its way from corner to corner.
std::vector<Vector2> along_corners(const std::vector<Vector2>& corners, int steps = 8) {
  std::vector<Vector2> out{corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i)
    for (int k = 1; k <= steps; ++k)
      out.push_back(corners[i - 1] + (corners[i] - corners[i - 1]) * k / steps);
  return out;
}

Vector2 part_way(const Vector2& from, const Vector2& to, double share = 0.5) {
  return from + share * (to - from);
}

/// A closed curve round two places, at about this distance.
std::vector<Vector2> ring_round(const Vector2& a, const Vector2& b, double distance) {
  const double way = std::atan2(b.y() - a.y(), b.x() - a.x());
  std::vector<Vector2> out;
  for (int i = 0; i < 14; ++i) {
    const double begin = way + (i < 7 ? -0.5 : 0.5) * std::numbers::pi;
    const double turn = begin + std::numbers::pi * (i % 7) / 6;
    out.push_back((i < 7 ? b : a) + distance * Vector2(std::cos(turn), std::sin(turn)));
  }
  const Vector2 first = out.front();
  out.push_back(first);
  return out;
}

class SkinByHand : public ::testing::Test, protected ProgramHands {
 protected:
  SkinByHand() : ProgramHands(Begin::empty, std::make_shared<TemporaryFolder>(), {1280, 800}) { wait(); }

  const Skin& skin() { return *editor().active_object()->skin()->skin; }
  void undo(int steps) {
    for (int i = 0; i < steps; ++i) press({"Ctrl+Z"});
    wait();
  }
  void drag_mark(const std::string& mark, const Vector2& by) {
    const Vector2 at = middle_of(mark);
    stroke(along_corners({at, at + by}, 6));
  }
  /// Saves the document and opens it again; returns what the file has.
  Document saved_and_opened() {
    press({"Ctrl+S"});
    name_file("skin.hariko");
    wait();
    const auto saved = load_document(folder() / "skin.hariko");
    EXPECT_TRUE(saved.ok()) << notice();
    if (!saved.ok()) return {};
    EXPECT_EQ(*saved, editor().document());
    session().open(folder() / "skin.hariko");
    wait();
    return *saved;
  }
};

/// A path by points and two sections by strokes.
class DrawnSkinByHand : public SkinByHand {
 protected:
  /// A stroke over the middle of the view, from left to right.
  std::vector<Vector2> arch(double width, double height) {
    const Vector2 ground = in_view(0.5, 0.6);
    std::vector<Vector2> corners;
    for (int i = 0; i <= 16; ++i) {
      const double angle = std::numbers::pi * i / 16;
      corners.push_back(ground - Vector2(width * std::cos(angle), height * std::sin(angle)));
    }
    return along_corners(corners, 2);
  }
  void SetUp() override {
    menu("Skin", "skin.draw");
    wait();
    for (const Vector2& place :
         {in_view(0.25, 0.62), in_view(0.42, 0.58), in_view(0.58, 0.5), in_view(0.75, 0.38)})
      click(place);
    press({"Enter"});
    wait();
    stroke(arch(150, 170));
    wait();
    press({"Enter"});
    wait();
    stroke(arch(190, 90));
    press({"Enter"});
    wait_for_step(1, "Draw skin");
    ASSERT_TRUE(editor().active_object() && editor().active_object()->skin()) << hint();
    ASSERT_EQ(surface_error(), "");
  }
};

TEST_F(DrawnSkinByHand, HasASurfaceByEveryMethod) {
  EXPECT_EQ(skin().path.size(), 4);
  EXPECT_EQ(skin().sections.size(), 2U);
  choose("skin_method", 0);
  wait_for_step(2, "Method of the skin");
  EXPECT_EQ(skin().method, SkinMethod::smooth);
  EXPECT_EQ(surface_error(), "");
  choose("skin_method", 2);
  wait_for_step(3, "Method of the skin");
  EXPECT_EQ(skin().method, SkinMethod::pleat);
  EXPECT_EQ(surface_error(), "");
}

TEST_F(DrawnSkinByHand, SectionsAndPathAreClosedAndOpened) {
  const Skin drawn = skin();
  EXPECT_FALSE(marks().contains("combo.skin_caps")) << "open sections have ends to close";
  menu("Skin", "skin.close_sections");
  wait_for_step(2, "Close or open sections");
  EXPECT_EQ(surface_error(), "") << "a tube";
  EXPECT_TRUE(marks().contains("combo.skin_caps"));
  click("check.skin_closed");
  wait_for_step(3, "Close or open sections");
  EXPECT_FALSE(marks().contains("combo.skin_caps")) << "the sections are still closed";
  EXPECT_TRUE(marks_of("skin.place.").empty()) << "sections at the ends can slide";
  menu("Skin", "skin.close_path");
  wait_for_step(4, "Close or open path");
  EXPECT_EQ(surface_error(), "") << "a closed path";
  EXPECT_EQ(marks_of("skin.place.").size(), 2U) << "on a closed path every section slides";
  menu("Skin", "skin.close_path");
  wait_for_step(5, "Close or open path");
  EXPECT_TRUE(marks_of("skin.place.").empty()) << "the path is still closed";
  // Opening a path keeps the part between the sections only, so all goes back as it was drawn.
  undo(4);
  EXPECT_EQ(skin(), drawn);
  EXPECT_EQ(surface_error(), "");
}

TEST_F(DrawnSkinByHand, TwoRailsAreMadeDraggedAndBent) {
  EXPECT_TRUE(marks_of("skin.rail.").empty()) << "there is a second rail";
  choose("skin_frame", 3);
  wait_for_step(2, "Frames of the skin");
  EXPECT_EQ(surface_error(), "") << "two rails";
  ASSERT_EQ(marks_of("skin.rail.").size(), 4U);
  drag_mark("skin.rail.1", {12, -30});
  wait_for_step(3, "Move path");
  EXPECT_EQ(surface_error(), "") << "a bent rail";
  click(middle_of("skin.path.1"));
  wait();
  click("check.skin_path_sharp");
  wait_for_step(4, "Corner");
  EXPECT_EQ(surface_error(), "") << "a corner in a rail";
  undo(3);
  EXPECT_TRUE(marks_of("skin.rail.").empty()) << "undo leaves the rail";
}

TEST_F(DrawnSkinByHand, ASectionIsAddedByAClickAndSlidAlongThePath) {
  EXPECT_TRUE(marks_of("skin.place.").empty()) << "sections at the ends can slide";
  // The surface is seen between the tops of both arches.
  const auto top = [&](std::size_t k) {
    const std::vector<Vector3> points = limit_points(skin().sections[k].curve());
    return Vector3(points[points.size() / 2]);
  };
  const Vector2 between = pixel((top(0) + top(1)) / 2);
  menu("Skin", "skin.section_here");
  wait();
  click(between);
  wait_for_step(2, "Add section");
  ASSERT_EQ(skin().sections.size(), 3U);
  EXPECT_EQ(surface_error(), "") << "with one more section";
  // The selection goes, so that no handles stand over the path.
  press({"Enter", "Ctrl+Shift+A"});
  wait();
  ASSERT_EQ(marks_of("skin.place.").size(), 1U);
  const std::string place = marks_of("skin.place.").front();
  const Vector2 before = middle_of(place), end = middle_of("skin.path.3");
  drag_mark(place, part_way(before, end, 0.25) - before);
  wait_for_step(3, "Slide section");
  const Skin slid = skin();
  EXPECT_LT((middle_of(place) - end).norm(), 0.9 * (before - end).norm());
  press({"Ctrl+Z"});
  wait_for_step(2, "Add section");
  EXPECT_LT((middle_of(place) - before).norm(), 3) << "undo leaves the section elsewhere";
  press({"Ctrl+Y"});
  wait_for_step(3, "Slide section");
  EXPECT_EQ(skin(), slid);

  const Document file = saved_and_opened();
  ASSERT_EQ(file.objects.size(), 1U);
  EXPECT_EQ(file.objects[0]->skin()->skin->sections.size(), 3U);
  EXPECT_EQ(file.objects[0]->skin()->skin->path.size(), 4);
  EXPECT_EQ(surface_error(), "");
  EXPECT_EQ(marks_of("skin.place.").size(), 1U) << "the section in the middle is not shown";
}

TEST_F(DrawnSkinByHand, BecomesAPolyhedronInOneStep) {
  menu("Skin", "skin.to_polyhedron");
  wait_for_step(2, "Convert to polyhedron");
  ASSERT_EQ(editor().document().objects.size(), 2U) << notice();
  EXPECT_FALSE(editor().document().objects[0]->visible);
  EXPECT_TRUE(editor().active_object()->polyhedron());
  undo(1);
  ASSERT_EQ(editor().document().objects.size(), 1U);
  EXPECT_TRUE(editor().document().objects[0]->visible);
}

TEST_F(DrawnSkinByHand, GivesItsControlMeshToAFile) {
  menu("File", "file.export_control");
  name_file("control.obj");
  wait();
  std::istringstream lines(slurp(folder() / "control.obj"));
  std::size_t vertices = 0, faces = 0, least = 1, largest = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("v ")) ++vertices;
    if (!line.starts_with("f ")) continue;
    ++faces;
    std::istringstream corners(line.substr(2));
    for (std::string corner; corners >> corner;) {
      const std::size_t vertex = std::stoul(corner);
      least = std::min(least, vertex);
      largest = std::max(largest, vertex);
    }
  }
  EXPECT_GT(vertices, 12U) << notice();
  EXPECT_GT(faces, 6U);
  EXPECT_EQ(least, 1U);
  EXPECT_LE(largest, vertices) << "a face has no such vertex";
}

/// Two arches as the menu adds them, the top of the first drawn up.
class AddedSkinByHand : public SkinByHand {
 protected:
  void SetUp() override {
    menu("Add", "add.skin");
    wait_for_step(1, "Add skin");
    ASSERT_TRUE(editor().active_object() && editor().active_object()->skin());
    ASSERT_TRUE(marks().contains("skin.limit.3"));
    drag_mark("skin.limit.3", {0, -50});
    wait_for_step(2, "Move section points");
  }
  /// Shows the points behind the surface, and mirrors what is done to the others.
  void see_through_with_mirror() {
    press({"Alt+X"});
    click("section.skin_more");
    choose("skin_mirror", 2);
    wait_for_step(3, "Mirror of the skin");
    ASSERT_TRUE(marks().contains("skin.mirror"));
  }
  Vector2 limit(int point) { return middle_of("skin.limit." + std::to_string(point)); }
};

TEST_F(AddedSkinByHand, APointGoesWhereItIsDragged) {
  const Vector2 dragged = limit(3);
  undo(1);
  EXPECT_EQ(editor().history.undo_label(), "Add skin");
  EXPECT_LT((limit(3) + Vector2(0, -50) - dragged).cwiseAbs().maxCoeff(), 25);
  press({"Ctrl+Y"});
  wait_for_step(2, "Move section points");
  EXPECT_LT((limit(3) - dragged).norm(), 2);
}

TEST_F(AddedSkinByHand, WithAMirrorBothHalvesMove) {
  EXPECT_FALSE(marks().contains("skin.limit.4")) << "a point behind the surface is shown";
  see_through_with_mirror();
  const Vector2 own = limit(2), middle = limit(3), image = limit(4);
  drag_mark("skin.limit.2", {0, -40});
  wait_for_step(4, "Move section points");
  EXPECT_GT((limit(2) - own).norm(), 20);
  EXPECT_GT((limit(4) - image).norm(), 10);
  EXPECT_LT((limit(3) - middle).norm(), 3);
  undo(1);
  EXPECT_EQ(editor().history.undo_label(), "Mirror of the skin");
  EXPECT_LT((limit(4) - image).norm(), 3) << "undo leaves the other half elsewhere";
}

TEST_F(AddedSkinByHand, StrokesJoinMergeAndGroupPointsAndStayInTheFile) {
  see_through_with_mirror();
  menu("Skin", "skin.correspond");
  wait();
  stroke(along_corners({limit(1), limit(9)}));
  wait_for_step(4, "Join points");
  // A wedge from both sides of points 2 to 4, its tip well before the middle of the way: its legs are far
  // from parallel.
  const Vector2 start = limit(3);
  stroke(along_corners(
      {part_way(limit(1), limit(2)), part_way(start, limit(10), 0.4), part_way(limit(4), limit(5))}));
  wait_for_step(5, "Merge points");
  ASSERT_FALSE(marks_of("skin.diamond.").empty());
  const std::string diamond = marks_of("skin.diamond.").front();
  const Vector2 before = middle_of(diamond);
  drag_mark(diamond, part_way(before, start) - before);
  wait_for_step(6, "Move a merge");
  EXPECT_LT((middle_of(diamond) - start).norm(), 0.8 * (before - start).norm());
  // Undo takes back one gesture at a time in the tool, too.
  press({"Ctrl+Z"});
  wait_for_step(5, "Merge points");
  EXPECT_LT((middle_of(diamond) - before).norm(), 3) << "undo leaves the diamond elsewhere";
  press({"Ctrl+Shift+Z"});
  wait_for_step(6, "Move a merge");
  stroke(along_corners(ring_round(limit(5), limit(12), 12), 2));
  wait_for_step(7, "Group points");
  stroke(along_corners({{300, 700}, {360, 700}, {360, 760}, {420, 760}}));
  wait_for_step(7, "Group points");
  press({"Enter"});

  // A section from the surface, behind that of the selected point.
  click(limit(3));
  wait();
  menu("Skin", "skin.add_section");
  wait_for_step(8, "Add section");
  EXPECT_EQ(surface_error(), "") << "with the section";

  const Document file = saved_and_opened();
  ASSERT_EQ(file.objects.size(), 1U);
  const Skin& saved = *file.objects[0]->skin()->skin;
  EXPECT_EQ(saved.sections.size(), 3U);
  ASSERT_TRUE(saved.mirror);
  EXPECT_EQ(saved.mirror->axis, 1);
  EXPECT_EQ(saved.merges.size(), 1U);
  EXPECT_TRUE(std::any_of(saved.links.begin(), saved.links.end(), [](const SkinLink& link) {
    return link.lasso;
  })) << "the group is not saved";
  EXPECT_EQ(surface_error(), "");
  EXPECT_TRUE(marks().contains("skin.limit.3"));
  EXPECT_FALSE(marks_of("skin.diamond.").empty());
  EXPECT_TRUE(marks().contains("skin.mirror"));
}

}  // namespace
}  // namespace hariko::test

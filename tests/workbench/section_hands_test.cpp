// Sections as wholes: moved, turned and scaled in their planes; drawn from shapes.

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/skinning/sections/section_frame.hpp"
#include "tests/workbench/bench_hands.hpp"

namespace hariko::test {
namespace {

class SectionHands : public BenchHands {
 protected:
  SectionHands() : BenchHands(Document(), {1280, 800}) {
    bench_.workbench().commands().run("add.skin");
    bench_.wait_for_surfaces();
    bench_.move(500, 400);
  }
  const Skin& skin() { return *editor().active_object()->skin()->skin; }
  void select_sections(const std::vector<std::size_t>& numbers) {
    ElementSelection points;
    for (const std::size_t k : numbers)
      for (const SectionPoint& p : skin().sections[k].points) points.vertices.insert(VertexId{p.id});
    editor().mode = ElementMode::vertex;
    editor().selection.set(editor().selection.active, points);
    bench_.frame();
    bench_.frame();
  }
  static Vector3 middle(const SkinSection& section) {
    Vector3 sum = Vector3::Zero();
    for (const SectionPoint& p : section.points) sum += p.position;
    return sum / double(section.size());
  }
};

TEST_F(SectionHands, OneSectionIsScaledByANumberInItsPlane) {
  select_sections({1});
  EXPECT_TRUE(bench_.workbench().marks().all().contains("gizmo.scale.x")) << "no gizmo";
  EXPECT_FALSE(bench_.workbench().marks().all().contains("gizmo.move.z")) << "a handle out of the plane";
  const SkinSection before = skin().sections[1], other = skin().sections[0];
  press({"S", "2", "Enter"});
  const SkinSection& after = skin().sections[1];
  EXPECT_EQ(skin().sections[0], other);
  const Vector3 centre = middle(before);
  for (int i = 0; i < before.size(); ++i) {
    const Vector3 wanted = centre + 2 * (before.points[std::size_t(i)].position - centre);
    EXPECT_LT((after.points[std::size_t(i)].position - wanted).norm(), 1e-9 * (1 + wanted.norm()));
  }
  EXPECT_EQ(editor().history.labels().back().substr(0, 5), "Scale");
}

TEST_F(SectionHands, SeveralSectionsAreScaledEachAboutItsOwnMiddle) {
  select_sections({0, 1});
  const Skin before = skin();
  press({"S", "3", "Enter"});
  for (std::size_t k = 0; k < 2; ++k) {
    const SkinSection &a = before.sections[k], &b = skin().sections[k];
    EXPECT_LT((middle(a) - middle(b)).norm(), 1e-9 * (1 + middle(a).norm())) << k;
    EXPECT_NEAR((b.points[0].position - middle(b)).norm(), 3 * (a.points[0].position - middle(a)).norm(),
                1e-9);
  }
}

TEST_F(SectionHands, MovesStayInThePlaneHoweverThePointerGoes) {
  select_sections({1});
  const Vector3 normal = section_direction_of_view(skin(), skin().sections[1]);
  const SkinSection before = skin().sections[1];
  press({"G"});
  bench_.move(620, 310);
  bench_.move(640, 300);
  press({"Enter"});
  const SkinSection& after = skin().sections[1];
  const Vector3 way = after.points[0].position - before.points[0].position;
  EXPECT_GT(way.norm(), 1e-6) << "it did not move";
  EXPECT_LT(std::abs(way.dot(normal)), 1e-9 * way.norm());
  for (int i = 0; i < before.size(); ++i)
    EXPECT_LT((after.points[std::size_t(i)].position - before.points[std::size_t(i)].position - way).norm(),
              1e-9 * way.norm());
}

TEST_F(SectionHands, AQuarterTurnIsAboutTheNormal) {
  select_sections({1});
  const Vector3 normal = section_direction_of_view(skin(), skin().sections[1]);
  const SkinSection before = skin().sections[1];
  press({"R", "9", "0", "Enter"});
  const SkinSection& after = skin().sections[1];
  const Vector3 centre = middle(before);
  for (int i = 0; i < before.size(); ++i) {
    const Vector3 a = before.points[std::size_t(i)].position - centre,
                  b = after.points[std::size_t(i)].position - centre;
    EXPECT_NEAR(a.dot(normal), b.dot(normal), 1e-9 * (1 + a.norm()));
    EXPECT_NEAR(a.norm(), b.norm(), 1e-9 * (1 + a.norm()));
    const Vector3 flat = a - a.dot(normal) * normal;
    EXPECT_NEAR(flat.dot(b), 0, 1e-9 * (1 + a.squaredNorm())) << "no quarter";
  }
}

TEST_F(SectionHands, ThePanelFoldsToWhatIsNeededFirst) {
  const auto& marks = bench_.workbench().marks().all();
  bench_.frame();
  for (const char* row : {"combo.skin_method", "check.skin_closed", "combo.skin_frame", "section.skin_more"})
    EXPECT_TRUE(marks.contains(row)) << row;
  EXPECT_FALSE(marks.contains("combo.skin_fit"));
  EXPECT_FALSE(marks.contains("button.skin_turn")) << "one click makes a twisted tube";
  bench_.workbench().commands().run("property.skin_fit");
  for (int i = 0; i < 4; ++i) bench_.frame();
  EXPECT_TRUE(marks.contains("combo.skin_fit")) << "what is asked for by name comes into sight";
}

TEST_F(SectionHands, ThePaletteMakesTwoRails) {
  ASSERT_TRUE(bench_.workbench().commands().run("property.skin_frame.3").ran);
  EXPECT_EQ(skin().frame, FrameMode::two_rail);
  EXPECT_TRUE(skin().second_rail);
}

/// A drawing begins with a circle of a typed size, an ellipse, or the section that is there.
TEST_F(SectionHands, ASectionIsDrawnFromAShapeAndNumbers) {
  // Shapes are closed, and so are all sections of a skin or none.
  bench_.workbench().commands().run("skin.close_sections");
  bench_.wait_for_surfaces();
  const std::size_t count = skin().sections.size();
  bench_.workbench().commands().run("skin.draw_section");
  const auto& marks = bench_.workbench().marks().all();
  // A place of the path that can be clicked: half way between two of its points.
  ASSERT_TRUE(marks.contains("skin.path.0") && marks.contains("skin.path.1"));
  const Marks::Rect a = marks.at("skin.path.0"), b = marks.at("skin.path.1");
  bench_.move((a.x + b.x + a.width) / 2.0, (a.y + b.y + a.height) / 2.0);
  bench_.press();
  bench_.release();
  for (int i = 0; i < 20; ++i) bench_.frame();
  press({"E", "4", "0", "Tab", "2", "0", "Enter"});
  press({"Enter"});
  ASSERT_EQ(skin().sections.size(), count + 1) << bench_.workbench().viewport().hint();
  const SkinSection* drawn = nullptr;
  for (const SkinSection& section : skin().sections)
    if (section.size() == 8) drawn = &section;
  ASSERT_NE(drawn, nullptr);
  const Matrix3 axes = upright_axes(section_direction_of_view(skin(), *drawn));
  Box3 box;
  for (const Vector3& p : limit_points(drawn->curve())) box.extend(Vector3(axes.transpose() * p));
  EXPECT_NEAR(box.sizes().x(), 40, 0.4);
  EXPECT_NEAR(box.sizes().y(), 20, 0.4);
}

TEST_F(SectionHands, CirclesRectanglesAndTheNearestSectionCanBeBegunWith) {
  bench_.workbench().commands().run("skin.close_sections");
  bench_.wait_for_surfaces();
  const auto& marks = bench_.workbench().marks().all();
  const Skin before = skin();
  const auto drawn = [&](std::initializer_list<const char*> keys) {
    bench_.workbench().commands().run("skin.draw_section");
    for (int i = 0; i < 20; ++i) bench_.frame();  // the view has flown back
    const Marks::Rect a = marks.at("skin.path.0"), b = marks.at("skin.path.1");
    bench_.move((a.x + b.x + a.width) / 2.0, (a.y + b.y + a.height) / 2.0);
    bench_.press();
    bench_.release();
    for (int i = 0; i < 20; ++i) bench_.frame();
    press(keys);
    press({"Enter"});
    EXPECT_EQ(skin().sections.size(), before.sections.size() + 1) << bench_.workbench().viewport().hint();
    SkinSection out;
    for (const SkinSection& section : skin().sections)
      if (std::none_of(before.sections.begin(), before.sections.end(),
                       [&](const SkinSection& old) { return old.v == section.v; }))
        out = section;
    return out;
  };
  const auto sizes = [&](const SkinSection& section) -> Vector3 {
    const Matrix3 axes = upright_axes(section_direction_of_view(skin(), section));
    Box3 box;
    for (const Vector3& p : limit_points(section.curve())) box.extend(Vector3(axes.transpose() * p));
    return box.sizes();
  };
  const auto undo = [&] {
    editor().undo();
    bench_.wait_for_surfaces();
  };

  const SkinSection circle = drawn({"O", "4", "0", "Enter"});
  EXPECT_NEAR(sizes(circle).x(), 40, 0.4);
  EXPECT_NEAR(sizes(circle).y(), 40, 0.4);
  undo();
  const SkinSection rectangle = drawn({"R", "4", "0", "Tab", "2", "0", "Enter"});
  EXPECT_NEAR(sizes(rectangle).x(), 40, 0.01);
  EXPECT_NEAR(sizes(rectangle).y(), 20, 0.01);
  EXPECT_EQ(std::count_if(rectangle.points.begin(), rectangle.points.end(),
                          [](const SectionPoint& point) { return point.sharp; }),
            4);
  undo();
  // Distances between all points, whichever of them is the first.
  const auto distances = [](const SkinSection& section) {
    std::vector<double> out;
    for (const SectionPoint& a : section.points)
      for (const SectionPoint& b : section.points) out.push_back((a.position - b.position).norm());
    std::sort(out.begin(), out.end());
    return out;
  };
  const std::vector<double> nearest = distances(before.sections.front()), like = distances(drawn({"N"}));
  ASSERT_EQ(like.size(), nearest.size());
  for (std::size_t i = 0; i < like.size(); ++i) EXPECT_NEAR(like[i], nearest[i], 1e-6 * (1 + nearest[i]));
}

/// A skin that is drawn from nothing, in an empty view.
class DrawnSkin : public BenchHands {
 protected:
  DrawnSkin() : BenchHands(Document(), {1280, 800}) {}
  void click(const Vector2& at) {
    BenchHands::click(at);
    frames(2);
  }
  void press(std::initializer_list<const char*> keys) {
    BenchHands::press(keys);
    frames(20);  // and the flight of the view
  }
  /// Corners of what is drawn over the view in a colour with this opacity.
  static std::size_t drawn(ImU32 colour, float alpha) {
    std::size_t count = 0;
    const ImDrawData* data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; ++i)
      for (const ImDrawVert& vertex : data->CmdLists[i]->VtxBuffer)
        count += vertex.col == with_alpha(colour, alpha) ? 1 : 0;
    return count;
  }
};

TEST_F(DrawnSkin, ThePlaneOfASectionHasAGridAxesAndLengthsAndPointsNearAnAxisLieOnIt) {
  frames(10);
  const std::vector<Vector3> path{{-80, -20, 0}, {0, 20, 0}, {80, -20, 0}};
  bench_.workbench().commands().run("skin.draw");
  for (const Vector3& at : path) click(pixel(at));
  EXPECT_EQ(drawn(palette().dim_text, 0.16F), 0U) << "the ground has its own grid";
  press({"Enter"});
  EXPECT_GT(drawn(palette().dim_text, 0.16F), 200U) << "no grid";
  EXPECT_GT(drawn(palette().dim_text, 0.45F), 8U) << "no stronger lines";
  // The path runs away from the eye: nearly a point or a bar.
  EXPECT_GT(drawn(palette().secondary, 0.3F), 0U);
  const Vector2 middle = pixel(path.front());
  for (const Vector2& way : {Vector2(120, 3), Vector2(-3, -90), Vector2(-120, -2), Vector2(2, 90)})
    click(middle + way);
  press({"C", "Enter"});
  press({"E", "4", "0", "Tab", "2", "0", "Enter"});
  press({"Enter"});
  ASSERT_TRUE(editor().active_object() && editor().active_object()->skin())
      << bench_.workbench().viewport().hint();
  const SkinSection& section = editor().active_object()->skin()->skin->sections.front();
  ASSERT_EQ(section.size(), 4);
  const Skin& skin = *editor().active_object()->skin()->skin;
  const Matrix3 axes = upright_axes(section_direction_of_view(skin, section));
  const Vector3 start = limit_points(skin.path).front();  // clicks hit whole pixels
  for (const Vector3& p : limit_points(section.curve())) {
    const Vector3 local = axes.transpose() * (p - start);
    EXPECT_LT(std::min(std::abs(local.x()), std::abs(local.y())), 1e-6) << local.transpose();
    EXPECT_GT(local.norm(), 5) << local.transpose();
  }
}

}  // namespace
}  // namespace hariko::test

// The Gauss sphere beside the model, by hand: sites step by step, points and sites lit and chosen in both,
// turned together, followed while a normal is dragged.

#include <set>

#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

class SphereByHand : public ::testing::Test, protected ProgramHands {
 protected:
  SphereByHand() : ProgramHands(Begin::start_page, std::make_shared<TemporaryFolder>(), {1400, 850}) {}
  void SetUp() override {
    open_sample("ellipsoid_cap");
    ASSERT_TRUE(editor().active_object() && editor().active_object()->outline()) << notice();
    menu("Outline", "outline.sphere");
    wait();
    ASSERT_TRUE(marks().contains("gauss.view"));
    ASSERT_FALSE(sites().empty());
  }
  /// Points of the outline, which come before the sites inside.
  int given() { return int(editor().active_object()->outline()->outline->point_count()); }
  /// Numbers of the sites on the near side of the sphere.
  std::set<int> sites() {
    const std::string beginning = "gauss.site.";
    std::set<int> out;
    for (const std::string& mark : marks_of(beginning)) out.insert(std::stoi(mark.substr(beginning.size())));
    return out;
  }
  int last_site() {
    wait();
    return sites().empty() ? -1 : *sites().rbegin();
  }
  Vector2 site(int number) { return middle_of("gauss.site." + std::to_string(number)); }
  void point_at(const Vector2& at) {
    bench().move(at.x(), at.y());
    frames(4);
  }
};

TEST_F(SphereByHand, SitesComeStepByStep) {
  const std::set<int> whole = sites();
  EXPECT_GT(*whole.rbegin(), given() + 20) << "few sites inside";
  const Marks::Rect slider = marks().at("gauss.step");
  const double right = slider.x + slider.width, middle = slider.y + slider.height / 2.0;
  drag({right - 6, middle}, {slider.x - 20.0, middle});
  EXPECT_LT(last_site(), given()) << "not the image of the outline alone";
  for (int i = 0; i < 3; ++i) click("gauss.forward");
  EXPECT_EQ(last_site(), given() + 2);
  for (int i = 0; i < 9; ++i) click("gauss.forward");
  EXPECT_EQ(last_site(), given() + 11);
  click("gauss.back");
  EXPECT_EQ(last_site(), given() + 10);
  drag({slider.x + slider.width / 3.0, middle}, {right + 20, middle});
  wait();
  EXPECT_EQ(sites(), whole);
}

TEST_F(SphereByHand, SitesAndPlacesOfTheModelLightUpTogether) {
  point_at(site(*sites().rbegin()));
  EXPECT_TRUE(marks().contains("gauss.hovered")) << "no site is lit";
  // A point of the outline is one of its document.
  ASSERT_LT(*sites().begin(), given());
  click(site(*sites().begin()));
  wait();
  EXPECT_EQ(selected(), "1 point");
  press({"Esc"});
  point_at(in_view(0.5, 0.5));
  EXPECT_TRUE(marks().contains("gauss.hovered")) << "not the site of the surface's normal";
  const Marks::Rect view = marks().at("view.0");
  point_at({view.x + 20.0, view.y + view.height - 20.0});
  EXPECT_FALSE(marks().contains("gauss.hovered"));
}

TEST_F(SphereByHand, ItsBarsHaveRoomInASmallWindow) {
  ImGui::GetIO().DisplaySize = {800, 600};
  wait();
  const Marks::Rect view = marks().at("gauss.view");
  for (const char* mark : {"gauss.triangles", "gauss.close", "gauss.step"}) {
    const Marks::Rect rect = marks().at(mark);
    EXPECT_GE(rect.x, view.x) << mark;
    EXPECT_LE(rect.x + rect.width, view.x + view.width) << mark;
  }
  click("gauss.close");
  EXPECT_FALSE(marks().contains("gauss.view"));
}

TEST_F(SphereByHand, TheViewTurnsWithTheSphere) {
  const Vector2 before = middle_of("outline.point.0");
  const Marks::Rect view = marks().at("gauss.view");
  const Vector2 from(view.x + view.width / 2.0, view.y + view.height - 25.0);
  drag(from, from + Vector2(60, -20));
  wait();
  EXPECT_GT((middle_of("outline.point.0") - before).norm(), 1) << "the view did not turn";
}

TEST_F(SphereByHand, SitesFollowADraggedNormalAndTheSphereCloses) {
  int number = -1;
  for (const int one : sites())
    if (number < 0 && marks().contains("outline.normal." + std::to_string(one))) number = one;
  ASSERT_GE(number, 0);
  const std::string mark = "gauss.site." + std::to_string(number);
  const Vector2 before = middle_of(mark), arrow = middle_of("outline.normal." + std::to_string(number));
  begin_drag(arrow, arrow + Vector2(7, -9));
  wait();
  EXPECT_TRUE(!marks().contains(mark) || (middle_of(mark) - before).norm() > 0.5) << "the site stays";
  bench().release();
  wait_for_step(1, "Turn normal");
  press({"Ctrl+Z"});
  wait();
  ASSERT_TRUE(marks().contains(mark));
  EXPECT_LT((middle_of(mark) - before).norm(), 1) << "undo did not put the site back";
  click("gauss.close");
  EXPECT_FALSE(marks().contains("gauss.view"));
}

}  // namespace
}  // namespace hariko::test

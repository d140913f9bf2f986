// A paper model by hand: unfolded, made finer, split and joined by clicks, moved and turned, folded up,
// changed with its model, written, saved and opened again; and meshes that cannot be unfolded.

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/polyhedron/validation.hpp"
#include "core/unfolding/facet_graph.hpp"
#include "tests/workbench/paper_rig.hpp"

namespace hariko::test {
namespace {

/// The surface round a cube of 2 mm, on pages after two steps.
class PaperOfACube : public OnPaper {
 protected:
  void SetUp() override {
    open_copy("tests/golden/cube.obj");
    press({"Ctrl+P"});
    wait();
    ASSERT_TRUE(editor().paper.shown);
    set_tolerance("0.08");
    expect_step(1, "Tolerance of the paper model");
    click("paper.unfold");
    wait();
    expect_step(2, "Unfold");
    ASSERT_TRUE(editor().paper.layout) << notice();
    EXPECT_TRUE(sound());
    found_ = places();
  }
  void set_tolerance(const char* text) {
    enter("paper_distance", text);
    wait();
  }
  void undo(int steps = 1) {
    for (int i = 0; i < steps; ++i) press({"Ctrl+Z"});
    wait();
  }
  /// No piece lies on another or beyond the margins.
  bool sound() { return pages().overlaps == 0 && pages().off_page.empty(); }

  std::vector<std::array<double, 4>> found_;  ///< places of the pieces that the search found
};

TEST_F(PaperOfACube, ALargerToleranceHasFewerFacetsAndUndoGivesThePagesBack) {
  const std::size_t fine = facets(), fine_pieces = pieces();
  set_tolerance("0.2");
  expect_step(3, "Tolerance of the paper model");
  ASSERT_TRUE(editor().paper.layout);
  EXPECT_LT(facets(), fine);
  undo();
  ASSERT_TRUE(editor().paper.layout);
  EXPECT_EQ(facets(), fine);
  EXPECT_EQ(pieces(), fine_pieces);
  EXPECT_EQ(places(), found_);
}

/// Half as many are about twice as far off.
TEST_F(PaperOfACube, FewerFacetsAreAskedForByTheirNumber) {
  const std::size_t fine = facets();
  ASSERT_GE(fine, 20U);
  const double distance = editor().document().paper->distance;
  enter("paper_count", std::to_string(fine / 2));
  wait();
  expect_step(3, "Tolerance of the paper model");
  EXPECT_GT(editor().document().paper->distance, 1.5 * distance);
  ASSERT_TRUE(editor().paper.layout);
  EXPECT_LT(facets(), fine);
}

TEST_F(PaperOfACube, AClickOnAFoldSplitsAndOneOnTheCutJoins) {
  const std::size_t whole = pieces(), joints = pages().unfolding.joints.size();
  const Index edge = lonely_fold();
  ASSERT_NE(edge, no_index) << "no fold can be seen";
  click("paper.folded." + std::to_string(edge));
  wait();
  expect_step(3, "Split at an edge");
  EXPECT_EQ(pieces(), whole + 1);
  EXPECT_EQ(pages().unfolding.joints.size(), joints + 1);
  click("paper.cut." + std::to_string(edge));
  wait();
  expect_step(4, "Join at an edge");
  EXPECT_EQ(pieces(), whole);
  undo();
  EXPECT_EQ(pieces(), whole + 1);
  undo();
  EXPECT_EQ(places(), found_);
}

TEST_F(PaperOfACube, AClickPutsATabOnTheOtherSideAndACommandShowsAllPagesAgain) {
  // Tabs are small: the wheel brings one closer.
  const auto tabs = marked("tab");
  ASSERT_FALSE(tabs.empty());
  const auto page_width = [this] { return marks().at("paper.page.0").width; };
  const int usual = page_width();
  const Vector2 tab = tabs.begin()->second;
  bench().move(tab.x(), tab.y());
  for (int i = 0; i < 12; ++i) wheel(1);
  frames(2);
  EXPECT_GT(page_width(), 4 * usual);
  for (const auto& [edge, at] : marked("tab")) {
    if (editor().history.undo_label() != "Unfold") break;
    click(at);  // refused where there is no room for it
  }
  wait();
  expect_step(3, "Side of a tab");
  undo();
  expect_step(2, "Unfold");
  bench().from_palette("All pages", "paper.frame");
  wait();
  EXPECT_EQ(page_width(), usual);
  EXPECT_EQ(marked("piece").size(), pieces());
}

TEST_F(PaperOfACube, PiecesAreMovedTurnedStraightenedAndArranged) {
  const Vector2 piece = middle_of("paper.piece.0");
  drag(piece, piece + Vector2(30, 24));
  wait();
  expect_step(3, "Move a piece");
  EXPECT_NE(places(), found_);
  EXPECT_EQ(editor().paper.selected_piece(), 0U);
  const Vector2 handle = middle_of("paper.handle");
  drag(handle, handle + Vector2(70, 40));
  wait();
  expect_step(4, "Turn a piece");
  click("paper.straighten");
  wait();
  expect_step(5, "Straighten a piece");
  click("paper.arrange");
  wait();
  expect_step(6, "Arrange the pages");
  EXPECT_TRUE(sound());
  undo(4);
  EXPECT_EQ(places(), found_);
}

TEST_F(PaperOfACube, ThePagesStayInViewInASmallWindowUntilTheyAreMoved) {
  ASSERT_EQ(marked("piece").size(), pieces());
  ImGui::GetIO().DisplaySize = {800, 600};
  wait();
  EXPECT_EQ(marked("piece").size(), pieces());
  const Marks::Rect view = marks().at("paper.view");
  for (const char* mark : {"paper.unfold", "paper.arrange", "paper.fold", "paper.in_space"}) {
    const Marks::Rect rect = marks().at(mark);
    EXPECT_GE(rect.x, view.x) << mark;
    EXPECT_LE(rect.x + rect.width, view.x + view.width) << mark;
  }
  const Vector2 middle(view.x + view.width / 2.0, view.y + view.height / 2.0);
  bench().move(middle.x(), middle.y());
  wheel(2);
  const int width = marks().at("paper.page.0").width;
  ImGui::GetIO().DisplaySize = {1440, 900};
  wait();
  EXPECT_EQ(marks().at("paper.page.0").width, width) << "what was zoomed was framed anew";
}

TEST_F(PaperOfACube, EscPutsAPieceBack) {
  const Vector2 piece = middle_of("paper.piece.0");
  begin_drag(piece, piece + Vector2(40, 40));
  EXPECT_NE(places(), found_) << "the piece is not in the hand";
  press({"Esc"});
  bench().release();
  wait();
  EXPECT_EQ(places(), found_);
  expect_step(2, "Unfold");
}

TEST_F(PaperOfACube, BothViewsKnowTheFacetUnderThePointerAndTheSliderFolds) {
  const auto point_at = [this](const char* mark) {
    const Vector2 at = middle_of(mark);
    bench().move(at.x(), at.y());
    frames(3);
    return editor().paper.hovered.facet;
  };
  EXPECT_NE(point_at("paper.piece.0"), no_index) << "on paper";
  EXPECT_EQ(point_at("menu.Paper"), no_index) << "beside both";
  EXPECT_NE(point_at("view.0"), no_index) << "in space";

  const Marks::Rect slider = marks().at("paper.fold");
  const double height = slider.y + slider.height / 2.0;
  const Vector2 middle(slider.x + 0.45 * slider.width, height);
  drag({slider.x + slider.width - 6.0, height}, middle);
  EXPECT_GT(editor().paper.folded, 0.3F);
  EXPECT_LT(editor().paper.folded, 0.6F);
  drag(middle, {slider.x + slider.width + 30.0, height});
  EXPECT_EQ(editor().paper.folded, 1.0F) << "not the solid";
  expect_step(2, "Unfold");
}

/// Facets that are still there keep their cuts.
TEST_F(PaperOfACube, ThePagesFollowTheModel) {
  const std::size_t before = facets();
  click("paper.in_space");
  wait();
  EXPECT_FALSE(editor().paper.in_space);
  press({"1"});
  const Vector2 corner = nearest_corner();
  drag(corner, corner + Vector2(16, -16));
  wait();
  expect_step(3, "Move vertex");
  EXPECT_FALSE(editor().paper.fault.has_value());
  ASSERT_TRUE(editor().paper.layout);
  EXPECT_FALSE(editor().paper.pending);
  EXPECT_GT(facets(), 0U);
  EXPECT_TRUE(places() != found_ || facets() == before) << "the pages did not follow";
  undo();
  EXPECT_EQ(places(), found_);
}

TEST_F(PaperOfACube, ThePagesAreWrittenInEveryFormatAndComeBackFromTheDocument) {
  for (const char* ending : {"pdf", "svg", "dxf", "png"}) {
    click("paper.export");
    name_file(std::string("pages.") + ending);
    wait();
  }
  std::size_t drawn = 0;
  const std::string facet = "class=\"face\"";
  for (const auto& file : std::filesystem::directory_iterator(folder())) {  // one file a page
    if (file.path().extension() != ".svg") continue;
    const std::string text = slurp(file.path());
    for (std::size_t at = text.find(facet); at != std::string::npos; at = text.find(facet, at + 1)) ++drawn;
  }
  EXPECT_EQ(drawn, facets());
  EXPECT_TRUE(slurp(folder() / "pages.pdf").starts_with("%PDF-1.4"));
  EXPECT_TRUE(slurp(folder() / "pages.dxf").starts_with("0\nSECTION"));
  EXPECT_TRUE(slurp(folder() / "pages.png").starts_with("\x89PNG"));

  press({"Ctrl+S"});
  name_file("a.hariko");
  wait();
  EXPECT_FALSE(editor().history.dirty()) << notice();
  session().open(folder() / "cube.obj");
  wait();
  EXPECT_FALSE(editor().paper.layout);
  session().open(folder() / "a.hariko");
  wait();
  ASSERT_TRUE(editor().paper.layout);
  EXPECT_EQ(places(), found_);
}

class RefusedOnPaper : public OnPaper {
 protected:
  void open_text(const char* name, const char* text) {
    spill(folder() / name, text);
    session().open(folder() / name);
    wait();
  }
  /// The message tells what is wrong; what it names is outlined.
  void expect_refusal(Code code) {
    click("paper.unfold");
    wait();
    ASSERT_TRUE(editor().paper.fault.has_value());
    EXPECT_EQ(editor().paper.fault->messages.front().code, code) << notice();
    EXPECT_FALSE(editor().paper.fault->lines.empty());
    EXPECT_FALSE(notice().empty());
    EXPECT_NE(editor().history.undo_label(), "Unfold");
    EXPECT_FALSE(editor().paper.layout);
  }
};

/// Four corners on one line: no triangle that opening leaves out.
TEST_F(RefusedOnPaper, AFaceWithoutAnArea) {
  open_text("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 3 0 0\nf 1 2 3 5\nf 1 5 4\n");
  press({"Ctrl+P"});
  wait();
  choose("paper_facets", 1);
  wait();
  ASSERT_TRUE(editor().document().paper);
  EXPECT_TRUE(editor().document().paper->of_polyhedra);
  expect_refusal(e_facet_degenerate);
}

TEST_F(RefusedOnPaper, ThreeFacetsOnOneEdge) {
  open_text("three.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
  click("prompt.reference");
  wait();
  press({"Ctrl+P"});
  wait();
  expect_refusal(e_edge_nonmanifold_or_flipped);
}

/// It would take minutes.
TEST_F(OnPaper, ASearchThatIsStoppedLeavesTheDocument) {
  open_copy("tests/golden/car.obj");
  press({"Ctrl+P"});
  wait();
  ASSERT_TRUE(bench().workbench().commands().run("property.paper_steps").ran);
  frames(10);
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  type("100000000");
  press({"Enter"});
  wait();
  ASSERT_EQ(editor().history.undo_label(), "Effort of the search");
  EXPECT_EQ(editor().document().paper->steps, 100'000'000U);
  click("paper.unfold");
  frames(2);
  click("status.cancel_job");
  wait();
  EXPECT_EQ(editor().history.position(), 1U);
  EXPECT_FALSE(editor().paper.layout);
}

}  // namespace
}  // namespace hariko::test

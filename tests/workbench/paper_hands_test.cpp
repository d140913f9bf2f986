// Pages that cannot be built are told before they are written.

#include <imgui_internal.h>

#include <cstdlib>

#include "core/document/edits/edits.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "core/unfolding/edit_unfolding.hpp"
#include "tests/workbench/headless_workbench.hpp"
#include "ui/editor/object_size.hpp"
#include "ui/editor/paper_edits.hpp"
#include "ui/paper/paper_drawing.hpp"

namespace hariko::test {
namespace {

class PaperHands : public ::testing::Test {
 protected:
  PaperHands() : bench_(box(), {1280, 800}) {
    const PolygonMesh mesh = make_primitive(BoxShape{{40, 50, 60}, {1, 1, 1}, {}}).value();
    auto facets = std::make_shared<PaperFacets>();
    facets->mesh = mesh;
    auto paper = std::make_shared<PaperMesh>();
    paper->graph = std::make_shared<const FacetGraph>(FacetGraph::build(mesh).value());
    paper->whole = facets;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
      paper->names.push_back({ObjectId{0}, {}, v, 0, 0});
    mesh_ = paper;
    show(unfold(paper->graph, PaperSettings(), {.steps = 500}).value());
  }
  static Document box() {
    return document_from_mesh(make_primitive(BoxShape{{40, 50, 60}, {1, 1, 1}, {}}).value(), "Box").value();
  }
  void show(const Unfolding& unfolding) {
    Editor& editor = bench_.editor();
    editor.paper.shown = true;
    editor.paper.mesh = mesh_;
    editor.paper.layout =
        lay_out_paper(std::make_shared<const PaperModel>(default_paper(editor.document())), mesh_, unfolding);
    bench_.frame();
  }
  const Unfolding& pages() { return bench_.editor().paper.layout->unfolding; }
  bool asked() {
    bench_.workbench().commands().run("paper.export");
    for (int i = 0; i < 3; ++i) bench_.frame();
    return bench_.workbench().question() != nullptr;
  }
  bool dialog() { return bench_.workbench().marks().all().contains("dialog.name"); }

  std::shared_ptr<const PaperMesh> mesh_;
  HeadlessWorkbench bench_;
};

TEST_F(PaperHands, SoundPagesAreWrittenAtOnce) {
  EXPECT_FALSE(asked());
  EXPECT_TRUE(dialog());
}

TEST_F(PaperHands, APieceBeyondTheMarginIsToldAndCanBeRefused) {
  show(move_piece(pages(), 0, 0, {150, 0}));
  ASSERT_FALSE(bench_.editor().paper.layout->off_page.empty());
  ASSERT_TRUE(asked());
  EXPECT_FALSE(dialog());
  // Enter goes back to the pages.
  bench_.tap("Enter");
  for (int i = 0; i < 3; ++i) bench_.frame();
  EXPECT_FALSE(dialog());
  EXPECT_EQ(bench_.workbench().question(), nullptr);
  ASSERT_TRUE(asked());
  bench_.click("prompt.export");
  for (int i = 0; i < 3; ++i) bench_.frame();
  EXPECT_TRUE(dialog());
}

TEST_F(PaperHands, PiecesOverEachOtherAreToldAndCanBeArranged) {
  Index fold = no_index;
  for (Index e = 0; e < pages().graph->edge_count() && fold == no_index; ++e)
    if (!pages().graph->edge(e).border() && !pages().graph->edge(e).inner && pages().folds[e]) fold = e;
  ASSERT_NE(fold, no_index);
  show(split_at(pages(), fold).value());
  const PaperLayout& split = *bench_.editor().paper.layout;
  ASSERT_GE(pages().pieces.size(), 2U);
  const PieceBox a = box_of(split, 0), b = box_of(split, 1);
  show(move_piece(pages(), 1, a.page, (a.low + a.high - b.low - b.high) / 2));
  ASSERT_GT(bench_.editor().paper.layout->overlaps, 0U);
  ASSERT_TRUE(asked());
  EXPECT_FALSE(dialog());
  EXPECT_NE(bench_.workbench().question()->text.find("overlaps: "), std::string::npos)
      << bench_.workbench().question()->text;
  bench_.click("prompt.arrange");
  for (int i = 0; i < 3; ++i) bench_.frame();
  EXPECT_FALSE(dialog()) << "one looks at the pages first";
  EXPECT_EQ(bench_.editor().paper.layout->overlaps, 0U);
  EXPECT_FALSE(asked());
  EXPECT_TRUE(dialog());
}

/// It was that of the polyhedron before the pages were made, and that of the facets behind.
TEST_F(PaperHands, TheSizeIsThatOfTheSurfaceBeforeAndBehind) {
  Editor& editor = bench_.editor();
  const ObjectId box = editor.document().objects.front()->id;
  editor.commit(set_mode(editor.history.current(), box, Mode::fair), "Mode");
  Similarity turned;
  turned.rotation = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized());
  editor.commit(set_transform(editor.history.current(), box, turned), "Turn");
  editor.paper.mesh.reset();
  editor.paper.layout.reset();
  bench_.wait_for_surfaces();
  const auto sizes = [&] {
    for (int i = 0; i < 4; ++i) bench_.frame();
    std::vector<std::string> out;
    for (const char* field : {"paper_width", "paper_depth", "paper_height"}) {
      bench_.click(std::string("field.") + field);
      bench_.frame();
      out.emplace_back(ImGui::GetInputTextState(ImGui::GetActiveID())->TextA.Data);
      bench_.tap("Esc");
    }
    return out;
  };
  const std::vector<std::string> before = sizes();
  editor.paper.mesh = mesh_;
  editor.paper.layout = lay_out_paper(std::make_shared<const PaperModel>(default_paper(editor.document())),
                                      mesh_, unfold(mesh_->graph, PaperSettings(), {.steps = 500}).value());
  EXPECT_EQ(sizes(), before);
  Box3 surface = shown_box(editor, *editor.active_object());
  const double width = std::strtod(before[0].c_str(), nullptr);
  EXPECT_NEAR(width, surface.sizes().x(), 1e-2 * width);
}

TEST_F(PaperHands, OtherPagesEndTheDragOfAPiece) {
  Editor& editor = bench_.editor();
  const Unfolding whole = pages();
  const std::size_t pieces = whole.pieces.size();
  Index fold = no_index;
  for (Index e = 0; e < whole.graph->edge_count() && fold == no_index; ++e)
    if (!whole.graph->edge(e).border() && !whole.graph->edge(e).inner && whole.folds[e]) fold = e;
  ASSERT_NE(fold, no_index);
  show(split_at(whole, fold).value());
  ASSERT_EQ(pages().pieces.size(), pieces + 1);
  const Marks::Rect at = bench_.workbench().marks().all().at("paper.piece." + std::to_string(pieces));
  bench_.move(at.x + 1, at.y + 1);
  bench_.press();
  bench_.move(at.x + 30, at.y + 20);
  ASSERT_TRUE(editor.paper.dragged);
  const std::size_t steps = editor.history.position();
  show(whole);  // as a search does that ends
  EXPECT_FALSE(editor.paper.dragged) << "of pages that are gone";
  bench_.move(at.x + 50, at.y + 30);
  bench_.release();
  EXPECT_EQ(editor.history.position(), steps);
  EXPECT_EQ(pages().pieces.size(), pieces);
}

TEST_F(PaperHands, ASplitPieceMovesAside) {
  Index fold = no_index;
  for (Index e = 0; e < pages().graph->edge_count() && fold == no_index; ++e)
    if (!pages().graph->edge(e).border() && !pages().graph->edge(e).inner && pages().folds[e]) fold = e;
  ASSERT_NE(fold, no_index);
  const std::size_t pieces = pages().pieces.size();
  toggle_edge(bench_.editor(), fold);
  EXPECT_EQ(pages().pieces.size(), pieces + 1);
  EXPECT_EQ(bench_.editor().paper.layout->overlaps, 0U);
  EXPECT_TRUE(bench_.editor().paper.layout->off_page.empty());
}

}  // namespace
}  // namespace hariko::test

// Small things of every day: places of commands, units, views that come back, files, dialogs that fit.

#include <imgui_internal.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "app/pictures/file_pictures.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "core/document/file.hpp"
#include "tests/support/places.hpp"
#include "tests/workbench/bench_hands.hpp"
#include "ui/editor/command_table.hpp"
#include "ui/files/export_text.hpp"

namespace hariko::test {
namespace {

Document sample_of(const char* name) {
  return load_document(test::source_folder() + "/assets/samples/" + name + ".hariko").value();
}

class Everyday : public test::BenchHands {
 protected:
  explicit Everyday(Document document = test::box()) : BenchHands(std::move(document), {1280, 800}) {}
  void frames(int count = 6) {
    for (int i = 0; i < count; ++i) bench_.frame();
  }
  void run(const char* id) {
    const auto outcome = bench_.workbench().commands().run(id);
    ASSERT_TRUE(outcome.ran) << id << ": " << outcome.reason;
    frames();
  }
};

TEST_F(Everyday, ANewBoxStandsBesideANewDocumentAndQuitComesLast) {
  std::vector<std::string> ids;
  for (const MenuNode& node : menu_tree(bench_.workbench().commands(), "File"))
    if (node.command) ids.push_back(node.command->id);
  const auto place = [&](const char* id) { return std::find(ids.begin(), ids.end(), id) - ids.begin(); };
  EXPECT_EQ(place("file.new_from_box"), place("file.new") + 1);
  EXPECT_EQ(ids.back(), "file.quit");
}

TEST_F(Everyday, AnExtrudedLengthHasItsUnit) {
  bench_.key("3");
  editor().selection.select({editor().selection.active, element_of(FaceId{0})}, Selection::How::replace);
  frames();
  bench_.move(600, 400);
  bench_.key("E");
  bench_.move(640, 360);
  const std::string hint = bench_.workbench().viewport().hint();
  EXPECT_NE(hint.find(" mm "), std::string::npos) << hint;
  bench_.key("Esc");
}

TEST_F(Everyday, AfterAViewFromTheSideTheFreeOneIsInPerspectiveAgain) {
  ASSERT_FALSE(editor().camera().orthographic);
  bench_.key("Num 3");
  frames();
  EXPECT_TRUE(editor().camera().orthographic);
  bench_.key("Num 0");
  frames();
  EXPECT_FALSE(editor().camera().orthographic);
}

TEST_F(Everyday, SomethingNewThatReachesOutOfTheViewIsFramed) {
  bench_.wait_for_surfaces();
  Camera near = editor().camera();
  near.distance /= 8;
  editor().set_camera(near);
  frames();
  run("add.prism");
  const Projector projector(editor().camera(), editor().viewport);
  const Box3 box = world_box(*editor().active_object());
  for (int i = 0; i < 8; ++i) {
    const auto at = projector.project(box.corner(Box3::CornerType(i)));
    ASSERT_TRUE(at);
    EXPECT_GE(at->x(), 0);
    EXPECT_LE(at->x(), editor().viewport.width);
    EXPECT_GE(at->y(), 0);
    EXPECT_LE(at->y(), editor().viewport.height);
  }
  // Objects that can be seen whole leave the view alone.
  const Camera before = editor().camera();
  run("add.box");
  EXPECT_EQ(editor().camera().distance, before.distance);
}

/// Whatever side one looks from, a handle that is shown is taken where it is shown.
TEST_F(Everyday, HandlesOfTheGizmoDoNotCoverEachOther) {
  bench_.key("Ctrl+A");
  std::size_t handles = 0;
  for (const auto& [x, y] : {std::pair(0.0, 0.0),
                             {0.4, 0.1},
                             {0.8, -0.2},
                             {1.5, 0.3},
                             {2.2, -0.4},
                             {0.3, 0.6},
                             {-0.7, 0.45},
                             {3.0, 0.2}}) {
    editor().set_camera(Camera::standard(StandardView::iso).orbit(x, y));
    run("view.frame_all");
    bench_.move(640, 790);
    std::vector<std::pair<std::string, Marks::Rect>> shown;
    for (const auto& [mark, rect] : marks())
      if (mark.starts_with("gizmo.")) shown.emplace_back(mark, rect);
    for (const auto& [mark, rect] : shown) {
      SCOPED_TRACE(mark);
      bench_.move(rect.x + rect.width / 2.0, rect.y + rect.height / 2.0);
      bench_.press();
      bench_.release();
      const std::string hint = bench_.workbench().viewport().hint();
      const bool moves = mark.starts_with("gizmo.move."), turns = mark.starts_with("gizmo.rotate.");
      EXPECT_TRUE(hint.starts_with(moves ? "Move" : turns ? "Rotate" : "Scale")) << hint;
      for (const char axis : {'x', 'y', 'z'})
        if (moves)
          EXPECT_EQ(mark.substr(11).find(axis) != std::string::npos,
                    hint.substr(0, hint.find("   |   ")).find(char(axis - 'a' + 'A')) != std::string::npos)
              << hint;
      bench_.key("Esc");
      bench_.move(640, 790);
      ++handles;
    }
  }
  EXPECT_GE(handles, 8U * 7U) << "too few of them are shown";
}

TEST_F(Everyday, FilesOfLikeSizesHaveOneKindOfNumber) {
  EXPECT_EQ(file_size_text(0), "0 B");
  EXPECT_EQ(file_size_text(999), "999 B");
  EXPECT_EQ(file_size_text(2357), "2.4 kB");
  EXPECT_EQ(file_size_text(61'234), "61 kB");
  EXPECT_EQ(file_size_text(999'499), "999 kB");
  EXPECT_EQ(file_size_text(999'500), "1.0 MB");
  EXPECT_EQ(file_size_text(4'419'000), "4.4 MB");
  EXPECT_EQ(file_size_text(12'345'678'901), "12 GB");
}

TEST_F(Everyday, NoticesLeaveTheButtonsOfPanelsBesideFree) {
  run("paper.show");
  editor().notify(Notice::Kind::info, std::string(400, 'a'));
  frames();
  ASSERT_TRUE(marks().contains("notice.0"));
  const Marks::Rect notice = marks().at("notice.0"), border = marks().at("paper.border");
  EXPECT_LE(notice.x + notice.width, border.x + border.width);
}

/// Tips of menus covered the next two entries, those of the tool column the next button.
TEST_F(Everyday, TipsOfMenusAndToolsCoverNoOtherEntries) {
  const auto point_at = [&](const std::string& mark, const char* entries) {
    SCOPED_TRACE(mark);
    ASSERT_TRUE(marks().contains(mark));
    const Marks::Rect at = marks().at(mark);
    bench_.move(at.x + at.width / 2.0, at.y + at.height / 2.0);
    frames(4);
    int tips = 0;
    for (const ImGuiWindow* tip : GImGui->Windows) {
      if (!(tip->Flags & ImGuiWindowFlags_Tooltip) || !tip->WasActive || tip->Hidden) continue;
      ++tips;
      EXPECT_GE(tip->Pos.x, 0);
      EXPECT_LE(tip->Pos.x + tip->Size.x, ImGui::GetIO().DisplaySize.x);
      for (const auto& [other, rect] : marks()) {
        if (!other.starts_with(entries)) continue;
        const ImRect entry(float(rect.x), float(rect.y), float(rect.x + rect.width),
                           float(rect.y + rect.height));
        EXPECT_FALSE(tip->Rect().Overlaps(entry)) << "its tip covers " << other;
      }
    }
    EXPECT_EQ(tips, 1);
  };
  for (const float width : {1280.0F, 800.0F}) {
    ImGui::GetIO().DisplaySize = {width, 800};
    frames();
    bench_.click("menu.File");
    frames();
    point_at("command.file.new", "command.");
    bench_.key("Esc");
    bench_.click("menu.Analyse");
    frames();
    point_at("command.analyse.zebra", "command.");
    const Marks::Rect making = marks().at("menu.Making");
    bench_.move(making.x + making.width / 2.0, making.y + making.height / 2.0);
    frames(10);
    point_at("command.analyse.draft", "command.");
    bench_.key("Esc");
    bench_.key("Esc");
    frames();
    point_at("button.select.vertices", "button.select.");
  }
}

/// At 150 % it was gone, although there was room beside a smaller field.
TEST_F(Everyday, TheNameOfTheDocumentStaysInTheBar) {
  for (const auto& [width, scale] : {std::pair(1440.0F, 1.0F), {1440.0F, 1.5F}, {1280.0F, 1.25F}}) {
    SCOPED_TRACE(scale);
    ImGui::GetIO().DisplaySize = {width, 900};
    bench_.set_scale(scale);
    frames();
    ASSERT_TRUE(marks().contains("menu.title"))
        << "from " << marks().at("menu.Help").x << " to " << marks().at("menu.search").x;
    const Marks::Rect title = marks().at("menu.title"), help = marks().at("menu.Help"),
                      search = marks().at("menu.search");
    EXPECT_GE(title.x, help.x + help.width);
    EXPECT_LE(title.x + title.width, search.x);
    EXPECT_GE(title.width, int(20 * scale));
  }
}

/// In a narrow view the legend lay over the names of what the probe tells.
TEST_F(Everyday, TheProbeStandsBesideTheLegend) {
  ImGui::GetIO().DisplaySize = {800, 600};
  bench_.wait_for_surfaces();
  run("view.frame_all");
  run("analyse.mean");
  bench_.wait_for_surfaces();
  frames(20);
  const Marks::Rect view = marks().at("view.0");
  bench_.move(view.x + view.width / 2.0, view.y + view.height / 2.0);
  frames();
  ASSERT_TRUE(marks().contains("probe"));
  const Marks::Rect rect = marks().at("probe");
  const ImRect probe(float(rect.x), float(rect.y), float(rect.x + rect.width), float(rect.y + rect.height));
  EXPECT_GT(probe.GetWidth(), 60) << "the whole box";
  const ImGuiWindow* legend = ImGui::FindWindowByName("##legend");
  ASSERT_TRUE(legend && legend->WasActive);
  EXPECT_FALSE(legend->Rect().Overlaps(probe));
  EXPECT_GE(rect.y, view.y);
}

/// The value of the map stood above that of the surface, which differed in its digits.
TEST_F(Everyday, TheProbeTellsACurvatureOnce) {
  bench_.wait_for_surfaces();
  run("view.frame_all");
  const auto height = [&](const char* map) {
    run(map);
    bench_.wait_for_surfaces();
    const Marks::Rect view = marks().at("view.0");
    bench_.move(view.x + view.width / 2.0, view.y + view.height / 2.0);
    frames();
    return marks().contains("probe") ? marks().at("probe").height : 0;
  };
  const int plain = height("analyse.zebra");
  ASSERT_GT(plain, 0);
  EXPECT_NEAR(height("analyse.gauss"), plain, 2);
  EXPECT_NEAR(height("analyse.k1"), plain, 2);
  EXPECT_GT(height("analyse.mean"), plain + 10);
}

class WithOutline : public Everyday {
 protected:
  WithOutline() : Everyday(sample_of("sphere_cap")) {}
};

TEST_F(WithOutline, APanelThatClosesGivesTheViewItsRoomBack) {
  bench_.wait_for_surfaces();
  run("view.frame_all");
  const double whole = editor().camera().distance;
  for (const char* panel : {"outline.sphere", "paper.show"}) {
    SCOPED_TRACE(panel);
    run(panel);
    EXPECT_GT(editor().camera().distance, 1.01 * whole) << "half of the view would cut the model off";
    run(panel);
    EXPECT_NEAR(editor().camera().distance, whole, 1e-6 * whole);
  }
  // A part that was come close to stays.
  run("outline.sphere");
  Camera near = editor().camera();
  near.distance *= 0.4;
  editor().set_camera(near);
  run("outline.sphere");
  EXPECT_EQ(editor().camera().distance, near.distance);
}

/// The curves between points that were found are no lines of the designer.
TEST_F(WithOutline, TheCurvesOfAFilledOutlineDoNotDarkenItsForm) {
  bench_.wait_for_surfaces();
  run("view.frame_all");
  // Pixels of the view that the curves make darker by a quarter.
  const auto picture = [&](bool network) {
    DisplaySettings display = editor().active_object()->display;
    display.network = network;
    editor().commit(set_display(editor().history.current(), editor().selection.active, display), "Show");
    frames();
    return bench_.renderer().read(0);
  };
  const Image with = picture(true), without = picture(false);
  ASSERT_EQ(with.rgba.size(), without.rgba.size());
  std::size_t darker = 0, changed = 0;
  for (std::size_t i = 0; i < with.rgba.size(); i += 4) {
    darker += with.rgba[i + 1] + 64 < without.rgba[i + 1] ? 1 : 0;
    changed += with.rgba[i + 1] != without.rgba[i + 1] ? 1 : 0;
  }
  EXPECT_GT(changed, 2000U) << "the curves are not there";
  EXPECT_LT(darker, changed / 20) << "of " << changed;
}

/// The command for all surfaces and the row of the properties switch outlines as they do polyhedra.
TEST_F(WithOutline, TheSurfaceFollowsLengthsOrEqualAngles) {
  bench_.wait_for_surfaces();
  const auto point = [&] {
    bench_.wait_for_surfaces();
    const Surface& surface = editor().view_of(editor().selection.active)->surface;
    return surface.patches().evaluate(surface.patch_count() / 2, {0.3, 0.3}, Order::first).position;
  };
  const auto frames_now = [&] { return surface_frames(editor().active_object()->source); };
  ASSERT_EQ(frames_now(), Frames::metric) << "the sample";
  const Vector3 metric = point();
  run("shape.by_measure");
  EXPECT_EQ(frames_now(), Frames::equal);
  const Vector3 equal = point();
  EXPECT_NE(equal, metric);
  run("property.frames");
  bench_.click("check.frames");
  frames();
  EXPECT_EQ(frames_now(), Frames::metric);
  EXPECT_EQ(point(), metric);
  editor().undo();
  EXPECT_EQ(frames_now(), Frames::equal);
  EXPECT_EQ(point(), equal);
}

/// Violet diamonds of pins lay over all vertices, and dark curves between them.
TEST_F(WithOutline, AConvertedOneShowsItsForm) {
  bench_.wait_for_surfaces();
  run("view.frame_all");
  run("outline.convert");
  bench_.wait_for_surfaces();
  frames();
  ASSERT_TRUE(editor().active_object()->polyhedron());
  const auto picture = [&](bool lines) {
    DisplaySettings display = editor().active_object()->display;
    display.network = display.polyhedron = lines;
    editor().commit(set_display(editor().history.current(), editor().selection.active, display), "Show");
    frames();
    return bench_.renderer().read(0);
  };
  const Image with = picture(true), without = picture(false);
  ASSERT_EQ(with.rgba.size(), without.rgba.size());
  std::size_t darker = 0, changed = 0, violet = 0;
  for (std::size_t i = 0; i < with.rgba.size(); i += 4) {
    const std::uint8_t* a = &with.rgba[i];
    darker += a[1] + 64 < without.rgba[i + 1] ? 1 : 0;
    changed += a[1] != without.rgba[i + 1] ? 1 : 0;
    violet += a[0] > a[1] + 30 && a[2] > a[1] + 30 ? 1 : 0;
  }
  EXPECT_GT(changed, 2000U) << "its edges are not there";
  EXPECT_LT(darker, changed / 20) << "of " << changed;
  EXPECT_LT(violet, 20U) << "diamonds";
}

class WithSkin : public Everyday {
 protected:
  WithSkin() : Everyday(sample_of("skin_merge_inside")) {}
  /// Corners of the triangles that are tinted as irregular.
  std::size_t tinted() {
    frames();
    const ImU32 merge = IM_COL32(0xb0, 0x6c, 0xe8, 0);
    std::size_t count = 0;
    const ImDrawData* drawn = ImGui::GetDrawData();
    for (int i = 0; i < drawn->CmdListsCount; ++i)
      for (const ImDrawVert& vertex : drawn->CmdLists[i]->VtxBuffer) {
        const ImU32 alpha = vertex.col >> IM_COL32_A_SHIFT;
        count += (vertex.col & 0x00ffffff) == merge && alpha > 0 && alpha < 0x40 ? 1 : 0;
      }
    return count;
  }
};

/// Fans have triangles where these are not joined to quads.
TEST_F(WithSkin, NothingLiesOverTheColoursOfAMap) {
  bench_.wait_for_surfaces();
  run("property.skin_quads");
  ASSERT_TRUE(marks().contains("check.skin_quads"));
  ASSERT_TRUE(editor().active_object()->skin()->skin->pleat.quad_fans);
  bench_.click("check.skin_quads");
  ASSERT_FALSE(editor().active_object()->skin()->skin->pleat.quad_fans);
  bench_.wait_for_surfaces();
  EXPECT_GT(tinted(), 0U) << "triangles are tinted without a map";
  bench_.key("Alt+Z");
  bench_.wait_for_surfaces();
  EXPECT_EQ(tinted(), 0U) << "of the view's map";
  bench_.key("Alt+Z");
  EXPECT_GT(tinted(), 0U);
  DisplaySettings display = editor().active_object()->display;
  display.map = SurfaceMap::zebra;
  editor().commit(set_display(editor().history.current(), editor().selection.active, display), "Map");
  bench_.wait_for_surfaces();
  EXPECT_EQ(tinted(), 0U) << "of the object's own map";
}

/// "selected objects only" was cut off.
TEST(Dialogs, FitNarrowWindowsInBothLanguages) {
  for (const bool japanese : {false, true}) {
    SCOPED_TRACE(japanese);
    HeadlessWorkbench bench(test::box(), {800, 600});
    bench.set_scale(1.5F);
    if (japanese) {
      bench.editor().language = Language::load(test::source_folder() + "/assets/languages/ja.po").value();
      FontRequest fonts;
      fonts.scale = 1.5F;
      for (const char32_t character : bench.editor().language.characters())
        fonts.characters.insert(character);
      bench.set_fonts(fonts);
    }
    std::vector<const char*> dialogs{"file.export", "file.export_picture", "file.export_turntable",
                                     "file.import"};
    if (!why_no_cad_files()) dialogs.push_back("file.export_cad");
    for (const char* id : dialogs) {
      SCOPED_TRACE(id);
      ASSERT_TRUE(bench.workbench().commands().run(id).ran);
      for (int i = 0; i < 6; ++i) bench.frame();
      const auto& marks = bench.workbench().marks().all();
      ASSERT_TRUE(marks.contains("dialog.accept"));
      // With little room the settings stand in place of the list, and scroll.
      const bool folded = marks.contains("dialog.settings");
      if (folded) bench.click("dialog.settings");
      for (int i = 0; i < 3; ++i) bench.frame();
      const Marks::Rect accept = marks.at("dialog.accept");
      const int right = accept.x + accept.width;
      int fields = 0;
      for (const auto& [mark, rect] : marks) {
        if (!mark.starts_with("export.") && !mark.starts_with("picture.") && !mark.starts_with("import."))
          continue;
        ++fields;
        EXPECT_LE(rect.x + rect.width, right + 1) << mark;
        if (!folded) EXPECT_LE(rect.y + rect.height, accept.y) << mark;
      }
      EXPECT_GE(fields, 2);
      EXPECT_LE(accept.y + accept.height, 600);
      // A scroll bar lay over its end.
      const ImGuiWindow* dialog = ImGui::FindWindowByName("###file_dialog");
      ASSERT_NE(dialog, nullptr);
      EXPECT_LE(float(right), dialog->InnerRect.Max.x) << "the button is cut off";
      bench.key("Esc");
      for (int i = 0; i < 4; ++i) bench.frame();
    }
  }
}

/// They covered the next two rows.
TEST(Dialogs, TipsStandBesideTheirFields) {
  HeadlessWorkbench bench(test::box(), {1280, 800});
  std::vector<const char*> dialogs{"file.export", "file.export_picture"};
  if (!why_no_cad_files()) dialogs.push_back("file.export_cad");
  for (const char* id : dialogs) {
    SCOPED_TRACE(id);
    ASSERT_TRUE(bench.workbench().commands().run(id).ran);
    for (int i = 0; i < 6; ++i) bench.frame();
    // The name has the keyboard first. While one types there are no tips, but soon after there are.
    ASSERT_NE(ImGui::GetActiveID(), 0U);
    for (int i = 0; i < 40; ++i) bench.frame();
    const auto fields = bench.workbench().marks().all();
    int tips = 0;
    for (const auto& [mark, rect] : fields) {
      if (!mark.starts_with("export.") && !mark.starts_with("picture.")) continue;
      bench.move(rect.x + rect.width / 2.0, rect.y + rect.height / 2.0);
      for (int i = 0; i < 3; ++i) bench.frame();
      for (const ImGuiWindow* tip : ImGui::GetCurrentContext()->Windows) {
        if (!(tip->Flags & ImGuiWindowFlags_Tooltip) || !tip->WasActive || tip->Hidden) continue;
        ++tips;
        for (const auto& [other, at] : fields) {
          if (!other.starts_with("export.") && !other.starts_with("picture.")) continue;
          const ImRect field(float(at.x), float(at.y), float(at.x + at.width), float(at.y + at.height));
          EXPECT_FALSE(tip->Rect().Overlaps(field)) << "the tip of " << mark << " covers " << other;
        }
      }
    }
    EXPECT_GE(tips, 3);
    bench.key("Esc");
    for (int i = 0; i < 4; ++i) bench.frame();
  }
}

/// Words that a designer asked about are nowhere in the interface, which the catalogue lists whole.
TEST(Words, ThoseThatNobodyKnowsAreGone) {
  std::ifstream file(test::source_folder() + "/assets/languages/ja.po");
  ASSERT_TRUE(file);
  const std::string catalogue((std::istreambuf_iterator<char>(file)), {});
  EXPECT_NE(catalogue.find("\"Fair\""), std::string::npos);
  for (const char* word :
       {"\"Target\"", "\"Rounder\"", "\"Even tension\"", "\"Split concave\"", "\"Umbilic\""})
    EXPECT_EQ(catalogue.find(word), std::string::npos) << word;
}

TEST(RecentFiles, ACadFileHasAPicture) {
  if (const auto missing = why_no_cad_files()) GTEST_SKIP() << missing->text;
  const auto context = OffscreenContext::create();
  ASSERT_TRUE(context.ok());
  auto renderer = test::must(Renderer::create());
  Renderer drawing = std::move(renderer).value();
  const Scene scene = file_scene(test::source_folder() + "/tests/cases/step_box_planes.step", {});
  ASSERT_FALSE(scene.objects.empty());
  const auto picture = draw_picture(drawing, scene, {160, 120});
  ASSERT_TRUE(picture);
  std::set<std::array<std::uint8_t, 3>> colours;
  for (std::size_t i = 0; i + 3 < picture->rgba.size(); i += 4)
    colours.insert({picture->rgba[i], picture->rgba[i + 1], picture->rgba[i + 2]});
  EXPECT_GT(colours.size(), 3U) << "a body, and not its background alone";
}

}  // namespace
}  // namespace hariko::test

// The dialogs of exports: what is typed for CAD holds when the dialog opens again, and is what is exported;
// what a format of few digits cannot hold is said, with the way out.

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/export_triangles.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "core/document/edits/edits.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko::test {
namespace {

/// The workbench with what it asks to be counted.
class ExportDialog : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const auto missing = why_no_cad_files()) GTEST_SKIP() << missing->text;
  }

  const CadSettings& settings() const { return counts_.asked.back(); }

  void open() {
    bench_.workbench().commands().run("file.export_cad");
    wait_for("export.cad_tolerance");
    for (int i = 0; i < 3; ++i) bench_.frame();  // the name has the keyboard first
  }
  void cancel() {
    bench_.click("dialog.cancel");
    for (int i = 0; i < 3; ++i) bench_.frame();
    ASSERT_FALSE(bench_.workbench().marks().all().contains("dialog.cancel"));
  }
  /// Replaces what a field holds, and leaves it for another.
  void type(const std::string& field, const char* text, const std::string& other) {
    bench_.click(field);
    press(ImGuiKey_A, true);
    ImGui::GetIO().AddInputCharactersUTF8(text);
    bench_.frame();
    bench_.click(other);
    bench_.frame();
  }

  HeadlessWorkbench& bench() { return bench_; }
  const std::vector<CadSettings>& counted() const { return counts_.asked; }

 private:
  static Document box() { return document_from_mesh(test::prism(4), "Box").value(); }
  void wait_for(const std::string& mark) {
    for (int i = 0; i < 10 && !bench_.workbench().marks().all().contains(mark); ++i) bench_.frame();
    ASSERT_TRUE(bench_.workbench().marks().all().contains(mark)) << mark;
  }
  void press(ImGuiKey key, bool control) {
    ImGuiIO& io = ImGui::GetIO();
    bench_.hold(false, control, false);
#if IMGUI_VERSION_NUM >= 18900
    const auto set = [&](bool down) { io.AddKeyEvent(key, down); };
#else
    constexpr int code = 65;
    io.KeyMap[key] = code;
    const auto set = [&](bool down) { io.KeysDown[code] = down; };
#endif
    set(true);
    bench_.frame();
    set(false);
    bench_.hold(false, false, false);
    bench_.frame();
  }

  struct Counts final : test::NoServices {
    void count_cad(const CadSettings& settings) override { asked.push_back(settings); }
    std::vector<CadSettings> asked;
  };

  Counts counts_;
  HeadlessWorkbench bench_{box(), {1280, 800}, &counts_};
};

TEST_F(ExportDialog, WhatWasTypedBeforeCancelIsThereAgain) {
  open();
  ASSERT_EQ(counted().size(), 1U);
  const double usual = settings().choices.tolerance;
  type("export.cad_tolerance", "0.02 mm", "dialog.name");
  ASSERT_EQ(counted().size(), 2U) << "the faces are others";
  EXPECT_NE(usual, 0.02);
  EXPECT_EQ(settings().choices.tolerance, 0.02);
  cancel();
  EXPECT_EQ(bench().workbench().files().remembered().cad.tolerance, 0.02);
  open();
  EXPECT_EQ(settings().choices.tolerance, 0.02);
  EXPECT_EQ(settings().choices.scale, 1);
  cancel();
  EXPECT_EQ(bench().workbench().files().remembered().cad.tolerance, 0.02);
}

TEST_F(ExportDialog, AQualityIsADistanceAndAnAngle) {
  open();
  double tolerance = 1;
  for (const CadQuality quality : {CadQuality::light, CadQuality::balanced, CadQuality::fine}) {
    bench().click("export.cad_quality." + std::string(enum_word(quality)));
    for (int i = 0; i < 3; ++i) bench().frame();
    EXPECT_EQ(settings().choices.quality, quality);
    EXPECT_EQ(settings().choices.angle, grade_of(quality).angle);
    EXPECT_LT(settings().choices.tolerance, tolerance);
    tolerance = settings().choices.tolerance;
  }
  EXPECT_NEAR(tolerance, 0.001, 1e-12);
  type("export.cad_angle", "0.05", "dialog.name");
  EXPECT_NEAR(settings().choices.angle, 0.05 * std::numbers::pi / 180, 1e-12);
  const std::size_t before = counted().size();
  bench().click("export.cad_exact");
  for (int i = 0; i < 3; ++i) bench().frame();
  EXPECT_TRUE(settings().choices.exact);
  bench().click("export.cad_whole_faces");
  for (int i = 0; i < 3; ++i) bench().frame();
  EXPECT_TRUE(settings().choices.whole_faces);
  EXPECT_EQ(counted().size(), before + 2) << "the faces are others";
}

TEST_F(ExportDialog, AWallIsThatOfThePartThatIsExported) {
  open();
  type("export.thickness", "0.2 mm", "dialog.name");
  EXPECT_EQ(settings().wall.thickness, 0.2);
  for (const char* mark : {"export.wall_side", "export.wall_side.both"}) {
    bench().click(mark);
    for (int i = 0; i < 3; ++i) bench().frame();
  }
  EXPECT_EQ(settings().wall.side, WallSide::both);
  type("export.offset", "-0.1 mm", "dialog.name");
  EXPECT_EQ(settings().wall.offset, -0.1);
  cancel();
  open();
  EXPECT_TRUE(settings().wall.none()) << "the next part has none";
  cancel();
}

TEST_F(ExportDialog, TheToleranceGrowsWithTheScale) {
  open();
  type("export.cad_tolerance", "0.02 mm", "dialog.name");
  type("export.cad_scale", "0.5", "dialog.name");
  EXPECT_EQ(settings().choices.scale, 0.5);
  EXPECT_EQ(settings().choices.tolerance, 0.01);
  cancel();
  open();
  EXPECT_EQ(settings().choices.scale, 0.5);
  EXPECT_EQ(settings().choices.tolerance, 0.01);
}

/// Triangles are counted as the application does it, at once.
struct TriangleCounts final : test::NoServices {
  void count_export(const std::filesystem::path& path, const ExportSettings& settings) override {
    last.emplace(count_triangles(bench->editor().document(), path, settings, {}));
    bench->workbench().files().take_export_count(settings, *last);
  }
  HeadlessWorkbench* bench = nullptr;
  std::optional<Result<ExportCount>> last;
};

TEST(TriangleDialog, MovesToZeroWhatTheFormatCannotHoldWhereItIs) {
  Similarity far{.translation = {500000.123, 5123456.789, 0}};
  const Document at_zero = document_from_mesh(test::prism(4), "Box").value();
  TriangleCounts counts;
  HeadlessWorkbench bench(set_transform(at_zero, at_zero.objects.front()->id, far).value(), {1280, 800},
                          &counts);
  counts.bench = &bench;
  const auto shows = [&](const char* mark) { return bench.workbench().marks().all().contains(mark); };
  const test::TemporaryFolder folder;
  ASSERT_TRUE(bench.workbench().commands().run("file.export").ran);
  for (int i = 0; i < 6; ++i) bench.frame();
  EXPECT_TRUE(shows("export.result")) << "OBJ has digits enough";
  bench.type((folder.path() / "a.stl").string());  // the name has the keyboard first
  for (int i = 0; i < 3; ++i) bench.frame();
  ASSERT_TRUE(counts.last && !counts.last->ok());
  EXPECT_EQ(counts.last->error().code, Code{"E_FILE_DIGITS"});
  EXPECT_NE(counts.last->error().remedy.find("move to zero"), std::string::npos);
  EXPECT_FALSE(shows("export.result"));
  bench.click("export.zero");
  for (int i = 0; i < 3; ++i) bench.frame();
  ASSERT_TRUE(counts.last->ok()) << to_string(counts.last->error());
  EXPECT_GT(counts.last->value().triangles, 0U);
  EXPECT_TRUE(shows("export.result"));
}

}  // namespace
}  // namespace hariko::test

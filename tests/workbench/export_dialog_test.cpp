// The dialog that exports for CAD: what is typed in it holds when it opens again, and is what is exported.

#include <gtest/gtest.h>

#include <vector>

#include "core/cad/kernel/cad_file.hpp"
#include "core/document/edits/edits.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko {
namespace {

using test::HeadlessWorkbench;

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

}  // namespace
}  // namespace hariko

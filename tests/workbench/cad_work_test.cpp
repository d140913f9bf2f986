// Export for CAD by hand: measured before it is written, anew when the tolerance changes; whole files that
// come back by an import; half a file is refused with its reason.

#include <filesystem>
#include <string>

#include "core/cad/kernel/cad_file.hpp"
#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

std::size_t times_in(const std::string& text, const std::string& word) {
  std::size_t out = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++out;
  return out;
}

/// The program with a cube; CAD files are written.
class CadWork : public ::testing::Test, protected ProgramHands {
 protected:
  void SetUp() override {
    if (const auto missing = why_no_cad_files()) GTEST_SKIP() << missing->text;
    open_sample("cube");
  }
  bool shows(const std::string& mark) { return marks().contains(mark); }
  int counted() const { return counted_; }
  void open_dialog() {
    menu("File", "file.export_cad");
    wait();
  }
  /// Content of a file that is exported, without white space at its end.
  std::string written(const std::string& name) {
    open_dialog();
    name_file(name);
    wait();
    std::string text = slurp(folder() / name);
    text.erase(text.find_last_not_of(" \r\n") + 1);
    return text;
  }
  void import_file_named(const std::string& name) {
    press({"Ctrl+I"});
    name_file(name);
    wait();
  }

 private:
  void export_cad(const std::filesystem::path& path, const CadSettings& settings) override {
    exchange().export_cad(path, settings);
  }
  void count_cad(const CadSettings& settings) override {
    ++counted_;
    exchange().count_cad(settings);
  }

  int counted_ = 0;
};

TEST_F(CadWork, TheDialogMeasuresAndItsChoicesAreThoseOfTheFile) {
  open_dialog();
  EXPECT_EQ(counted(), 1);
  EXPECT_TRUE(shows("export.result"));
  click("export.cad_tolerance");
  type("0.02 mm");
  click("dialog.name");
  wait();
  EXPECT_EQ(counted(), 2);
  EXPECT_TRUE(shows("export.result"));
  click("export.cad_unit");
  click("export.cad_unit.cm");
  click("export.ap242");
  wait();
  EXPECT_EQ(counted(), 2) << "the unit and the schema do not change the faces";
  click("dialog.cancel");

  std::string step = written("cube.step");
  const std::string told = notice();
  EXPECT_TRUE(told.starts_with("Exported cube.step: ")) << told;
  EXPECT_NE(told.find(" faces, "), std::string::npos) << told;
  EXPECT_TRUE(told.ends_with("B.")) << told;
  EXPECT_TRUE(step.starts_with("ISO-10303-21;"));
  EXPECT_TRUE(step.ends_with("END-ISO-10303-21;")) << "half a file";
  EXPECT_EQ(times_in(step, "MANIFOLD_SOLID_BREP"), 1U) << "the cube is no solid";
  EXPECT_GT(times_in(step, "AP242"), 0U);
  std::erase(step, ' ');
  EXPECT_GT(times_in(step, "SI_UNIT(.CENTI.,.METRE.)"), 0U);
}

TEST_F(CadWork, WholeFilesComeBackAndHalfAFileIsRefusedWithItsReason) {
  const std::string step = written("cube.step");
  const std::string iges = written("cube.igs");
  const std::size_t last_line = iges.rfind('\n') + 1;
  ASSERT_GT(iges.size(), last_line + 72) << notice();
  EXPECT_EQ(iges[last_line + 72], 'T') << "half a file";
  import_file_named("cube.step");
  EXPECT_EQ(editor().history.position(), 1U) << notice();
  import_file_named("cube.igs");
  EXPECT_EQ(editor().history.position(), 2U) << notice();

  spill(folder() / "half.step", step.substr(0, step.size() / 2));
  editor().notices().clear();
  import_file_named("half.step");
  EXPECT_EQ(editor().history.position(), 2U);
  EXPECT_FALSE(notice().empty()) << "nothing says why nothing came";
}

}  // namespace
}  // namespace hariko::test

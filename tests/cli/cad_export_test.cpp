#include <array>
#include <string>

#include "core/cad/kernel/cad_file.hpp"
#include "tests/cli/program.hpp"

namespace hariko::test {
namespace {

class CadExport : public ProgramTest {};

TEST_F(CadExport, WritesAndReportsOrSaysWhatIsMissing) {
  const std::string out = path("cube.step");
  const Outcome result = run("export " + golden("cube.obj") + " " + out + " --tolerance 0.001 --unit cm");
  if (why_no_cad_files()) {
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.error.find("E_NO_CAD_KERNEL"), std::string::npos) << result.error;
    EXPECT_FALSE(std::filesystem::exists(out));
    return;
  }
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("cube: 6 faces"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("1 solids, 0 open shells, valid"), std::string::npos) << result.out;
  const std::string text = read_text(out);
  EXPECT_TRUE(text.starts_with("ISO-10303-21;"));
  EXPECT_NE(text.find(".CENTI.,.METRE."), std::string::npos);
}

TEST_F(CadExport, QualityIsADistanceAndAnAngleThatOptionsReplace) {
  if (why_no_cad_files()) GTEST_SKIP() << "built without OpenCASCADE";
  const auto told = [&](const std::string& options) {
    return succeed("export " + golden("cube.obj") + " " + path("cube.step") + " " + options).out;
  };
  const auto control_points = [](const std::string& text) {
    const std::size_t end = text.find(" control points");
    const std::size_t begin = text.rfind(' ', end - 1) + 1;
    return std::stoul(text.substr(begin, end - begin));
  };
  unsigned long before = 0;
  for (const auto& [quality, tolerance, angle] :
       {std::array{"light", "0.05", "0.2"}, std::array{"balanced", "0.01", "0.1"},
        std::array{"fine", "0.001", "0.02"}}) {
    const std::string text = told(std::string("--quality ") + quality);
    EXPECT_NE(text.find(std::string(", tolerance ") + tolerance + " mm\n"), std::string::npos) << text;
    EXPECT_NE(text.find(std::string(", asked for ") + angle + " degrees\n"), std::string::npos) << text;
    EXPECT_GT(control_points(text), before);
    before = control_points(text);
  }
  const std::string typed = told("--quality light --tolerance 0.02 --angle 0.5 --whole-faces");
  EXPECT_NE(typed.find(", tolerance 0.02 mm\n"), std::string::npos) << typed;
  EXPECT_NE(typed.find(", asked for 0.5 degrees\n"), std::string::npos) << typed;
  EXPECT_NE(typed.find("cube: 6 faces"), std::string::npos) << typed;
}

TEST_F(CadExport, OptionsOfOtherFormatsAreRefused) {
  for (const std::string arguments :
       {"a.step --density 4", "a.stl --tolerance 0.1", "b.step --up y", "a.ply --ap242"}) {
    const Outcome result = run("export " + golden("cube.obj") + " " + path("") + "/" + arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
  }
  EXPECT_EQ(run("export " + golden("cube.obj") + " " + path("a.step") + " --tolerance 0").exit_code, 2);
}

}  // namespace
}  // namespace hariko::test

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

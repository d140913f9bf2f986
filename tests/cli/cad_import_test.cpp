// STEP and IGES files in the place of FILE.

#include "core/cad/kernel/cad_file.hpp"
#include "tests/cli/program.hpp"

namespace hariko::test {
namespace {

class CadImport : public ProgramTest {};

TEST_F(CadImport, SurfacesComeBack) {
  if (why_no_cad_files()) GTEST_SKIP() << "built without OpenCASCADE";
  std::string bicubic = "1\n3 3\n";
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      bicubic += std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(i % 3 - j % 2) + "\n";
  const std::string model = path("model.bpt");
  write_text(model, bicubic);
  const Json before = run("info " + model + " --json").object();
  for (const char* name : {"a.step", "a.igs"}) {
    SCOPED_TRACE(name);
    const std::string file = path(name);
    ASSERT_EQ(run("export " + model + " " + file).exit_code, 0);
    const Outcome info = succeed("info " + file + " --json");
    const Json after = info.object();
    EXPECT_EQ(after["name"], "model");
    EXPECT_EQ(after["kind"], "bezier");
    const double area = before["area"].get<double>();
    EXPECT_NEAR(after["area"].get<double>(), area, 1e-9 * area);
    succeed("mesh " + file + " " + path("a.stl") + " --distance 0.05");
    EXPECT_GT(std::filesystem::file_size(path("a.stl")), 84U);
  }
}

TEST_F(CadImport, WhatIsNoCadFileIsSaidToBe) {
  write_text(path("a.step"), "ISO-10303-21;\nHEADER;\n");
  const Outcome result = run("info " + path("a.step"));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.error.find(why_no_cad_files() ? "E_NO_CAD_KERNEL" : "E_CAD_READ"), std::string::npos)
      << result.error;
}

}  // namespace
}  // namespace hariko::test

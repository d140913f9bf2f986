#include "core/cad/kernel/cad_text.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "core/cad/kernel/read_cad_file.hpp"

namespace hariko::test {
namespace {

constexpr const char* small_step =
    "/* made by hand */\nISO-10303-21;\nHEADER;\nFILE_NAME('END-ISO-10303-21; it''s in a "
    "text','');\nENDSEC;\n"
    "DATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;\n";

TEST(CadText, WholeStepFilesAreAccepted) {
  EXPECT_FALSE(check_step_text(small_step));
  EXPECT_FALSE(check_step_text(std::string(small_step) + "what follows"));
}

TEST(CadText, StepFilesThatAreCutOffAreRefusedWherever) {
  const std::string whole = small_step;
  const std::size_t end = whole.rfind("END-ISO-10303-21") + 16;
  for (std::size_t size = 0; size < end; ++size) {
    const auto wrong = check_step_text(std::string_view(whole).substr(0, size));
    ASSERT_TRUE(wrong) << size;
    EXPECT_EQ(wrong->code, e_cad_read);
  }
}

TEST(CadText, StepFilesThatNestTooDeeplyAreRefused) {
  const std::string deep = std::string("ISO-10303-21;\n#1=A(") + std::string(100'000, '(');
  const auto wrong = check_step_text(deep);
  ASSERT_TRUE(wrong);
  EXPECT_NE(wrong->text.find("nested"), std::string::npos);
}

std::string iges_line(const std::string& text, char section, int number) {
  std::string out = text;
  out.resize(72, ' ');
  char end[16];
  std::snprintf(end, sizeof end, "%c%7d\n", section, number);
  return out + end;
}

std::vector<std::string> small_iges() {
  return {iges_line("made by hand", 'S', 1),     iges_line("1H,,1H;;", 'G', 1),
          iges_line("     116       1", 'D', 1), iges_line("     116", 'D', 2),
          iges_line("116,0,0,0;", 'P', 1),       iges_line("S      1G      1D      2P      1", 'T', 1)};
}

std::string joined(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += line;
  return out;
}

TEST(CadText, WholeIgesFilesAreAccepted) {
  EXPECT_FALSE(check_iges_text(joined(small_iges())));
  std::string windows = joined(small_iges());
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2)
    windows.insert(at, "\r");
  EXPECT_FALSE(check_iges_text(windows));
}

TEST(CadText, IgesFilesThatAreCutOffOrMissLinesAreRefused) {
  const std::string whole = joined(small_iges());
  for (std::size_t size = 0; size + 1 < whole.size(); ++size)
    EXPECT_TRUE(check_iges_text(std::string_view(whole).substr(0, size))) << size;
  for (std::size_t gone = 0; gone < small_iges().size(); ++gone) {
    auto lines = small_iges();
    lines.erase(lines.begin() + std::ptrdiff_t(gone));
    EXPECT_TRUE(check_iges_text(joined(lines))) << gone;
  }
  for (std::size_t k = 0; k + 1 < small_iges().size(); ++k) {
    auto lines = small_iges();
    std::swap(lines[k], lines[k + 1]);
    EXPECT_TRUE(check_iges_text(joined(lines))) << k;
  }
}

}  // namespace
}  // namespace hariko::test

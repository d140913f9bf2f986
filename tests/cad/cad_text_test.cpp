#include "core/cad/kernel/cad_text.hpp"

#include <cstdio>
#include <string>
#include <vector>

#include "core/cad/kernel/cad_letters.hpp"
#include "core/cad/kernel/read_cad_file.hpp"
#include "tests/support/must.hpp"

namespace hariko::test {
namespace {

constexpr const char* small_step =
    "/* made by hand */\nISO-10303-21;\nHEADER;\nFILE_NAME('END-ISO-10303-21; it''s in a "
    "text','');\nENDSEC;\n"
    "DATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;\n";

TEST(CadText, WholeStepFilesAreAccepted) {
  const auto whole = must(check_step_text(small_step));
  EXPECT_EQ(whole->end, std::string(small_step).size());
  EXPECT_FALSE(whole->more_follows);
}

TEST(CadText, WhatFollowsTheEndOfStepIsCutOffAndSaid) {
  const auto text = must(step_text_of(std::string(small_step) + "what follows"));
  EXPECT_EQ(text->text, small_step);
  ASSERT_EQ(text->warnings.size(), 1U);
  EXPECT_EQ(text->warnings[0].code, w_cad_behind);
  // Signatures of edition 3 belong to the file.
  EXPECT_TRUE(step_text_of(std::string(small_step) + "SIGNATURE;\nMIIB\nENDSEC;\n")->warnings.empty());
}

TEST(CadText, StepFilesThatAreCutOffAreRefusedWherever) {
  const std::string whole = small_step;
  const std::size_t end = whole.rfind("END-ISO-10303-21") + 16;
  for (std::size_t size = 0; size < end; ++size) {
    const auto wrong = check_step_text(std::string_view(whole).substr(0, size));
    ASSERT_FALSE(wrong) << size;
    EXPECT_EQ(wrong.error().code, e_cad_read);
  }
}

TEST(CadText, StepFilesThatNestTooDeeplyAreRefused) {
  const std::string deep = std::string("ISO-10303-21;\n#1=A(") + std::string(100'000, '(');
  const auto wrong = check_step_text(deep);
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().text.find("nested"), std::string::npos);
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
  EXPECT_TRUE(check_iges_text(joined(small_iges())));
  std::string windows = joined(small_iges());
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2)
    windows.insert(at, "\r");
  const auto checked = must(check_iges_text(windows + "\r\n\x1a"));
  EXPECT_TRUE(checked->counts_agree);
  EXPECT_FALSE(checked->more_follows);
}

TEST(CadText, IgesWithTextBehindItsEndIsReadWithAWarning) {
  const std::string whole = joined(small_iges());
  const auto text = must(iges_text_of(whole + "left by the exporter\n"));
  EXPECT_TRUE(text->changed);
  EXPECT_EQ(text->text, whole);
  ASSERT_EQ(text->warnings.size(), 1U);
  EXPECT_EQ(text->warnings[0].code, w_cad_behind);
}

TEST(CadText, IgesWhoseLastLineCountsTooManyIsReadWithAWarning) {
  auto lines = small_iges();
  lines.back() = iges_line("S      3G      1D      4P     17", 'T', 1);
  const auto text = must(iges_text_of(joined(lines)));
  ASSERT_EQ(text->warnings.size(), 1U);
  EXPECT_EQ(text->warnings[0].code, w_cad_counts);
  // Lines of parameters that the directory counts, and directories that parameters name, are missed.
  lines[2] = iges_line("     116       2", 'D', 1);
  EXPECT_FALSE(iges_text_of(joined(lines)));
  lines = small_iges();
  lines[4] = iges_line("116,0,0,0;" + std::string(55, ' ') + "      3", 'P', 1);
  EXPECT_FALSE(iges_text_of(joined(lines)));
}

TEST(CadText, ByteOrderMarksAreSkippedWithAWarning) {
  const std::string mark = "\xef\xbb\xbf";
  std::string wide = "\xff\xfe";
  for (const char c : std::string(small_step)) (wide += c) += '\0';
  for (const std::string& marked : {mark + small_step, wide}) {
    const auto text = must(step_text_of(marked));
    EXPECT_EQ(text->text, small_step);
    ASSERT_EQ(text->warnings.size(), 1U);
    EXPECT_EQ(text->warnings[0].code, w_cad_mark);
  }
  const auto iges = must(iges_text_of(mark + joined(small_iges())));
  EXPECT_TRUE(iges->changed);
  EXPECT_EQ(iges->text, joined(small_iges()));
}

TEST(CadText, LettersOfOldEncodingsLoseAtMostThemselves) {
  const auto latin = decoded("Geh\xe4use \x80 5", StrayBytes::letters);
  EXPECT_EQ(latin.text, "Gehäuse € 5");
  EXPECT_EQ(latin.guessed, 2U);
  EXPECT_EQ(decoded("Geh\xe4use", StrayBytes::question_mark).text, "Geh?use");
  // Western words whose letters would make characters of Shift-JIS, too.
  for (const char* word : {"G\xe9n\xe9rique", "\xc9l\xe9ment", "\x93quoted\x94 \xe9l\xe8ve \xe0 c\xf4t\xe9"})
    EXPECT_FALSE(decoded(word, StrayBytes::letters).japanese) << word;
  const auto japanese = decoded(
      "\x83z\x83"
      "C\x81[\x83\x8b",
      StrayBytes::letters);
  EXPECT_EQ(japanese.text, "ホイール");
  EXPECT_TRUE(japanese.japanese);
  EXPECT_EQ(decoded("\x83z\x83"
                    "C\x81[\x83\x8b",
                    StrayBytes::question_mark)
                .text,
            "?z?C?[??");
  const auto known = decoded("Gehäuse ホイール", StrayBytes::letters);
  EXPECT_EQ(known.text, "Gehäuse ホイール");
  EXPECT_EQ(known.guessed, 0U);
}

TEST(CadText, LettersBeyondAsciiAreWrittenAsDirectives) {
  EXPECT_EQ(with_step_directives("wheel"), "wheel");
  EXPECT_EQ(with_step_directives("äö wheel ホ"), "\\X2\\00E400F6\\X0\\ wheel \\X2\\30DB\\X0\\");
  EXPECT_EQ(with_step_directives("é😀!"), "\\X2\\00E9\\X0\\\\X4\\0001F600\\X0\\!");
  EXPECT_EQ(ascii_name("ホイール é 1"), "____ _ 1");
}

TEST(CadText, IgesFilesThatAreCutOffOrMissLinesAreRefused) {
  const std::string whole = joined(small_iges());
  for (std::size_t size = 0; size + 1 < whole.size(); ++size)
    EXPECT_FALSE(check_iges_text(std::string_view(whole).substr(0, size))) << size;
  for (std::size_t gone = 0; gone < small_iges().size(); ++gone) {
    auto lines = small_iges();
    lines.erase(lines.begin() + std::ptrdiff_t(gone));
    EXPECT_FALSE(check_iges_text(joined(lines))) << gone;
  }
  for (std::size_t k = 0; k + 1 < small_iges().size(); ++k) {
    auto lines = small_iges();
    std::swap(lines[k], lines[k + 1]);
    EXPECT_FALSE(check_iges_text(joined(lines))) << k;
  }
}

}  // namespace
}  // namespace hariko::test

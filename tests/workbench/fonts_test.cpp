// The fonts: what they can write, and where they come from.

#include "ui/base/fonts.hpp"

#include <imgui.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "render/font_files.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "ui/base/icons.hpp"
#include "ui/base/language.hpp"

namespace hariko {
namespace {

class Fonts : public ::testing::Test {
 protected:
  Fonts() { ImGui::CreateContext(); }
  ~Fonts() override { ImGui::DestroyContext(); }
  /// Characters of a text that the font of the interface has no picture of.
  static std::u32string missing(std::string_view text) {
    std::u32string out;
    for (const char32_t character : code_points(text))
      if (!ImGui::GetIO().Fonts->Fonts[0]->FindGlyphNoFallback(static_cast<ImWchar>(character)))
        out += character;
    return out;
  }
};

TEST_F(Fonts, WriteNamesInLatinGreekAndCyrillic) {
  load_fonts({});
  for (const char* name : {"Kotflügel, Čeština, Łódź, Ștefan", "Tiếng Việt", "Σφαίρα", "ᾠδή, Ἀθῆναι", "Кузов",
                           "Ґанок, Ђорђе, Қазақ", "Δx ≤ 3 → ∞ €"})
    EXPECT_EQ(missing(name), U"") << name;
}

TEST_F(Fonts, WriteJapaneseWhenItIsAskedFor) {
  ASSERT_TRUE(japanese_font_installed());
  load_fonts({});
  EXPECT_NE(missing("日本語"), U"");
  FontRequest request;
  for (const char32_t character : code_points("日本語")) request.characters.insert(character);
  load_fonts(request);
  EXPECT_EQ(missing("日本語"), U"");
  EXPECT_NE(missing("カ"), U"") << "what nobody asked for";
  request.japanese = true;
  load_fonts(request);
  EXPECT_EQ(missing("カタカナとひらがな、車体"), U"");
}

TEST_F(Fonts, OnlyWhatTheTextHasNotIsAskedOfTheJapaneseFont) {
  EXPECT_TRUE(needs_japanese_font(U'日'));
  EXPECT_TRUE(needs_japanese_font(U'カ'));
  for (const char32_t character : code_points("aßКΩ→€")) EXPECT_FALSE(needs_japanese_font(character));
}

TEST_F(Fonts, DigitsHaveOneWidth) {
  load_fonts({});
  const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
  for (ImWchar digit = '1'; digit <= '9'; ++digit)
    EXPECT_EQ(font.FindGlyphNoFallback(digit)->AdvanceX, font.FindGlyphNoFallback('0')->AdvanceX);
}

TEST_F(Fonts, HaveEveryIconOfTheList) {
  load_fonts({});
  std::ifstream file(test::source_folder() + "/ui/base/icons.hpp");
  std::stringstream text;
  text << file.rdbuf();
  const std::string source = text.str();
  const std::regex escape(R"(\\u(f[0-9a-f]{3})\")");
  int count = 0;
  for (std::sregex_iterator it(source.begin(), source.end(), escape), end; it != end; ++it, ++count)
    EXPECT_TRUE(ImGui::GetIO().Fonts->Fonts[0]->FindGlyphNoFallback(
        static_cast<ImWchar>(std::stoul((*it)[1].str(), nullptr, 16))))
        << (*it)[1].str();
  EXPECT_GT(count, 40);
}

TEST_F(Fonts, AreFoundByFontconfig) {
  const FontFiles files = find_font_files();
  ASSERT_TRUE(files.text && files.icons && files.japanese);
  EXPECT_EQ(files.text->family, "Inter");
  EXPECT_EQ(files.icons->family, "FontAwesome");
  EXPECT_EQ(missing_fonts(), nullptr);
}

/// With a configuration that knows one folder without fonts.
TEST_F(Fonts, WithoutAnyTheyAreSaidToBeMissing) {
  const test::TemporaryFolder folder;
  const std::string configuration = (folder.path() / "no_fonts.conf").string();
  std::ofstream(configuration) << "<?xml version=\"1.0\"?><fontconfig><dir>/nowhere</dir></fontconfig>";
  ::setenv("FONTCONFIG_FILE", configuration.c_str(), 1);
  const FontFiles files = find_font_files();
  ::unsetenv("FONTCONFIG_FILE");
  EXPECT_FALSE(files.text || files.icons || files.japanese);
}

}  // namespace
}  // namespace hariko

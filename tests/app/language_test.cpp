// Language: sentences are found by their text, by their placeholders, and messages by their codes.

#include "ui/base/language.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <system_error>

#include "core/base/files/file_io.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "ui/base/system_reasons.hpp"

namespace hariko {
namespace {

Language language_of(const std::string& json) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "xx.json";
  std::ofstream(path) << json;
  auto loaded = Language::load(path);
  EXPECT_TRUE(loaded.ok());
  return loaded.ok() ? std::move(loaded).value() : Language();
}

const Language& japanese() {
  static const Language language = language_of(R"({
    "Save": "保存", "Move vertex": "頂点を移動", "Move {0} vertices": "{0}個の頂点を移動",
    "Move {0} vertices by {1}": "{0}個の頂点を{1}だけ移動", "{1} of {0}": "{0}の{1}",
    "E_LOCKED": "ロックされています。", "E_LOCKED.remedy": "解除してください。",
    "vertex": "頂点", "The file {0} is gone.": "ファイル {0} はありません。"})");
  return language;
}

TEST(Fill, replaces_placeholders_and_keeps_what_has_no_argument) {
  EXPECT_EQ(fill("{0} of {1}", {"a", "b"}), "a of b");
  EXPECT_EQ(fill("{1}{0}{1}", {"a", "b"}), "bab");
  EXPECT_EQ(fill("{0} {2} {x} {", {"a"}), "a {2} {x} {");
  EXPECT_EQ(fill("{0}", {"{1}", "b"}), "{1}") << "arguments are not filled again";
}

TEST(Language, english_gives_everything_back) {
  const Language english;
  EXPECT_STREQ(english("Save"), "Save");
  EXPECT_EQ(english.phrase("Move 3 vertices"), "Move 3 vertices");
  EXPECT_EQ(english.text_of(make_error(Code{"E_LOCKED"}, "It is locked.")), "It is locked.");
  EXPECT_TRUE(english.characters().empty());
}

TEST(Language, finds_filled_sentences) {
  const Language& tr = japanese();
  EXPECT_EQ(tr.phrase("Move vertex"), "頂点を移動");
  EXPECT_EQ(tr.phrase("Move 12 vertices"), "12個の頂点を移動");
  EXPECT_EQ(tr.phrase("Move 12 vertices by 3 mm"), "12個の頂点を3 mmだけ移動")
      << "the longer entry comes first";
  EXPECT_EQ(tr.phrase("two of three"), "threeのtwo") << "the order of the places may change";
  EXPECT_EQ(tr.phrase("Save of vertex"), "頂点の保存") << "labels within labels";
  EXPECT_EQ(tr.phrase("Move 12 edges"), "Move 12 edges");
  EXPECT_EQ(tr.phrase(""), "");
}

TEST(Language, translates_messages_by_sentence_then_by_code) {
  const Language& tr = japanese();
  const auto locked = make_error(Code{"E_LOCKED"}, "The object \"Box\" is locked.", "Unlock it first.");
  EXPECT_EQ(tr.text_of(locked), "ロックされています。");
  EXPECT_EQ(tr.remedy_of(locked), "解除してください。");
  const auto at_vertex = make_error(Code{"E_LOCKED"}, "Locked.", {}, Element{Element::Kind::vertex, 12});
  EXPECT_EQ(tr.text_of(at_vertex), "頂点 12: ロックされています。");
  EXPECT_EQ(tr.remedy_of(at_vertex), "") << "a message without a remedy gets none";
  EXPECT_EQ(tr.text_of(make_error(Code{"E_GONE"}, "The file a.obj is gone.")),
            "ファイル a.obj はありません。");
  EXPECT_EQ(tr.text_of(make_error(Code{"E_OTHER"}, "Something else.")), "Something else.");
}

TEST(Language, finds_sentences_behind_what_they_are_about) {
  const Language tr = language_of(R"({
    "{0} of {1}": "{1}の{0}", "Line {0}": "{0} 行目", "{0} faces of the file are flat.": "{0} 枚の面が平らです。",
    "What follows was ignored.": "続きを無視しました。", "W_X": "何かあります。"})");
  const auto text = [&](const char* english) { return tr.text_of(make_warning(Code{"W_X"}, english)); };
  EXPECT_EQ(text("\"a: b.ply\": 12 faces of the file are flat."), "\"a: b.ply\": 12 枚の面が平らです。");
  EXPECT_EQ(text("\"a.ply\": Line 7: What follows was ignored."), "\"a.ply\": 7 行目: 続きを無視しました。");
  EXPECT_EQ(text("Line of sight: What follows was ignored."), "Line of sight: 続きを無視しました。");
  EXPECT_EQ(text("None of these is a label."), "何かあります。") << "labels are no sentences";
}

TEST(Language, knows_its_characters) {
  const std::u32string characters = language_of(R"({"Save": "保存", "Open": "開く"})").characters();
  EXPECT_EQ(characters, U"く保存開");
}

TEST(Language, says_why_a_catalogue_is_of_no_use) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "ja.json";
  const auto refused = [&] {
    const auto loaded = Language::load(path);
    return !loaded.ok() && loaded.error().code == e_catalogue && !loaded.error().remedy.empty();
  };
  EXPECT_TRUE(refused()) << "no file";
  for (const char* text : {"", "[]", "{\"a\": 1}", "{\"a\": \"b\"", "\xff"}) {
    std::ofstream(path) << text;
    EXPECT_TRUE(refused()) << text;
  }
}

TEST(CodePoints, reads_utf8_and_survives_what_is_none) {
  EXPECT_EQ(code_points("aé日𝄞"), U"aé日𝄞");
  EXPECT_EQ(code_points("\xff"), U"\xfffd");
  EXPECT_EQ(code_points("a\xe6\x97"), U"a\xfffd") << "cut off";
  EXPECT_EQ(code_points("\xe6\x97z"), U"\xfffdz");
}

TEST(Language, what_the_system_says_of_files_is_translated) {
  const auto loaded = Language::load(test::source_folder() + "/assets/languages/ja.json");
  ASSERT_TRUE(loaded.ok());
  for (const SystemReason& reason : system_reasons) {
    EXPECT_EQ(std::generic_category().message(reason.number), reason.text) << "as the system says it";
    EXPECT_NE((*loaded)(reason.text), std::string(reason.text));
  }
  const test::TemporaryFolder folder;
  const auto refused = read_file(folder.path() / "a.hariko");
  ASSERT_FALSE(refused.ok());
  const std::string text = loaded->text_of(refused.error());
  EXPECT_NE(text.find("a.hariko"), std::string::npos) << text;
  EXPECT_NE(text.find((*loaded)("No such file or directory")), std::string::npos) << text;
  EXPECT_EQ(text.find("cannot"), std::string::npos) << text;
  const auto nowhere = write_file_atomic(folder.path() / "none" / "a.hariko", "text");
  ASSERT_FALSE(nowhere.ok());
  EXPECT_NE(nowhere.error().text.find("its folder does not exist"), std::string::npos)
      << nowhere.error().text;
  const std::string missing = loaded->text_of(nowhere.error());
  EXPECT_NE(missing.find("a.hariko"), std::string::npos) << missing;
  EXPECT_EQ(missing.find("exist"), std::string::npos) << missing;
}

}  // namespace
}  // namespace hariko

// Language: sentences are found by their text, by their placeholders, and messages by their codes.

#include "ui/base/language.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/files/file_io.hpp"
#include "tests/support/must.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "ui/base/language_files.hpp"
#include "ui/base/system_reasons.hpp"

namespace hariko {
namespace {

constexpr const char* one_form = "nplurals=1; plural=0;";
constexpr const char* polish_forms =
    "nplurals=3; plural=(n==1 ? 0 : n%10>=2 && n%10<=4 && (n%100<10 || n%100>=20) ? 1 : 2);";

/// Beginning of a catalogue.
std::string catalogue_header(const std::string& name, const std::string& native,
                             const std::string& forms = one_form) {
  return "msgid \"\"\nmsgstr \"\"\n\"Language: xx\\n\"\n\"Content-Type: text/plain; charset=UTF-8\\n\"\n"
         "\"Plural-Forms: " +
         forms + "\\n\"\n\"X-English-Name: " + name + "\\n\"\n\"X-Native-Name: " + native + "\\n\"\n\n";
}

Result<Language> load_text(const std::string& catalogue) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "xx.po";
  std::ofstream(path) << catalogue;
  return Language::load(path);
}

Language language_of(const std::string& entries, const std::string& forms = one_form) {
  auto loaded = load_text(catalogue_header("Test", "Test", forms) + entries);
  EXPECT_TRUE(loaded.ok()) << (loaded.ok() ? std::string() : loaded.error().text);
  return loaded.ok() ? std::move(loaded).value() : Language();
}

using TestEntries = std::initializer_list<std::pair<const char*, const char*>>;

/// Texts without quotation marks.
Language language_of(TestEntries entries) {
  std::string text;
  for (const auto& [english, translation] : entries)
    text += std::string("msgid \"") + english + "\"\nmsgstr \"" + translation + "\"\n";
  return language_of(text);
}

const Language& japanese() {
  static const Language language =
      language_of(TestEntries{{"Save", "保存"},
                              {"Move vertex", "頂点を移動"},
                              {"Move {0} vertices", "{0}個の頂点を移動"},
                              {"Move {0} vertices by {1}", "{0}個の頂点を{1}だけ移動"},
                              {"{1} of {0}", "{0}の{1}"},
                              {"E_LOCKED", "ロックされています。"},
                              {"E_LOCKED.remedy", "解除してください。"},
                              {"vertex", "頂点"},
                              {"The file {0} is gone.", "ファイル {0} はありません。"}});
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
  const Language tr = language_of(TestEntries{{"{0} of {1}", "{1}の{0}"},
                                              {"Line {0}", "{0} 行目"},
                                              {"{0} faces of the file are flat.", "{0} 枚の面が平らです。"},
                                              {"What follows was ignored.", "続きを無視しました。"},
                                              {"W_X", "何かあります。"}});
  const auto text = [&](const char* english) { return tr.text_of(make_warning(Code{"W_X"}, english)); };
  EXPECT_EQ(text("\"a: b.ply\": 12 faces of the file are flat."), "\"a: b.ply\": 12 枚の面が平らです。");
  EXPECT_EQ(text("\"a.ply\": Line 7: What follows was ignored."), "\"a.ply\": 7 行目: 続きを無視しました。");
  EXPECT_EQ(text("Line of sight: What follows was ignored."), "Line of sight: 続きを無視しました。");
  EXPECT_EQ(text("None of these is a label."), "何かあります。") << "labels are no sentences";
}

TEST(Language, knows_its_characters) {
  EXPECT_EQ(language_of(TestEntries{{"Save", "保存"}, {"Open", "開く"}}).characters(), U"く保存開");
  const Language plural = language_of("msgid \"a\"\nmsgid_plural \"b\"\nmsgstr[0] \"x\"\nmsgstr[1] \"y\"\n",
                                      "nplurals=2; plural=(n != 1);");
  EXPECT_EQ(plural.characters(), U"xy") << "of every form";
}

constexpr const char* polish_entries = R"(
msgid "1 vertex"
msgid_plural "{0} vertices"
msgstr[0] "{0} wierzchołek"
msgstr[1] "{0} wierzchołki"
msgstr[2] "{0} wierzchołków"

msgid "Move {0} vertices"
msgid_plural "Move {0} vertices"
msgstr[0] "Przesuń wierzchołek"
msgstr[1] "Przesuń {0} wierzchołki"
msgstr[2] "Przesuń {0} wierzchołków"

msgid "At {0} it folds in {1} patch: look."
msgid_plural "At {0} it folds in {1} patches: look."
msgstr[0] "W {0} składa się {1} płat."
msgstr[1] "W {0} składają się {1} płaty."
msgstr[2] "W {0} składa się {1} płatów."

msgid "Delete edge"
msgid_plural "Delete {0} edges"
msgstr[0] "Usuń krawędź"
msgstr[1] "Usuń {0} krawędzie"
msgstr[2] "Usuń {0} krawędzi"
)";

TEST(Language, chooses_the_form_that_a_count_takes) {
  const Language tr = language_of(polish_entries, polish_forms);
  const auto vertices = [&](std::size_t count) { return tr.counted(count, "1 vertex", "{0} vertices"); };
  EXPECT_EQ(vertices(1), "1 wierzchołek");
  EXPECT_EQ(vertices(3), "3 wierzchołki");
  EXPECT_EQ(vertices(12), "12 wierzchołków");
  EXPECT_EQ(vertices(22), "22 wierzchołki");
  EXPECT_EQ(tr.counted(1, "1 edge", "{0} edges"), "1 edge") << "not translated";
  EXPECT_EQ(tr.counted(4, "1 edge", "{0} edges"), "4 edges");
  EXPECT_EQ(Language().counted(1, "1 vertex", "{0} vertices"), "1 vertex");
  EXPECT_EQ(Language().counted(1, "{0} object", "{0} objects"), "1 object");
  EXPECT_EQ(Language().counted(0, "1 vertex", "{0} vertices"), "0 vertices");
}

TEST(Language, chooses_it_in_filled_sentences_too) {
  const Language tr = language_of(polish_entries, polish_forms);
  EXPECT_EQ(tr.phrase("1 vertex"), "1 wierzchołek");
  EXPECT_EQ(tr.phrase("5 vertices"), "5 wierzchołków");
  EXPECT_EQ(tr.phrase("Move 1 vertices"), "Przesuń wierzchołek");
  EXPECT_EQ(tr.phrase("Move 24 vertices"), "Przesuń 24 wierzchołki");
  EXPECT_EQ(tr.phrase("Move many vertices"), "Przesuń many wierzchołków") << "no count: the last form";
  EXPECT_EQ(tr.phrase("Delete edge"), "Usuń krawędź");
  EXPECT_EQ(tr.phrase("Delete 2 edges"), "Usuń 2 krawędzie");
  // The count is where the two texts begin to differ, not the first place.
  EXPECT_EQ(tr.phrase("At 5 it folds in 1 patch: look."), "W 5 składa się 1 płat.");
  EXPECT_EQ(tr.phrase("At 1 it folds in 3 patches: look."), "W 1 składają się 3 płaty.");
  EXPECT_EQ(tr.text_of(make_warning(Code{"W_X"}, "Box: At 1 it folds in 5 patches: look.")),
            "Box: W 1 składa się 5 płatów.");
}

TEST(Language, translates_phrases_by_their_pattern) {
  const Language& tr = japanese();
  EXPECT_EQ(tr(Phrase("Move {0} vertices", {"12"})), "12個の頂点を移動");
  EXPECT_EQ(tr(Phrase("The file {0} is gone.", {"Save"})), "ファイル Save はありません。")
      << "what stands in a place is a name, also where an entry has the same letters";
  EXPECT_EQ(tr(Phrase("{1} of {0}", {"a of b", "c"})), "a of bのc") << "whatever it holds";
  EXPECT_EQ(tr(Phrase("Move vertex")), "頂点を移動");
  EXPECT_EQ(tr(Phrase(std::string("Move 3 vertices"))), "3個の頂点を移動") << "filled before";
  EXPECT_EQ(tr(Phrase("Nothing of {0} here", {"vertex"})), "Nothing of vertex here");
  EXPECT_EQ(Language()(Phrase("Move {0} vertices", {"12"})), "Move 12 vertices");
  EXPECT_TRUE(Phrase().empty());
  const Language polish = language_of(polish_entries, polish_forms);
  const auto deleted = [&](std::size_t count) {
    return polish(Phrase::counted(count, "Delete edge", "Delete {0} edges"));
  };
  EXPECT_EQ(deleted(1), "Usuń krawędź");
  EXPECT_EQ(deleted(3), "Usuń 3 krawędzie");
  EXPECT_EQ(deleted(5), "Usuń 5 krawędzi");
}

TEST(Language, tells_equal_texts_of_two_meanings_apart) {
  const char* in_context = "continuity\4Tangent";
  const Language tr = language_of(
      "msgid \"Tangent\"\nmsgstr \"Styczna\"\n\nmsgctxt \"continuity\"\nmsgid \"Tangent\"\nmsgstr "
      "\"styczność\"\n");
  EXPECT_STREQ(tr("Tangent"), "Styczna");
  EXPECT_STREQ(tr(in_context), "styczność");
  EXPECT_EQ(tr(std::string(in_context)), "styczność");
  EXPECT_TRUE(tr.has(in_context));
  const Language english;
  EXPECT_STREQ(english(in_context), "Tangent") << "the context is never shown";
  EXPECT_EQ(english(std::string(in_context)), "Tangent");
  EXPECT_STREQ(language_of(TestEntries{{"Tangent", "Styczna"}})(in_context), "Tangent")
      << "the other meaning";
}

TEST(Language, shows_english_where_a_translation_is_missing_or_a_guess) {
  const Language tr = language_of(
      "msgid \"Save\"\nmsgstr \"\"\n\n#, fuzzy\nmsgid \"Open\"\nmsgstr \"Otwórz\"\n\n"
      "msgid \"1 point\"\nmsgid_plural \"{0} points\"\nmsgstr[0] \"{0} punkt\"\nmsgstr[1] \"\"\n",
      "nplurals=2; plural=(n != 1);");
  EXPECT_STREQ(tr("Save"), "Save");
  EXPECT_STREQ(tr("Open"), "Open");
  EXPECT_EQ(tr.counted(1, "1 point", "{0} points"), "1 point") << "all forms or none";
}

TEST(Language, says_why_a_catalogue_is_of_no_use) {
  const test::TemporaryFolder folder;
  const auto nothing = Language::load(folder.path() / "ja.po");
  ASSERT_FALSE(nothing.ok());
  EXPECT_EQ(nothing.error().code, e_catalogue);
  EXPECT_NE(nothing.error().text.find("ja.po"), std::string::npos);
  const std::string header = catalogue_header("Test", "Test");
  const std::pair<std::string, const char*> wrong[] = {
      {"", "xx.po: Line 1: The file does not begin with a header."},
      {header + "msgid \"a\n", "xx.po: Line 9: The text has no closing quotation mark."},
      {header + "\xff", "xx.po: Line 9: The line is not UTF-8."},
      {header + "msgid \"a\"\nmsgid_plural \"b\"\nmsgstr[0] \"c\"\nmsgstr[1] \"d\"\n",
       "xx.po: Line 9: The entry needs one msgstr for each plural form."},
      {catalogue_header("Test", "Test", "nplurals=2; plural=x;"),
       "xx.po: The rule of the plural is no expression of n: x."}};
  for (const auto& [text, why] : wrong) {
    const auto loaded = load_text(text);
    ASSERT_FALSE(loaded.ok()) << text;
    EXPECT_EQ(loaded.error().text, why);
    EXPECT_FALSE(loaded.error().remedy.empty());
  }
}

TEST(LanguageFiles, every_catalogue_of_a_folder_is_a_language) {
  const test::TemporaryFolder folder;
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(folder.path() / name) << text;
  };
  write("pt_BR.po", catalogue_header("Brazilian Portuguese", "Português (Brasil)"));
  // Only the header is looked at, so the start of the program does not wait for texts.
  write("aa.po", catalogue_header("Polish", "Polski") + "msgid \"not closed\n");
  write("notes.txt", "no catalogue");
  const LanguageFiles found = find_languages(folder.path());
  ASSERT_TRUE(found.problems.empty()) << found.problems.front().text;
  ASSERT_EQ(found.files.size(), 2U);
  EXPECT_EQ(found.files[0].id, "brazilian_portuguese");
  EXPECT_EQ(found.files[0].name, "Português (Brasil)");
  EXPECT_EQ(found.files[0].path.filename().string(), "pt_BR.po");
  EXPECT_EQ(found.files[1].id, "polish");
  EXPECT_EQ(find_language(found.files, "polish"), &found.files[1]);
  EXPECT_EQ(find_language(found.files, "english"), nullptr);
  EXPECT_TRUE(find_languages(folder.path() / "none").files.empty());
}

TEST(LanguageFiles, a_header_that_names_no_language_is_told) {
  const std::pair<std::string, const char*> wrong[] = {
      {"", "cannot be read"},
      {"msgid \"a\"\nmsgstr \"b\"\n", "does not begin with a header"},
      {catalogue_header("", "Polski"), "X-English-Name"},
      {catalogue_header("Język", "Polski"), "X-English-Name"},
      {catalogue_header("English", "English"), "another catalogue of this language"},
      {catalogue_header("Polish", ""), "X-Native-Name"},
      {catalogue_header("Polish", "Polski", "nplurals=3;"), "does not give nplurals and plural"},
      {"msgid \"\"\nmsgstr \"X-English-Name: Polish\\n\"\n", "no field Language"},
      {"msgid \"\"\nmsgstr \"Language: pl\\n\"\n", "UTF-8"}};
  for (const auto& [text, why] : wrong) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "pl.po") << text;
    const LanguageFiles found = find_languages(folder.path());
    EXPECT_TRUE(found.files.empty()) << text;
    ASSERT_EQ(found.problems.size(), 1U) << text;
    EXPECT_TRUE(found.problems[0].text.starts_with("pl.po: ")) << found.problems[0].text;
    EXPECT_NE(found.problems[0].text.find(why), std::string::npos) << found.problems[0].text;
  }
}

std::vector<std::string> placeholders_of(const std::string& text) {
  std::vector<std::string> places;
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1))
    if (at + 2 < text.size() && text[at + 2] == '}') places.push_back(text.substr(at, 3));
  std::sort(places.begin(), places.end());
  return places;
}

/// Installed catalogues, each file; the test of the script compares what the sources need.
TEST(LanguageFiles, those_of_the_program_are_sound_and_japanese_is_whole) {
  const LanguageFiles found = find_languages(test::source_folder() + "/assets/languages");
  for (const Message& problem : found.problems) ADD_FAILURE() << problem.text;
  const LanguageFile* japanese_file = find_language(found.files, "japanese");
  ASSERT_NE(japanese_file, nullptr);
  EXPECT_EQ(japanese_file->name, "日本語");
  for (const LanguageFile& each : found.files) {
    const auto language = Language::load(each.path);
    EXPECT_TRUE(language.ok()) << (language.ok() ? std::string() : language.error().text);
  }
  const auto file = test::must(read_po(read_file(japanese_file->path).value()));
  EXPECT_GT(file->entries.size(), 3000U);
  for (const PoEntry& entry : file->entries) {
    EXPECT_TRUE(entry.translated()) << entry.text;
    if (entry.text.starts_with("E_") || entry.text.starts_with("W_")) continue;
    for (const std::string& each : entry.translations)
      EXPECT_EQ(placeholders_of(each), placeholders_of(entry.plural.empty() ? entry.text : entry.plural))
          << entry.text;
  }
}

TEST(CodePoints, reads_utf8_and_survives_what_is_none) {
  EXPECT_EQ(code_points("aé日𝄞"), U"aé日𝄞");
  EXPECT_EQ(code_points("\xff"), U"\xfffd");
  EXPECT_EQ(code_points("a\xe6\x97"), U"a\xfffd") << "cut off";
  EXPECT_EQ(code_points("\xe6\x97z"), U"\xfffdz");
}

TEST(Language, what_the_system_says_of_files_is_translated) {
  const auto loaded = test::must(Language::load(test::source_folder() + "/assets/languages/ja.po"));
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

// Catalogues: what a file says is read, and what is wrong in it is told with its line.

#include "core/base/text/po_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/mutated.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

const std::string po_header =
    "msgid \"\"\n"
    "msgstr \"\"\n"
    "\"Language: pl\\n\"\n"
    "\"Plural-Forms: nplurals=2; plural=(n != 1);\\n\"\n";

const std::string po_entries = R"(
# A remark of the translator.
#. What the program says of it.
#: ui/shell/workbench.cpp
msgid "Save"
msgstr "Zapisz"

msgctxt "continuity"
msgid "Tangent"
msgstr "styczna"
msgid "Tangent"
msgstr "Styczna"

#, fuzzy
msgid "Guess"
msgstr "Może"

msgid "1 point"
msgid_plural "{0} points"
msgstr[0] "{0} punkt"
msgstr[1] "{0} punkty"

msgid ""
"Two \"lines\"\n"
"of a \\ text"
msgstr ""
"Dwie\n"
"linie"

msgid "Nothing yet"
msgstr ""

#~ msgid "Gone"
#~ msgstr "Nie ma"
)";

PoFile file_of(const std::string& text) {
  const auto file = read_po(text);
  EXPECT_TRUE(file.ok()) << (file.ok() ? std::string() : file.error().text);
  return file.ok() ? *file : PoFile();
}

void expect_entries(const PoFile& file) {
  EXPECT_EQ(file.header.at("Language"), "pl");
  EXPECT_EQ(file.header.at("Plural-Forms"), "nplurals=2; plural=(n != 1);");
  ASSERT_EQ(file.entries.size(), 7U);
  EXPECT_EQ(file.entries[0].text, "Save");
  EXPECT_EQ(file.entries[0].translations, std::vector<std::string>{"Zapisz"});
  EXPECT_EQ(file.entries[0].line, 9U);
  EXPECT_EQ(file.entries[1].context, "continuity");
  EXPECT_EQ(file.entries[2].context, "") << "an entry needs no empty line before it";
  EXPECT_EQ(file.entries[2].translations.front(), "Styczna");
  EXPECT_TRUE(file.entries[3].fuzzy);
  EXPECT_FALSE(file.entries[3].translated());
  EXPECT_EQ(file.entries[4].plural, "{0} points");
  EXPECT_EQ(file.entries[4].translations, (std::vector<std::string>{"{0} punkt", "{0} punkty"}));
  EXPECT_TRUE(file.entries[4].translated());
  EXPECT_EQ(file.entries[5].text, "Two \"lines\"\nof a \\ text");
  EXPECT_EQ(file.entries[5].translations.front(), "Dwie\nlinie");
  EXPECT_FALSE(file.entries[6].translated());
}

TEST(PoFile, IsRead) {
  expect_entries(file_of(po_header + po_entries));
  EXPECT_TRUE(file_of(po_header).entries.empty());
}

TEST(PoFile, OfOtherEditorsIsReadToo) {
  std::string text = po_header + po_entries;
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
    text.insert(at, "\r");
  expect_entries(file_of("\xef\xbb\xbf" + text));
}

TEST(PoFile, MistakesAreToldWithTheirLine) {
  struct Wrong {
    const char *text, *why;
    int line;  ///< from 1, behind the header
  };
  constexpr int behind_header = 4;
  const Wrong wrong[] = {
      {"msgid \"a\nmsgstr \"b\"\n", "no closing quotation mark", 1},
      {"msgid \"a\" b\nmsgstr \"b\"\n", "Something follows the text", 1},
      {"msgid \"a\"b\"\nmsgstr \"b\"\n", "Something follows the text", 1},
      {"msgid \"a\"\nmsgstr \"\\q\"\n", "A backslash may stand before", 2},
      {"msgid \"a\"\nmsgstr \"b\\\n", "A backslash may stand before", 2},
      {"msgid \"a\"\nmsgstr\n", "A text in quotation marks is missing", 2},
      {"msgid a\nmsgstr \"b\"\n", "A text in quotation marks is missing", 1},
      {"message \"a\"\n", "The word message is none of a catalogue", 1},
      {"#\n\"a\"\n", "belongs to no entry", 2},
      {"msgid \"a\"\nmsgid \"b\"\n", "cannot stand here", 2},
      {"msgstr \"a\"\n", "cannot stand here", 1},
      {"msgid \"a\"\nmsgctxt \"b\"\n", "cannot stand here", 2},
      {"msgid_plural \"a\"\n", "cannot stand here", 1},
      {"msgid \"a\"\nmsgstr[0] \"b\"\n", "cannot stand here", 2},
      {"msgid \"a\"\nmsgid_plural \"b\"\nmsgstr \"c\"\n", "cannot stand here", 3},
      {"msgid \"a\"\nmsgid_plural \"b\"\nmsgstr[1] \"c\"\n", "cannot stand here", 3},
      {"msgid \"a\"\nmsgid_plural \"\"\nmsgstr[0] \"c\"\n", "plural of the entry is empty", 1},
      {"\nmsgid \"a\"\n", "has no msgstr", 2},
      {"msgid \"a\"\nmsgstr \"b\"\n\nmsgid \"a\"\nmsgstr \"c\"\n", "another entry with this text", 4},
      {"msgid \"\"\nmsgstr \"b\"\n", "empty text", 1},
      {"msgid \"\xff\"\nmsgstr \"b\"\n", "not UTF-8", 1},
      {"# \xed\xa0\x80\n", "not UTF-8", 1}};
  for (const Wrong& each : wrong) {
    SCOPED_TRACE(each.text);
    const auto file = read_po(po_header + each.text);
    ASSERT_FALSE(file.ok());
    EXPECT_EQ(file.error().code, e_catalogue);
    const int line = behind_header + each.line;
    EXPECT_TRUE(file.error().text.starts_with("Line " + std::to_string(line) + ": ")) << file.error().text;
    EXPECT_EQ(file.error().element, (Element{Element::Kind::line, std::uint64_t(line)}));
    EXPECT_NE(file.error().text.find(each.why), std::string::npos) << file.error().text;
    EXPECT_FALSE(file.error().remedy.empty());
  }
}

TEST(PoFile, AFileHasAHeaderAtItsBeginning) {
  for (const char* text : {"", "\n\n", "# nothing\n", "msgid \"a\"\nmsgstr \"b\"\n"}) {
    const auto file = read_po(text);
    ASSERT_FALSE(file.ok()) << text;
    EXPECT_NE(file.error().text.find("does not begin with a header"), std::string::npos);
  }
  const auto colon = read_po("msgid \"\"\nmsgstr \"Language\\n\"\n");
  ASSERT_FALSE(colon.ok());
  EXPECT_NE(colon.error().text.find("no colon"), std::string::npos);
}

TEST(PoFile, DamagedFilesAreReadOrRefused) {
  int refused = 0, read = 0;
  test::for_random(4002, 500, [&](std::mt19937_64& rng) {
    const std::string text = test::mutated(rng, po_header + po_entries);
    const auto file = read_po(text);
    if (!file.ok()) {
      ++refused;
      EXPECT_TRUE(file.error().text.starts_with("Line ")) << file.error().text;
      return;
    }
    ++read;
    std::size_t size = 0;
    for (const PoEntry& entry : file->entries) {
      EXPECT_FALSE(entry.text.empty());
      EXPECT_FALSE(entry.translations.empty());
      for (const std::string& each : entry.translations) size += each.size();
    }
    EXPECT_LE(size, text.size());
  });
  EXPECT_GT(refused, 0);
  EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace hariko

// Lines of sentences: nothing is lost, nothing is too wide, and Japanese keeps its rules for ends of lines.

#include "ui/base/text_lines.hpp"

#include "tests/support/random.hpp"
#include "ui/base/language.hpp"

namespace hariko::test {
namespace {

/// Latin letters are 1 wide, Japanese characters 2.
float width_of(std::string_view text) {
  float width = 0;
  for (const char32_t c : code_points(text)) width += c < 0x2000 ? 1 : 2;
  return width;
}

std::vector<std::string> lines(std::string_view text, float width) {
  return lines_of(text, width, width_of);
}

TEST(TextLines, EnglishBreaksAtSpaces) {
  EXPECT_EQ(lines("The same with its concave faces decomposed", 22),
            (std::vector<std::string>{"The same with its", "concave faces", "decomposed"}));
  EXPECT_EQ(lines("short", 22), std::vector<std::string>{"short"});
  EXPECT_EQ(lines("", 22), std::vector<std::string>{""});
  EXPECT_EQ(lines("one\n\ntwo", 22), (std::vector<std::string>{"one", "", "two"}));
  EXPECT_EQ(lines("incomprehensibilities are", 8),
            (std::vector<std::string>{"incomprehensibilities", "are"}));
}

TEST(TextLines, JapaneseBreaksBetweenCharactersButKeepsItsRules) {
  // The full stop would be alone on the second line.
  EXPECT_EQ(lines("\u9762\u3092\u9078\u3076\u3002", 8),
            (std::vector<std::string>{"\u9762\u3092\u9078", "\u3076\u3002"}));
  // A long vowel and a small letter belong to what is before them, a bracket to what comes after it.
  EXPECT_EQ(lines("\u9762\u30a8\u30c3\u30b8", 4),
            (std::vector<std::string>{"\u9762", "\u30a8\u30c3", "\u30b8"}));
  EXPECT_EQ(lines("\u9762\u9762\u300c\u9762\u300d", 6),
            (std::vector<std::string>{"\u9762\u9762", "\u300c\u9762\u300d"}));
  // Words of another script stay whole.
  EXPECT_EQ(lines("\u9762\u9762Hariko\u9762", 8), (std::vector<std::string>{"\u9762\u9762", "Hariko\u9762"}));
}

TEST(TextLines, RandomSentencesLoseNothingAndFit) {
  const std::vector<std::string> pieces{"\u9762", "\u3092", "\u30fc", "\u3002", "\u300c", "\u300d", "\u30c3",
                                        "edge",   " ",      "Ctrl+Z", "(",      ")",      "12.5",   "\n"};
  for_random(417, 300, [&](std::mt19937_64& rng) {
    std::string text;
    for (int i = uniform_int(rng, 1, 40); i > 0; --i)
      text += pieces[std::size_t(uniform_int(rng, 0, int(pieces.size()) - 1))];
    const float width = static_cast<float>(uniform_int(rng, 4, 30));
    const auto strip = [](std::string_view whole) {
      std::string out;
      for (const char c : whole)
        if (c != ' ' && c != '\n') out += c;
      return out;
    };
    std::string joined;
    for (const std::string& line : lines(text, width)) {
      joined += line;
      // Too wide is only what cannot be cut: no second place to break at within it.
      if (width_of(line) > width) {
        EXPECT_EQ(lines(line, 1).size(), 1U) << line;
      }
      for (const char* wrong : {"\u3002", "\u30fc", "\u300d", "\u30c3"})
        if (line.starts_with(wrong) && text.find(std::string("\n") + wrong) == std::string::npos &&
            text.find(std::string(" ") + wrong) == std::string::npos && !text.starts_with(wrong))
          ADD_FAILURE() << "a line begins with " << wrong << ": " << text;
    }
    EXPECT_EQ(strip(joined), strip(text));
  });
}

}  // namespace
}  // namespace hariko::test

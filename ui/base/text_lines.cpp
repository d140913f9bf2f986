#include "ui/base/text_lines.hpp"

#include <imgui_internal.h>
#include <array>
#include <ctime>

#include <algorithm>

#include "ui/base/fonts.hpp"

namespace hariko {

namespace {

// JIS X 4051 in the part that sentences of an interface need.
constexpr std::u32string_view never_first =
    U"\u3001\u3002\uff0c\uff0e\u30fb\uff1a\uff1b\uff1f\uff01\u300d\u300f\uff09\u3011\u3015\u3009\u300b"
    U"\u30fc\u2026\u3005\u3041\u3043\u3045\u3047\u3049\u3063\u3083\u3085\u3087\u308e"
    U"\u30a1\u30a3\u30a5\u30a7\u30a9\u30c3\u30e3\u30e5\u30e7\u30ee)]}.,:;?!%";
constexpr std::u32string_view never_last = U"\u300c\u300e\uff08\u3010\u3014\u3008\u300a([{";

bool is_one_of(std::u32string_view set, char32_t character) {
  return set.find(character) != std::u32string_view::npos;
}

struct Character {
  char32_t code = 0;
  std::size_t begin = 0, end = 0;  ///< bytes
};

std::vector<Character> characters_of(std::string_view text) {
  std::vector<Character> out;
  for (std::size_t i = 0; i < text.size();) {
    unsigned code = 0;
    const int length = std::max(1, ImTextCharFromUtf8(&code, text.data() + i, text.data() + text.size()));
    out.push_back({code, i, std::min(text.size(), i + static_cast<std::size_t>(length))});
    i = out.back().end;
  }
  return out;
}

bool may_break(char32_t before, char32_t after) {
  if (after == U' ' || after == U'\u3000') return false;  // the space stays with what it ends
  if (before == U' ' || before == U'\u3000') return true;
  if (!needs_japanese_font(before) && !needs_japanese_font(after)) return false;
  return !is_one_of(never_first, after) && !is_one_of(never_last, before);
}

std::string_view without_end(std::string_view line) {
  while (!line.empty() && line.back() == ' ') line.remove_suffix(1);
  return line;
}

void cut_paragraph(std::string_view text, float width, const MeasureText& measure,
                   std::vector<std::string>& lines) {
  const auto characters = characters_of(text);
  std::size_t begin = 0, fits = 0;  // bytes of the line so far, and where it may end
  for (std::size_t i = 1; i <= characters.size(); ++i) {
    const bool end = i == characters.size();
    if (!end && !may_break(characters[i - 1].code, characters[i].code)) continue;
    const std::size_t here = characters[i - 1].end;
    if (fits > begin && measure(without_end(text.substr(begin, here - begin))) > width) {
      lines.emplace_back(without_end(text.substr(begin, fits - begin)));
      begin = fits;
    }
    fits = here;
  }
  lines.emplace_back(without_end(text.substr(begin)));
}

float imgui_width(std::string_view text) {
  return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

}  // namespace

std::vector<std::string> lines_of(std::string_view text, float width, const MeasureText& measure) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    cut_paragraph(text.substr(begin, end - begin), width, measure, lines);
    begin = end + 1;
  }
  return lines;
}

std::string in_lines(std::string_view text, float width, std::size_t most) {
  auto lines = lines_of(text, width, imgui_width);
  if (lines.size() > most) {
    lines.resize(most);
    std::string& last = lines.back();
    constexpr std::string_view ellipsis = "\u2026";
    for (auto characters = characters_of(last);
         !characters.empty() && imgui_width(last + std::string(ellipsis)) > width; characters.pop_back())
      last.resize(characters.back().begin);
    last += ellipsis;
  }
  std::string joined;
  for (const std::string& line : lines) joined += (joined.empty() ? "" : "\n") + line;
  return joined;
}

std::string local_time_text(std::int64_t unix_seconds) {
  const auto time = static_cast<std::time_t>(unix_seconds);
  std::tm local{};
  if (!::localtime_r(&time, &local)) return {};
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local)};
}

}  // namespace hariko

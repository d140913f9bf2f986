#include "core/cad/kernel/cad_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "core/cad/kernel/read_cad_file.hpp"

namespace hariko {

namespace {

constexpr std::string_view blanks = " \t\r\n";

Message no_step(std::string text) {
  return make_error(e_cad_read, std::move(text), "Export the model as STEP again.");
}

Message no_iges(std::string text) {
  return make_error(e_cad_read, std::move(text), "Export the model as IGES again, or as STEP.");
}

/// Behind a string or a comment that begins at `at`; the end of the text where it does not end. `at` itself
/// where none begins there.
std::size_t skip_quoted(std::string_view text, std::size_t at) {
  if (text[at] == '\'') return std::min(text.find('\'', at + 1), text.size() - 1) + 1;
  if (text.substr(at, 2) == "/*") {
    const std::size_t end = text.find("*/", at + 2);
    return end == std::string_view::npos ? text.size() : end + 2;
  }
  return at;
}

constexpr std::string_view sections = "SGDPT";
constexpr std::size_t section_column = 72, line_length = 80;

/// A whole number with blanks or zeros before it.
std::optional<long> number_in(std::string_view field) {
  field.remove_prefix(std::min(field.find_first_not_of(' '), field.size()));
  long out = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), out);
  if (error != std::errc() || end != field.data() + field.size()) return {};
  return out;
}

/// "S      1G      3D      8P     20": the numbers of lines that the last line gives.
bool agrees(std::string_view last, const std::array<long, 5>& counts) {
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string_view field = last.substr(8 * k, 8);
    if (field[0] != sections[k] || number_in(field.substr(1)) != counts[k]) return false;
  }
  return true;
}

}  // namespace

std::optional<Message> check_step_text(std::string_view text) {
  constexpr std::string_view first = "ISO-10303-21", last = "END-ISO-10303-21";
  std::size_t at = 0;
  while ((at = text.find_first_not_of(blanks, at)) != std::string_view::npos && text.substr(at, 2) == "/*")
    at = skip_quoted(text, at);
  if (at == std::string_view::npos || !text.substr(at).starts_with(first))
    return no_step("This is no STEP file: it does not begin with \"ISO-10303-21\".");
  constexpr int most = 100;
  int depth = 0;
  bool ended = false;
  while (at < text.size() && !ended) {
    if (const std::size_t behind = skip_quoted(text, at); behind != at) {
      at = behind;
      continue;
    }
    if (text[at] == '(' && ++depth > most) return no_step("Lists in the STEP file are nested too deeply.");
    if (text[at] == ')') --depth;
    ended = text[at] == 'E' && text.substr(at).starts_with(last);
    ++at;
  }
  if (!ended) return no_step("The STEP file is cut off: it does not end with \"END-ISO-10303-21\".");
  return {};
}

std::optional<Message> check_iges_text(std::string_view text) {
  std::array<long, 5> counts{};
  std::size_t section = 0;
  std::string_view last;
  for (long number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    while (!line.empty() && (line.back() == '\r' || line.back() == '\x1a')) line.remove_suffix(1);
    if (counts[4] > 0) {  // what is behind the end does not matter
      if (line.find_first_not_of(blanks) == std::string_view::npos) continue;
      return no_iges("The IGES file goes on behind its last line.");
    }
    if (line.size() < line_length)
      return no_iges("Line " + std::to_string(number) +
                     " of the IGES file has no 80 columns: it is cut off, or of another format.");
    const std::size_t found = sections.find(line[section_column]);
    if (found == std::string_view::npos || found < section || (number == 1 && found != 0))
      return no_iges("Line " + std::to_string(number) +
                     " of the IGES file does not say in its 73rd column to which section it belongs.");
    section = found;
    if (number_in(line.substr(section_column + 1, 7)) != ++counts[section])
      return no_iges("Line " + std::to_string(number) +
                     " of the IGES file does not have the number that comes next.");
    last = line;
  }
  if (counts[4] != 1) return no_iges("The IGES file is cut off: it has no last line.");
  if (!agrees(last, counts) || counts[2] % 2 != 0)
    return no_iges("Parts of the IGES file are missing: its last line gives other numbers of lines.");
  return {};
}

}  // namespace hariko

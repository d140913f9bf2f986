#include "core/cad/kernel/cad_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include "core/cad/kernel/cad_letters.hpp"
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

/// Position behind a string or a comment that begins at `at`; the end of the text where it is not closed;
/// `at` itself where none begins there.
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

/// Whole number, with blanks or zeros before it.
std::optional<long> number_in(std::string_view field) {
  field.remove_prefix(std::min(field.find_first_not_of(' '), field.size()));
  long out = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), out);
  if (error != std::errc() || end != field.data() + field.size()) return {};
  return out;
}

/// Whether the last line ("S   1G   3D   8P  20") gives the right numbers of lines.
bool agrees(std::string_view last, const std::array<long, 5>& counts) {
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string_view field = last.substr(8 * k, 8);
    if (field[0] != sections[k] || number_in(field.substr(1)) != counts[k]) return false;
  }
  return true;
}

/// Lines of an IGES file, with their cross references: two lines of the directory point to their lines of
/// parameters, and these point back.
class IgesLines {
 public:
  /// Checks the next line, without its line end; returns the error, or nothing.
  std::optional<Message> take(std::string_view line) {
    const std::string name = "Line " + std::to_string(++number_) + " of the IGES file ";
    if (line.size() < line_length)
      return no_iges(name + "has no 80 columns: it is cut off, or of another format.");
    const std::size_t found = sections.find(line[section_column]);
    if (found == std::string_view::npos || found < section_ || (number_ == 1 && found != 0))
      return no_iges(name + "does not say in its 73rd column to which section it belongs.");
    section_ = found;
    if (number_in(line.substr(section_column + 1, 7)) != ++counts_[found])
      return no_iges(name + "does not have the number that comes next.");
    refer(line);
    last_ = line;
    return {};
  }

  bool ended() const { return counts_[4] > 0; }
  bool counts_agree() const { return agrees(last_, counts_); }
  /// Whether the file ends where it should and no line refers to a missing one.
  bool whole() const {
    return counts_[4] == 1 && counts_[2] % 2 == 0 && last_directory_ <= counts_[2] &&
           last_parameters_ <= counts_[3] && global_ends_;
  }

 private:
  void refer(std::string_view line) {
    const auto field = [&](std::size_t k) { return number_in(line.substr(8 * k, 8)).value_or(0); };
    switch (section_) {
      case 1:
        take_global(line.substr(0, section_column));
        break;
      case 2:
        if (counts_[2] % 2 == 1)
          parameters_ = field(1);
        else
          last_parameters_ = std::max(last_parameters_, parameters_ + std::max(field(3), 1L) - 1);
        break;
      case 3:
        last_directory_ = std::max(last_directory_, number_in(line.substr(65, 7)).value_or(0) + 1);
        break;
      default:
        break;
    }
  }
  /// Looks for the end of the global section: its delimiter, which its first two parameters may change
  /// ("1H,,1H;,").
  void take_global(std::string_view part) {
    if (counts_[1] == 1 && part.starts_with("1H")) {
      const std::string_view second = part.substr(3 + (part[3] == part[2] ? 1 : 0));
      if (second.starts_with("1H")) delimiter_ = second[2];
    }
    const std::size_t end = part.find_last_not_of(' ');
    global_ends_ = end != std::string_view::npos && part[end] == delimiter_;
  }

  std::array<long, 5> counts_{};
  std::size_t section_ = 0;
  long number_ = 0, parameters_ = 0, last_parameters_ = 0, last_directory_ = 0;
  char delimiter_ = ';';
  bool global_ends_ = false;
  std::string_view last_;
};

Message behind(const char* format) {
  return make_warning(w_cad_behind, std::string("Text stands behind the end of the ") + format + " file.",
                      "What it says is not read; export the model again if something is missing.");
}

/// Warnings about changes made to the text before it was checked.
std::vector<Message> warnings_of(const DecodedText& decoded, const char* format) {
  std::vector<Message> out;
  if (decoded.marked)
    out.push_back(make_warning(
        w_cad_mark,
        std::string("The ") + format + " file begins with a byte order mark, which such files do not have.",
        "Save it as plain text where it was edited."));
  if (decoded.guessed > 0)
    out.push_back(make_warning(w_cad_letters,
                               std::to_string(decoded.guessed) + " letters of the " + format +
                                   " file are in an old encoding that it does not name" +
                                   (decoded.japanese ? " (taken for Shift-JIS)" : "") +
                                   ": names may have wrong letters.",
                               "Check the names, or export the model in UTF-8."));
  return out;
}

Result<CadText> prepared(DecodedText decoded, const char* format,
                         Result<CadTextExtent> (*check)(std::string_view)) {
  CadText out{{}, decoded.marked || decoded.guessed > 0, warnings_of(decoded, format)};
  const auto extent = check(decoded.text);
  if (!extent.ok()) return extent.error();
  out.text = std::move(decoded.text);
  if (extent->more_follows) {
    out.text.resize(extent->end);
    out.changed = true;
    out.warnings.push_back(behind(format));
  }
  if (!extent->counts_agree)
    out.warnings.push_back(make_warning(w_cad_counts,
                                        "The last line of the IGES file gives other numbers of lines than "
                                        "there are; none of those that are needed is missing.",
                                        "Export the model again if something is missing."));
  return out;
}

}  // namespace

Result<CadTextExtent> check_step_text(std::string_view text) {
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
    at += ended ? last.size() : 1;
  }
  if (!ended) return no_step("The STEP file is cut off: it does not end with \"END-ISO-10303-21\".");
  while (at < text.size() && (text[at] == ';' || blanks.find(text[at]) != std::string_view::npos)) ++at;
  return CadTextExtent{at, true, at < text.size() && !text.substr(at).starts_with("SIGNATURE")};
}

Result<CadTextExtent> check_iges_text(std::string_view text) {
  const std::size_t size = text.size();
  IgesLines lines;
  while (!text.empty() && !lines.ended()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    while (!line.empty() && (line.back() == '\r' || line.back() == '\x1a')) line.remove_suffix(1);
    if (auto wrong = lines.take(line)) return *wrong;
  }
  if (!lines.ended()) return no_iges("The IGES file is cut off: it has no last line.");
  if (!lines.whole()) return no_iges("Lines of the IGES file are missing: others refer to them.");
  return CadTextExtent{size - text.size(), lines.counts_agree(),
                       text.find_first_not_of(" \t\r\n\x1a") != std::string_view::npos};
}

Result<CadText> step_text_of(std::string bytes) {
  return prepared(decoded(std::move(bytes), StrayBytes::letters), "STEP", check_step_text);
}

Result<CadText> iges_text_of(std::string bytes) {
  return prepared(decoded(std::move(bytes), StrayBytes::question_mark), "IGES", check_iges_text);
}

}  // namespace hariko

#include "core/base/text/po_file.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/base/text/utf8.hpp"

namespace hariko {

namespace {

constexpr std::string_view line_blanks = " \t\f\v";

std::string_view trimmed_line(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(line_blanks);
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(line_blanks) - begin + 1);
}

bool all_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

/// Letter that stands behind a backslash for a character; 0 where there is none.
char escaped_character(char letter) {
  switch (letter) {
    case 'n':
      return '\n';
    case 't':
      return '\t';
    case 'r':
      return '\r';
    case '"':
    case '\\':
      return letter;
    default:
      return 0;
  }
}

/// Reads one line after the other.
class PoReader {
 public:
  explicit PoReader(std::string_view bytes) : rest_(bytes) {}

  Result<PoFile> read() {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (rest_.starts_with(mark)) rest_.remove_prefix(mark.size());
    while (!rest_.empty() && !error_) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++line_;
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (!all_utf8(line))
        refuse("The line is not UTF-8.");
      else
        take(trimmed_line(line));
    }
    if (!error_) finish_entry();
    if (!error_ && !has_header_) refuse("The file does not begin with a header.", 1);
    if (error_) return *std::move(error_);
    return std::move(file_);
  }

 private:
  /// Part of an entry that the next quoted text belongs to.
  enum class Part { none, context, text, plural, translation };

  void take(std::string_view line) {
    if (line.empty()) return;
    if (line.front() == '#') return comment(line);
    if (line.front() == '"') {
      if (part_ == Part::none) return refuse("The text belongs to no entry.");
      return append(line);
    }
    const std::size_t end = std::min(line.find_first_of(" \t\""), line.size());
    const std::string_view word = line.substr(0, end);
    if (!begin(word)) return;
    append(trimmed_line(line.substr(end)));
  }

  void comment(std::string_view line) {
    // A comment stands before its entry.
    if (part_ == Part::translation) finish_entry();
    if (line.starts_with("#,") && line.find("fuzzy") != std::string_view::npos) fuzzy_ = true;
  }

  /// Begins a part of an entry. False, with an error, where it cannot stand there.
  bool begin(std::string_view word) {
    const bool opens = word == "msgctxt" || word == "msgid";
    if (opens && part_ == Part::translation) finish_entry();
    if (error_) return false;
    if (opens && part_ == Part::none) {
      entry_.line = line_;
      entry_.fuzzy = std::exchange(fuzzy_, false);
    }
    if (word == "msgctxt") return go_on(part_ == Part::none, Part::context);
    if (word == "msgid") return go_on(part_ == Part::none || part_ == Part::context, Part::text);
    if (word == "msgid_plural") {
      has_plural_ = true;
      return go_on(part_ == Part::text, Part::plural);
    }
    if (word.starts_with("msgstr")) return begin_translation(word);
    refuse("The word " + shortened(word, 40) + " is none of a catalogue.");
    return false;
  }

  bool begin_translation(std::string_view word) {
    const std::size_t number = entry_.translations.size();
    const bool expected = has_plural_ ? word == "msgstr[" + std::to_string(number) + "]" : word == "msgstr";
    const bool after =
        has_plural_ ? part_ == Part::plural || part_ == Part::translation : part_ == Part::text;
    if (!go_on(expected && after, Part::translation)) return false;
    entry_.translations.emplace_back();
    return true;
  }

  bool go_on(bool possible, Part part) {
    if (!possible) {
      refuse(
          "This word cannot stand here: an entry has msgctxt, msgid, msgid_plural and msgstr, in this "
          "order.");
      return false;
    }
    part_ = part;
    return true;
  }

  std::string& target() {
    switch (part_) {
      case Part::context:
        return entry_.context;
      case Part::plural:
        return entry_.plural;
      case Part::translation:
        return entry_.translations.back();
      default:
        return entry_.text;
    }
  }

  /// Appends a text between quotation marks to the part that is being read.
  void append(std::string_view quoted) {
    if (quoted.empty() || quoted.front() != '"') return refuse("A text in quotation marks is missing.");
    std::string& out = target();
    for (std::size_t i = 1; i < quoted.size(); ++i) {
      if (quoted[i] == '"') {
        if (i + 1 != quoted.size())
          refuse("Something follows the text. Write \\\" for a quotation mark in it.");
        return;
      }
      if (quoted[i] != '\\') {
        out += quoted[i];
        continue;
      }
      const char character = i + 1 < quoted.size() ? escaped_character(quoted[i + 1]) : '\0';
      if (character == 0) return refuse("A backslash may stand before n, t, r, \\ and \" only.");
      out += character;
      ++i;
    }
    refuse("The text has no closing quotation mark.");
  }

  void finish_entry() {
    if (part_ == Part::none) return;
    if (part_ != Part::translation) return refuse("The entry has no msgstr.", entry_.line);
    if (has_plural_ && entry_.plural.empty()) return refuse("The plural of the entry is empty.", entry_.line);
    PoEntry done = std::exchange(entry_, {});
    part_ = Part::none;
    has_plural_ = false;
    if (done.text.empty()) return take_header(done);
    if (!has_header_) return refuse("The file does not begin with a header.", done.line);
    if (!known_.emplace(done.context, done.text).second)
      return refuse("There is another entry with this text.", done.line);
    file_.entries.push_back(std::move(done));
  }

  void take_header(const PoEntry& entry) {
    if (has_header_ || !entry.context.empty()) return refuse("An entry has an empty text.", entry.line);
    has_header_ = true;
    std::string_view lines = entry.translations.front();
    while (!lines.empty()) {
      const std::size_t end = std::min(lines.find('\n'), lines.size());
      const std::string_view field = lines.substr(0, end);
      lines.remove_prefix(std::min(end + 1, lines.size()));
      const std::size_t colon = field.find(':');
      if (colon == std::string_view::npos) return refuse("A line of the header has no colon.", entry.line);
      file_.header.insert_or_assign(std::string(trimmed_line(field.substr(0, colon))),
                                    std::string(trimmed_line(field.substr(colon + 1))));
    }
  }

  void refuse(const std::string& sentence) { refuse(sentence, line_); }
  void refuse(const std::string& sentence, std::size_t line) {
    if (error_) return;
    error_ = make_error(e_catalogue, "Line " + std::to_string(line) + ": " + sentence, catalogue_remedy,
                        {Element::Kind::line, line});
  }

  std::string_view rest_;
  std::size_t line_ = 0;
  PoFile file_;
  PoEntry entry_;
  Part part_ = Part::none;
  bool has_plural_ = false, has_header_ = false;
  bool fuzzy_ = false;  ///< the next entry is
  std::set<std::pair<std::string, std::string>> known_;
  std::optional<Message> error_;
};

}  // namespace

bool PoEntry::translated() const {
  return !fuzzy && std::none_of(translations.begin(), translations.end(),
                                [](const std::string& each) { return each.empty(); });
}

Result<PoFile> read_po(std::string_view bytes) {
  return PoReader(bytes).read();
}

}  // namespace hariko

#pragma once

// TextScanner: tokens and lines of a text file, with the place of each for messages. Internal to
// core/exchange.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.hpp"
#include "core/base/result.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Lines end in LF, CRLF or CR. Tokens are separated by spaces and tabs. A `#` starts a comment up to the
/// line's end when `comments` is set; a backslash before a line's end joins the lines when `continuation` is
/// set. A byte order mark at the start is skipped. O(1) memory; every call that reads moves forward or
/// returns "nothing".
class TextScanner {
 public:
  struct Options {
    bool comments = false;
    bool continuation = false;
  };
  TextScanner(std::string_view text, Options options);

  /// The next token of the current (joined) line; empty at its end.
  std::string_view token() {
    do {
      skip_blanks();
      token_begin_ = cursor_;
      while (cursor_ != end_ && !ends_token(*cursor_)) ++cursor_;
      if (!options_.continuation) break;
      if (cursor_ != token_begin_ && cursor_[-1] == '\\' && at_line_break()) --cursor_;
    } while (cursor_ == token_begin_ && joins_lines());
    return {token_begin_, static_cast<std::size_t>(cursor_ - token_begin_)};
  }
  /// Moves behind the end of the current (joined) line. False when the file ends here.
  bool next_line();
  /// Moves to the next line that has a token, counting the current one; false when there is none.
  bool find_content();
  /// The rest of the current line as it stands, without blanks at its ends; comments are part of it.
  std::string_view rest_of_line();

  bool at_end() const { return cursor_ == end_; }
  std::size_t line() const { return line_; }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - cursor_); }
  const char* position() const { return cursor_; }
  std::string_view last_token() const {
    return {token_begin_, static_cast<std::size_t>(cursor_ - token_begin_)};
  }

  /// An error at the last token: "Line 7, column 3: " and the sentence.
  Message error_here(Code code, const std::string& sentence, const std::string& remedy = {}) const;
  /// An error about a line as a whole.
  static Message error_at_line(Code code, std::size_t line, const std::string& sentence,
                               const std::string& remedy = {});

  /// E_TRUNCATED: the file ends although `what` should follow.
  Message file_ends(const char* what) const;

  /// Reads the next token as a finite number; `what` is its name in the message.
  std::optional<Message> read_real(const char* what, double& value);
  std::optional<Message> read_point(const char* what, Vector3& point);
  std::optional<Message> read_integer(const char* what, std::int64_t& value);

 private:
  bool ends_token(char c) const {
    return c == ' ' || (c <= '\r' && c >= '\t') || (c == '#' && options_.comments);
  }
  void skip_blanks() {
    while (cursor_ != end_ && (*cursor_ == ' ' || *cursor_ == '\t' || *cursor_ == '\v' || *cursor_ == '\f'))
      ++cursor_;
  }
  bool at_line_break() const { return cursor_ != end_ && (*cursor_ == '\n' || *cursor_ == '\r'); }
  bool joins_lines();
  void skip_line_break();

  const char* begin_;
  const char* cursor_;
  const char* end_;
  const char* token_begin_;
  const char* line_begin_;
  std::size_t line_ = 1;
  Options options_;
};

/// `text` in quotes, short and printable, for messages.
std::string quote(std::string_view text);

}  // namespace hariko

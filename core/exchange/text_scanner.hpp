#pragma once

// TextScanner: tokens and lines of a text file, with their positions for messages. Internal to core/exchange.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.hpp"
#include "core/base/result.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Scanner of lines that end in LF, CRLF or CR and tokens separated by spaces and tabs. With `comments` a `#`
/// starts a comment up to the line end; with `continuation` a backslash before a line end joins the lines. A
/// byte order mark at the start is skipped. O(1) memory; every call that reads moves forward or returns
/// "nothing".
class TextScanner {
 public:
  struct Options {
    bool comments = false;
    bool continuation = false;
  };
  TextScanner(std::string_view text, Options options);

  /// Next token of the current (joined) line; empty at its end.
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
  /// Moves past the end of the current (joined) line; false where the file ends here.
  bool next_line();
  /// Moves to the next line with a token, the current one included; false where there is none.
  bool find_content();
  /// Rest of the current line, without blanks at its ends; comments are part of it.
  std::string_view rest_of_line();

  bool at_end() const { return cursor_ == end_; }
  std::size_t line() const { return line_; }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - cursor_); }
  const char* position() const { return cursor_; }
  /// Token that was read last.
  std::string_view last_token() const {
    return {token_begin_, static_cast<std::size_t>(cursor_ - token_begin_)};
  }

  /// Error at the last token: "Line 7, column 3: " and the sentence.
  Message error_here(Code code, const std::string& sentence, const std::string& remedy = {}) const;
  /// Error about a whole line.
  static Message error_at_line(Code code, std::size_t line, const std::string& sentence,
                               const std::string& remedy = {});

  /// E_TRUNCATED: the file ends where `what` should follow.
  Message file_ends(const char* what) const;

  /// Reads the next token as a finite number; `what` names it in the message. Errors: E_PARSE, E_TRUNCATED.
  std::optional<Message> read_real(const char* what, double& value);
  /// Reads as `read_real`, but gives NaN for words such as "nan" and "inf".
  std::optional<Message> read_any_real(const char* what, double& value);
  /// Reads three numbers; errors as `read_real`.
  std::optional<Message> read_point(const char* what, Vector3& point);
  /// Reads the next token as an integer; errors as `read_real`.
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

/// Text in quotes, shortened and printable, for messages.
std::string quote(std::string_view text);

}  // namespace hariko

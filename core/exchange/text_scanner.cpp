#include "core/exchange/text_scanner.hpp"

#include <cmath>
#include <limits>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/number_text.hpp"

namespace hariko {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::string number_sentence(NumberStatus status, const char* what, std::string_view token) {
  switch (status) {
    case NumberStatus::not_finite:
      return "The " + std::string(what) + " is " + quote(token) + ", which is not finite.";
    case NumberStatus::too_large:
      return "The " + std::string(what) + " " + quote(token) + " is too large.";
    default:
      if (token.empty()) return "The " + std::string(what) + " is missing.";
      return "The " + std::string(what) + " should be a number, but is " + quote(token) + ".";
  }
}

std::string number_remedy(std::string_view token) {
  if (token.find(',') != std::string_view::npos) return "Write numbers with a decimal point, not a comma.";
  return "Correct the line, or export the file again.";
}

}  // namespace

std::string quote(std::string_view text) {
  return "\"" + shortened(text, 120) + "\"";
}

TextScanner::TextScanner(std::string_view text, Options options)
    : begin_(text.data()), cursor_(begin_), end_(begin_ + text.size()), options_(options) {
  if (text.starts_with(byte_order_mark)) cursor_ += byte_order_mark.size();
  token_begin_ = line_begin_ = cursor_;
}

void TextScanner::skip_line_break() {
  if (*cursor_ == '\r' && cursor_ + 1 != end_ && cursor_[1] == '\n') ++cursor_;
  ++cursor_;
  ++line_;
  line_begin_ = cursor_;
}

bool TextScanner::joins_lines() {
  if (cursor_ == end_ || *cursor_ != '\\' || cursor_ + 1 == end_) return false;
  if (cursor_[1] != '\n' && cursor_[1] != '\r') return false;
  ++cursor_;
  skip_line_break();
  return true;
}

bool TextScanner::next_line() {
  bool comment = false;
  while (cursor_ != end_) {
    if (at_line_break()) {
      skip_line_break();
      return true;
    }
    if (*cursor_ == '#' && options_.comments) comment = true;  // a comment cannot be continued
    if (comment || !options_.continuation || !joins_lines()) ++cursor_;
  }
  return false;
}

bool TextScanner::find_content() {
  do {
    skip_blanks();
    while (options_.continuation && joins_lines()) skip_blanks();
    if (cursor_ != end_ && !ends_token(*cursor_)) return true;
  } while (next_line());
  return false;
}

std::string_view TextScanner::rest_of_line() {
  skip_blanks();
  const char* begin = cursor_;
  while (cursor_ != end_ && !at_line_break()) ++cursor_;
  const char* last = cursor_;
  while (last != begin && (last[-1] == ' ' || last[-1] == '\t')) --last;
  return {begin, static_cast<std::size_t>(last - begin)};
}

Message TextScanner::error_here(Code code, const std::string& sentence, const std::string& remedy) const {
  const std::size_t column =
      token_begin_ < line_begin_ ? 1 : static_cast<std::size_t>(token_begin_ - line_begin_) + 1;
  return make_error(code,
                    "Line " + std::to_string(line_) + ", column " + std::to_string(column) + ": " + sentence,
                    remedy, {Element::Kind::line, line_});
}

Message TextScanner::error_at_line(Code code, std::size_t line, const std::string& sentence,
                                   const std::string& remedy) {
  return make_error(code, "Line " + std::to_string(line) + ": " + sentence, remedy,
                    {Element::Kind::line, line});
}

Message TextScanner::file_ends(const char* what) const {
  return error_here(e_truncated, "The file ends where the " + std::string(what) + " should be.",
                    "The file was cut off: copy or export it again.");
}

std::optional<Message> TextScanner::read_real(const char* what, double& value) {
  auto error = read_any_real(what, value);
  if (error || !std::isnan(value)) return error;
  const std::string_view text = last_token();
  return error_here(e_parse, number_sentence(NumberStatus::not_finite, what, text), number_remedy(text));
}

std::optional<Message> TextScanner::read_any_real(const char* what, double& value) {
  const std::string_view text = token();
  const NumberStatus status = parse_real(text, value);
  if (status == NumberStatus::ok) return {};
  if (status == NumberStatus::not_finite) {
    value = std::numeric_limits<double>::quiet_NaN();
    return {};
  }
  if (text.empty() && at_end()) return file_ends(what);
  return error_here(e_parse, number_sentence(status, what, text), number_remedy(text));
}

std::optional<Message> TextScanner::read_point(const char* what, Vector3& point) {
  for (int axis = 0; axis < 3; ++axis)
    if (auto error = read_real(what, point[axis])) return error;
  return {};
}

std::optional<Message> TextScanner::read_integer(const char* what, std::int64_t& value) {
  const std::string_view text = token();
  const NumberStatus status = parse_integer(text, value);
  if (status == NumberStatus::ok) return {};
  if (text.empty() && at_end()) return file_ends(what);
  if (status == NumberStatus::too_large)
    return error_here(e_limit, number_sentence(status, what, text), "Reduce the model before importing it.");
  return error_here(e_parse, number_sentence(status, what, text), number_remedy(text));
}

}  // namespace hariko

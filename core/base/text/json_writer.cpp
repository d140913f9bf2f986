#include "core/base/text/json_writer.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/text/utf8.hpp"

namespace hariko {

namespace {

template <class Number>
void append_integer_text(std::string& out, Number value) {
  std::array<char, 24> digits;
  out.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

/// Decimal digits, and the power of ten of the first one: 1.25e3 is {"125", 3}.
struct Decimal {
  std::string digits;
  int exponent = 0;
};

Decimal shortest_decimal(double magnitude) {
  std::array<char, 32> buffer;
  const char* end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), magnitude, std::chars_format::scientific)
          .ptr;
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  const std::size_t e = text.find('e');
  Decimal out;
  for (const char c : text.substr(0, e))
    if (c != '.') out.digits += c;
  const std::string_view power = text.substr(text[e + 1] == '+' ? e + 2 : e + 1);
  std::from_chars(power.data(), power.data() + power.size(), out.exponent);
  return out;
}

/// Appends a real number so that it cannot be taken for an integer: with a point or an exponent. Without an
/// exponent from 1e-4 to 1e15.
void append_real_text(std::string& out, double value) {
  if (std::signbit(value)) out += '-';
  if (value == 0) {
    out += "0.0";
    return;
  }
  const auto [digits, exponent] = shortest_decimal(std::abs(value));
  const int count = static_cast<int>(digits.size()), whole = exponent + 1;  // digits before the point
  if (whole >= count && whole <= 15) {
    out += digits + std::string(static_cast<std::size_t>(whole - count), '0') + ".0";
  } else if (whole > 0 && whole <= 15) {
    out += digits.substr(0, static_cast<std::size_t>(whole)) + '.' +
           digits.substr(static_cast<std::size_t>(whole));
  } else if (whole > -4 && whole <= 0) {
    out += "0." + std::string(static_cast<std::size_t>(-whole), '0') + digits;
  } else {
    out += digits[0];
    if (count > 1) out += '.' + digits.substr(1);
    out += exponent < 0 ? "e-" : "e+";
    if (std::abs(exponent) < 10) out += '0';
    append_integer_text(out, std::abs(exponent));
  }
}

}  // namespace

void JsonWriter::value(std::nullptr_t) {
  begin_value();
  text_ += "null";
}

void JsonWriter::value(bool value) {
  begin_value();
  text_ += value ? "true" : "false";
}

void JsonWriter::value(double value) {
  begin_value();
  if (std::isfinite(value))
    append_real_text(text_, value);
  else
    text_ += "null";
}

void JsonWriter::value(std::string_view value) {
  begin_value();
  quoted(value);
}

void JsonWriter::value(const Vector3& value) {
  array([&] {
    for (const double x : {value.x(), value.y(), value.z()}) this->value(x);
  });
}

void JsonWriter::raw(std::string_view json) {
  begin_value();
  text_ += json;
}

void JsonWriter::integer(std::int64_t value) {
  begin_value();
  append_integer_text(text_, value);
}

void JsonWriter::integer(std::uint64_t value) {
  begin_value();
  append_integer_text(text_, value);
}

void JsonWriter::key(std::string_view name) {
  begin_entry();
  quoted(name);
  text_ += indent_ < 0 ? ":" : ": ";
  has_key_ = true;
}

void JsonWriter::open(char bracket) {
  begin_value();
  text_ += bracket;
  ++depth_;
  empty_ = true;
}

void JsonWriter::close(char bracket) {
  --depth_;
  if (!empty_) line();
  text_ += bracket;
  empty_ = false;
}

void JsonWriter::begin_entry() {
  if (!empty_) text_ += ',';
  if (depth_ > 0) line();
  empty_ = false;
}

void JsonWriter::begin_value() {
  if (!std::exchange(has_key_, false)) begin_entry();
}

void JsonWriter::line() {
  if (indent_ < 0) return;
  text_ += '\n';
  text_.append(static_cast<std::size_t>(indent_) * depth_, ' ');
}

void JsonWriter::quoted(std::string_view text) {
  constexpr std::string_view special = "\"\\\b\f\n\r\t", letters = "\"\\bfnrt", digits = "0123456789abcdef";
  text_ += '"';
  while (!text.empty()) {
    const char c = text[0];
    const std::size_t length = utf8_length(text), known = special.find(c);
    if (known != std::string_view::npos)
      (text_ += '\\') += letters[known];
    else if (static_cast<unsigned char>(c) < 0x20)
      ((text_ += "\\u00") += digits[static_cast<unsigned char>(c) / 16]) +=
          digits[static_cast<unsigned char>(c) % 16];
    else if (length == 0)
      text_ += "\uFFFD";
    else
      text_ += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  text_ += '"';
}

}  // namespace hariko

#pragma once

// DocumentText: writer of document text in a human-readable layout.

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/assert.hpp"
#include "core/base/vector.hpp"
#include "core/document/format/kept_members.hpp"

namespace hariko::detail {

/// Builds JSON text. Lists of numbers stay on one line each, every other value gets its own line.
class DocumentText {
 public:
  std::string take() {
    text_ += '\n';
    return std::move(text_);
  }

  void open(char bracket) {
    text_ += bracket;
    ++depth_;
    first_ = true;
  }
  void close(char bracket) {
    --depth_;
    if (!first_) line();
    text_ += bracket;
    first_ = false;
  }
  /// Starts the next entry of a list or object on a new line.
  void next() {
    if (!first_) text_ += ',';
    line();
    first_ = false;
  }
  void key(std::string_view name) {
    next();
    string(name);
    text_ += ": ";
  }
  void raw(std::string_view json) { text_ += json; }
  void boolean(bool value) { text_ += value ? "true" : "false"; }

  /// Writes the shortest text that reads back as the same number.
  void number(double value) {
    HARIKO_ASSERT(value - value == 0, "JSON has no number that is not finite");
    if (value == 0) {  // "-0" would read back as an integer, without its sign
      text_ += std::signbit(value) ? "-0.0" : "0";
      return;
    }
    append(value);
  }
  void number(std::uint32_t value) { append(value); }

  void string(std::string_view value) {
    text_ += '"';
    for (const char c : value) {
      if (c == '"' || c == '\\') {
        text_ += '\\';
        text_ += c;
      } else if (static_cast<unsigned char>(c) < 0x20) {
        constexpr std::string_view digits = "0123456789abcdef";
        text_ += "\\u00";
        text_ += digits[static_cast<unsigned char>(c) / 16];
        text_ += digits[static_cast<unsigned char>(c) % 16];
      } else {
        text_ += c;
      }
    }
    text_ += '"';
  }
  /// Writes [a, b, c] on one line; each entry is written by write(i).
  template <class Write>
  void row(std::size_t count, Write&& write) {
    text_ += '[';
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) text_ += ", ";
      write(i);
    }
    text_ += ']';
  }
  void vector(const Vector3& v) {
    row(3, [&](std::size_t i) { number(v[static_cast<Eigen::Index>(i)]); });
  }
  /// Writes kept members, byte for byte.
  void kept(const KeptMembers& members) {
    for (const KeptMember& member : members) {
      key(member.name);
      raw(member.json);
    }
  }

 private:
  void line() {
    text_ += '\n';
    text_.append(2 * depth_, ' ');
  }
  template <class Number>
  void append(Number value) {
    std::array<char, 400> buffer;
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    text_.append(buffer.data(), result.ptr);
  }

  std::string text_;
  std::size_t depth_ = 0;
  bool first_ = true;
};

}  // namespace hariko::detail

#pragma once

// JsonWriter: JSON text in the order of the calls, for reports, logs and small files.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Writer of one JSON value: a number, a string, or an array or object whose contents a function writes.
/// Numbers get the fewest digits that read back as the same number; numbers that are not finite become null.
/// Each byte that is not valid UTF-8 becomes U+FFFD.
class JsonWriter {
 public:
  /// `indent`: spaces per level, with each entry on its own line; negative: everything on one line without
  /// spaces.
  explicit JsonWriter(int indent = -1) : indent_(indent) {}

  std::string take() { return std::move(text_); }

  void value(std::nullptr_t);
  void value(bool value);
  void value(double value);
  template <std::integral Integer>
  void value(Integer value) {
    if constexpr (std::signed_integral<Integer>)
      integer(std::int64_t{value});
    else
      integer(std::uint64_t{value});
  }
  void value(std::string_view value);
  void value(const std::string& value) { this->value(std::string_view(value)); }
  void value(const char* value) { this->value(std::string_view(value)); }
  /// Writes [x, y, z].
  void value(const Vector3& value);
  /// Writes null where there is no value.
  template <class T>
  void value(const std::optional<T>& value) {
    if (value)
      this->value(*value);
    else
      this->value(nullptr);
  }
  template <class T>
  void value(const std::vector<T>& values) {
    list(values, [this](const T& value) { this->value(value); });
  }
  template <class T, std::size_t N>
  void value(const std::array<T, N>& values) {
    list(values, [this](const T& value) { this->value(value); });
  }
  template <class T>
  void value(std::initializer_list<T> values) {
    list(values, [this](const T& value) { this->value(value); });
  }

  /// Writes an array; `body` writes the entries by `value`, `object`, `array`.
  template <class Body>
  void array(Body&& body) {
    open('[');
    body();
    close(']');
  }
  /// Writes an object; `body` writes the members by `member` and the like, or by `key` and a value.
  template <class Body>
  void object(Body&& body) {
    open('{');
    body();
    close('}');
  }
  /// Writes an array by calling `write` for each entry of the range.
  template <class Range, class Write>
  void list(const Range& range, Write&& write) {
    array([&] {
      for (const auto& entry : range) write(entry);
    });
  }

  /// Writes the name of the member whose value comes next.
  void key(std::string_view name);
  template <class T>
  void member(std::string_view name, const T& value) {
    key(name);
    this->value(value);
  }
  template <class T>
  void member(std::string_view name, std::initializer_list<T> values) {
    key(name);
    value(values);
  }
  template <class Body>
  void object(std::string_view name, Body&& body) {
    key(name);
    object(body);
  }
  template <class Body>
  void array(std::string_view name, Body&& body) {
    key(name);
    array(body);
  }
  template <class Range, class Write>
  void list(std::string_view name, const Range& range, Write&& write) {
    key(name);
    list(range, write);
  }
  /// Writes text that is JSON already.
  void raw(std::string_view json);

 private:
  void open(char bracket);
  void close(char bracket);
  /// Writes the comma and the line break before an entry.
  void begin_entry();
  void begin_value();
  void line();
  void integer(std::int64_t value);
  void integer(std::uint64_t value);
  void quoted(std::string_view text);

  std::string text_;
  int indent_;
  std::size_t depth_ = 0;
  bool empty_ = true;     ///< the present array or object has no entries yet
  bool has_key_ = false;  ///< the name of the next value is written
};

}  // namespace hariko

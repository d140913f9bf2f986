#pragma once

// JsonReader and JsonCursor: typed access to a JsonValue with errors that name the path of the faulty value.

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/vector.hpp"
#include "core/document/format/json_value.hpp"

namespace hariko::detail {

/// A value with the path to it. Lives on the stack below its parent; the path is written out only for a
/// message.
class JsonCursor {
 public:
  explicit JsonCursor(const JsonValue& root) : value_(&root) {}
  JsonCursor(const JsonCursor& parent, const JsonMember& member)
      : value_(&member.value), member_(&member), parent_(&parent) {}
  JsonCursor(const JsonCursor& parent, std::size_t index)
      : value_(&(*parent.value_->array())[index]), parent_(&parent), index_(index) {}

  const JsonValue& value() const { return *value_; }
  const JsonMember* member() const { return member_; }
  /// Path of the value, such as "objects[2].source.vertices[17]"; "the document" for the root.
  std::string path() const;

 private:
  const JsonValue* value_;
  const JsonMember* member_ = nullptr;
  const JsonCursor* parent_ = nullptr;
  std::size_t index_ = 0;
};

/// Reads values and stores the first error. After an error every function returns a default value, so callers
/// check once at the end of a step; loops over arrays stop by themselves.
class JsonReader {
 public:
  /// Reads values of a text, from which the JSON of members can be taken.
  explicit JsonReader(std::string_view text) : text_(text) {}

  /// Version of the document's format, which some members depend on; the newest unless set.
  int version() const { return version_; }
  void set_version(int version) { version_ = version; }

  bool failed() const { return error_.has_value(); }
  const Message& error() const { return *error_; }
  /// Stores the error unless there is one already.
  void fail(Message message) {
    if (!error_) error_ = std::move(message);
  }
  /// Reports E_SCHEMA with the text "objects[2].id: <text>."
  void fail(const JsonCursor& at, const std::string& text);
  /// Reports the error of a value's check with the value's path.
  void fail(const JsonCursor& at, Message message);
  /// Reports E_SCHEMA even where there is an error already.
  void replace_error(const JsonCursor& at, const std::string& text);

  double number(const JsonCursor& at);
  /// Integer in low .. high.
  std::uint32_t integer(const JsonCursor& at, std::uint32_t low, std::uint32_t high);
  bool boolean(const JsonCursor& at);
  std::string string(const JsonCursor& at);
  /// Array of three numbers.
  Vector3 vector(const JsonCursor& at);
  /// Number of elements of an array that has between low and high of them.
  std::size_t array_size(const JsonCursor& at, std::size_t low, std::size_t high);
  bool is_object(const JsonCursor& at);
  /// Index of the text among `names`.
  std::size_t choice(const JsonCursor& at, std::span<const std::string_view> names);

  /// Calls body(const JsonCursor&) for each element, until an error.
  template <class Body>
  void for_each(const JsonCursor& at, Body&& body) {
    const std::size_t size = array_size(at, 0, std::size_t(-1));
    for (std::size_t i = 0; i < size && !failed(); ++i) body(JsonCursor(at, i));
  }
  /// Calls body(const JsonCursor&) for the member, if there is one.
  template <class Body>
  void if_member(const JsonCursor& at, std::string_view name, Body&& body) {
    if (const JsonMember* member = find(at, name); member && !failed()) body(JsonCursor(at, *member));
  }
  /// Calls body(const JsonCursor&) for the member; an error if there is none.
  template <class Body>
  void member(const JsonCursor& at, std::string_view name, Body&& body) {
    if (!find(at, name)) fail(at, "the member \"" + std::string(name) + "\" is missing");
    if_member(at, name, body);
  }
  /// Member of an object; nullptr where there is none.
  const JsonMember* find(const JsonCursor& at, std::string_view name) const;
  /// Text of a member's value, byte for byte.
  std::string json_of(const JsonMember& member) const {
    return std::string(text_.substr(member.begin, member.end - member.begin));
  }

 private:
  std::string_view text_;
  std::optional<Message> error_;
  int version_ = std::numeric_limits<int>::max();
};

}  // namespace hariko::detail

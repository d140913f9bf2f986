#pragma once

// JsonValue: parsed JSON, with the position of every member in the text.

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.hpp"

namespace hariko::detail {

struct JsonMember;
class JsonValue;
using JsonArray = std::vector<JsonValue>;
using JsonObject = std::vector<JsonMember>;  ///< in the order of the text, names unique

/// JSON value of sixteen bytes, because most values of a document are numbers.
class JsonValue {
 public:
  JsonValue() = default;
  explicit JsonValue(bool value) : state_(value) {}
  explicit JsonValue(double value) : state_(value) {}
  explicit JsonValue(std::string value) : state_(std::make_unique<std::string>(std::move(value))) {}
  static JsonValue make_array();
  static JsonValue make_object();

  /// Access by kind; nullptr when the value is of another kind.
  const bool* boolean() const { return std::get_if<bool>(&state_); }
  const double* number() const { return std::get_if<double>(&state_); }
  const std::string* string() const { return get<std::string>(); }
  const JsonArray* array() const { return get<JsonArray>(); }
  const JsonObject* object() const { return get<JsonObject>(); }
  JsonArray* array() { return const_cast<JsonArray*>(get<JsonArray>()); }
  JsonObject* object() { return const_cast<JsonObject*>(get<JsonObject>()); }

 private:
  template <class T>
  const T* get() const {
    const auto* pointer = std::get_if<std::unique_ptr<T>>(&state_);
    return pointer ? pointer->get() : nullptr;
  }
  std::variant<std::monostate, bool, double, std::unique_ptr<std::string>, std::unique_ptr<JsonArray>,
               std::unique_ptr<JsonObject>>
      state_;
};

struct JsonMember {
  std::string name;
  JsonValue value;
  std::size_t begin = 0, end = 0;  ///< range of the value in the text
};

/// Parses one JSON value followed only by white space. Errors: E_LIMIT, E_PARSE, and E_SCHEMA for a name that
/// appears twice in one object.
Result<JsonValue> parse_json(std::string_view text);

}  // namespace hariko::detail

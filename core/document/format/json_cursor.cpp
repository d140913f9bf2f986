#include "core/document/format/json_cursor.hpp"

#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/format/format.hpp"

namespace hariko::detail {

std::string JsonCursor::path() const {
  if (!parent_) return "the document";
  const std::string above = parent_->parent_ ? parent_->path() : std::string();
  if (!member_) return above + "[" + std::to_string(index_) + "]";
  return above + (above.empty() ? "" : ".") + shortened(member_->name, 120);
}

void JsonReader::fail(const JsonCursor& at, const std::string& text) {
  if (error_) return;
  error_ = make_error(e_schema, "The file holds something unexpected: " + at.path() + ": " + text + ".",
                      "Open an intact copy of the file, or repair that place in a text editor.");
}

void JsonReader::fail(const JsonCursor& at, Message message) {
  message.text = at.path() + ": " + message.text;
  fail(std::move(message));
}

void JsonReader::replace_error(const JsonCursor& at, const std::string& text) {
  error_.reset();
  fail(at, text);
}

double JsonReader::number(const JsonCursor& at) {
  if (const double* value = at.value().number()) return *value;
  fail(at, "a number was expected");
  return 0;
}

std::uint32_t JsonReader::integer(const JsonCursor& at, std::uint32_t low, std::uint32_t high) {
  const double* value = at.value().number();
  if (value && *value >= low && *value <= high && *value == std::floor(*value))
    return static_cast<std::uint32_t>(*value);
  fail(at, "a whole number from " + std::to_string(low) + " to " + std::to_string(high) + " was expected");
  return low;
}

bool JsonReader::boolean(const JsonCursor& at) {
  if (const bool* value = at.value().boolean()) return *value;
  fail(at, "true or false was expected");
  return false;
}

std::string JsonReader::string(const JsonCursor& at) {
  if (const std::string* value = at.value().string()) return *value;
  fail(at, "a text in quotes was expected");
  return {};
}

Vector3 JsonReader::vector(const JsonCursor& at) {
  Vector3 result = Vector3::Zero();
  if (array_size(at, 3, 3) != 3) return result;
  for (std::size_t i = 0; i < 3; ++i) result[static_cast<Eigen::Index>(i)] = number(JsonCursor(at, i));
  return result;
}

std::size_t JsonReader::array_size(const JsonCursor& at, std::size_t low, std::size_t high) {
  const JsonArray* array = at.value().array();
  if (array && array->size() >= low && array->size() <= high) return array->size();
  if (!array)
    fail(at, "a list in brackets was expected");
  else if (low == high)
    fail(at, "a list of " + std::to_string(low) + " entries was expected");
  else
    fail(at, "the list is too " + std::string(array->size() < low ? "short" : "long"));
  return 0;
}

bool JsonReader::is_object(const JsonCursor& at) {
  if (at.value().object()) return true;
  fail(at, "an object in braces was expected");
  return false;
}

std::size_t JsonReader::choice(const JsonCursor& at, std::span<const std::string_view> names) {
  std::string list;
  const std::string text = string(at);
  std::size_t index = 0;
  for (const std::string_view name : names) {
    if (text == name) return index;
    ++index;
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  fail(at, "one of " + list + " was expected");
  return 0;
}

const JsonMember* JsonReader::find(const JsonCursor& at, std::string_view name) const {
  const JsonObject* object = at.value().object();
  if (!object) return nullptr;
  for (const JsonMember& member : *object)
    if (member.name == name) return &member;
  return nullptr;
}

}  // namespace hariko::detail

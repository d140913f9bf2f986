#include "core/document/format/archive.hpp"

#include <algorithm>

#include "core/base/text/sanitized_utf8.hpp"

namespace hariko::detail {

void read_value(JsonReader& reader, const JsonCursor& at, bool& value) {
  value = reader.boolean(at);
}
void read_value(JsonReader& reader, const JsonCursor& at, double& value) {
  value = reader.number(at);
}
void read_value(JsonReader& reader, const JsonCursor& at, double& value, const Range& range) {
  value = reader.number(at);
  if (!(value >= range.low && value <= range.high)) reader.fail(at, std::string(range.text));
}
void read_value(JsonReader& reader, const JsonCursor& at, double& value, const Range& a, const Range& b) {
  read_value(reader, at, value, a);
  read_value(reader, at, value, b);
}
void read_value(JsonReader& reader, const JsonCursor& at, std::uint32_t& value, const Whole& limits) {
  value = reader.integer(at, limits.low, limits.high);
}
void read_value(JsonReader& reader, const JsonCursor& at, int& value, const Whole& limits) {
  value = static_cast<int>(reader.integer(at, limits.low, limits.high));
}
void read_value(JsonReader& reader, const JsonCursor& at, std::string& value) {
  value = reader.string(at);
}
void read_value(JsonReader& reader, const JsonCursor& at, Vector3& value) {
  value = reader.vector(at);
}

/// An unknown member is the first error of an object, whatever else is wrong in it.
void ReadArchive::close() {
  if (!refuses_ || failed_before_) return;
  const KeptMembers others = unknown();
  if (!others.empty())
    reader_.replace_error(at_, "the member \"" + shortened(others.front().name, 120) + "\" is unknown");
}

const JsonMember* ReadArchive::take(std::string_view name, bool required) {
  const JsonMember* member = reader_.find(at_, name);
  if (member) taken_.push_back(member);
  if (!member && required) reader_.fail(at_, "the member \"" + std::string(name) + "\" is missing");
  return reader_.failed() ? nullptr : member;
}

KeptMembers ReadArchive::unknown() const {
  KeptMembers out;
  const JsonObject* object = at_.value().object();
  if (!object) return out;
  for (const JsonMember& member : *object)
    if (std::find(taken_.begin(), taken_.end(), &member) == taken_.end())
      out.push_back({member.name, reader_.json_of(member)});
  return out;
}

void WriteArchive::close() {
  if (layout_ == Layout::lines)
    text_.close('}');
  else
    text_.raw(layout_ == Layout::line ? "}" : "]");
}

void WriteArchive::next() {
  if (!first_) text_.raw(", ");
  first_ = false;
}

void WriteArchive::key(std::string_view name) {
  if (layout_ == Layout::lines) return text_.key(name);
  next();
  text_.string(name);
  text_.raw(": ");
}

}  // namespace hariko::detail

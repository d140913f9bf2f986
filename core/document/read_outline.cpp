#include "core/document/read_outline.hpp"

#include <algorithm>

#include "core/document/format_names.hpp"
#include "core/document/read_source.hpp"

namespace hariko {

namespace detail {

namespace {

OutlineLoop read_loop(JsonReader& reader, const JsonCursor& at, std::size_t room) {
  OutlineLoop loop;
  if (!reader.is_object(at)) return loop;
  refuse_unknown_members(reader, at, loop_members);
  reader.member(at, "points", [&](const JsonCursor& list) {
    if (reader.array_size(list, 0, room) == 0) return;
    reader.for_each(list, [&](const JsonCursor& row) { loop.points.push_back(reader.vector(row)); });
  });
  const std::size_t count = loop.points.size();
  reader.member(at, "normals", [&](const JsonCursor& list) {
    if (reader.array_size(list, count, count) != count) return;
    reader.for_each(list, [&](const JsonCursor& row) { loop.normals.push_back(reader.vector(row)); });
  });
  reader.if_member(at, "K", [&](const JsonCursor& list) {
    if (reader.array_size(list, count, count) != count) return;
    reader.for_each(list, [&](const JsonCursor& value) { loop.curvature.push_back(reader.number(value)); });
  });
  return loop;
}

}  // namespace

Outline read_loops(JsonReader& reader, const JsonCursor& at) {
  Outline out;
  std::size_t count = 0;
  reader.member(at, "loops", [&](const JsonCursor& list) {
    reader.for_each(list, [&](const JsonCursor& loop) {
      out.loops.push_back(read_loop(reader, loop, max_outline_points - count));
      count += out.loops.back().points.size();
    });
  });
  return out;
}

}  // namespace detail

Result<Outline> read_outline(std::string_view text) {
  using namespace detail;
  const Result<JsonValue> root = parse_json(text);
  if (!root) return root.error();
  JsonReader reader;
  const JsonCursor at(*root);
  if (!reader.is_object(at)) return reader.error();
  Outline outline = read_loops(reader, at);
  if (reader.failed()) return reader.error();
  return outline;
}

bool is_outline(std::string_view text) {
  const auto root = detail::parse_json(text);
  if (!root || !root->object()) return false;
  return std::any_of(root->object()->begin(), root->object()->end(),
                     [](const detail::JsonMember& member) { return member.name == "loops"; });
}

}  // namespace hariko

#include "core/document/format/read_outline.hpp"

#include "core/document/format/format_names.hpp"
#include "core/document/format/read_source.hpp"
#include "core/document/format/read_text.hpp"

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

OutlineSettings read_outline_settings(JsonReader& reader, const JsonCursor& at) {
  OutlineSettings settings;
  reader.if_member(at, "method",
                   [&](const JsonCursor& m) { settings.mode = GaussMode(reader.choice(m, gauss_names)); });
  reader.if_member(at, "curvature_sign",
                   [&](const JsonCursor& m) { settings.sign = CurvatureSign(reader.choice(m, sign_names)); });
  reader.if_member(at, "radius", [&](const JsonCursor& m) {
    settings.radius = reader.number(m);
    if (!(settings.radius >= OutlineSettings::smallest_radius &&
          settings.radius <= OutlineSettings::largest_radius))
      reader.fail(m, "a number from 0.01 to 100 was expected");
  });
  reader.if_member(at, "most_points", [&](const JsonCursor& m) {
    settings.most_points = reader.integer(m, 0, OutlineSettings::point_limit);
  });
  reader.if_member(at, "gap", [&](const JsonCursor& m) {
    settings.gap = reader.number(m);
    if (!(*settings.gap > 0)) reader.fail(m, "a positive number was expected");
  });
  reader.if_member(at, "mode", [&](const JsonCursor& m) {
    settings.curvature_continuous = reader.choice(m, outline_patch_names) == 1;
  });
  return settings;
}

}  // namespace detail

Result<Outline> read_outline(std::string_view text) {
  return detail::read_text<Outline>(text, detail::read_loops);
}

}  // namespace hariko

#include <algorithm>

#include "core/document/edits/edit_pictures.hpp"
#include "core/document/edits/edit_support.hpp"
#include "core/document/format/format.hpp"
#include "core/document/format/format_names.hpp"
#include "core/document/format/read_dimensions.hpp"
#include "core/document/format/read_paper.hpp"
#include "core/document/format/read_source.hpp"

namespace hariko {
namespace {

using detail::JsonCursor;
using detail::JsonReader;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

/// Reads a colour such as "#b9b4ac".
Colour read_colour(JsonReader& reader, const JsonCursor& at) {
  const std::string text = reader.string(at);
  const bool valid = text.size() == 7 && text[0] == '#' &&
                     std::all_of(text.begin() + 1, text.end(), [](char c) { return hex_digit(c) >= 0; });
  if (!valid) {
    reader.fail(at, "a colour such as \"#b9b4ac\" was expected");
    return {};
  }
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint8_t>(16 * hex_digit(text[i]) + hex_digit(text[i + 1]));
  };
  return {byte(1), byte(3), byte(5)};
}

Similarity read_transform(JsonReader& reader, const JsonCursor& at) {
  Similarity transform;
  if (!reader.is_object(at)) return transform;
  detail::refuse_unknown_members(reader, at, detail::transform_members);
  reader.if_member(at, "rotation", [&](const JsonCursor& list) {
    if (reader.array_size(list, 4, 4) != 4) return;
    double q[4];
    for (std::size_t i = 0; i < 4; ++i) q[i] = reader.number(JsonCursor(list, i));
    transform.rotation = Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
    if (!(std::abs(transform.rotation.norm() - 1) <= 1e-9))
      reader.fail(list, "a unit quaternion was expected");
  });
  reader.if_member(at, "scale", [&](const JsonCursor& member) {
    transform.scale = reader.number(member);
    if (!(transform.scale >= Similarity::min_scale && transform.scale <= Similarity::max_scale))
      reader.fail(member, "a number from 1e-9 to 1e9 was expected");
  });
  reader.if_member(at, "translation",
                   [&](const JsonCursor& member) { transform.translation = reader.vector(member); });
  return transform;
}

CombSettings read_combs(JsonReader& reader, const JsonCursor& at) {
  CombSettings combs;
  if (!reader.is_object(at)) return combs;
  detail::refuse_unknown_members(reader, at, detail::combs_members);
  reader.if_member(at, "shown", [&](const JsonCursor& member) { combs.shown = reader.boolean(member); });
  reader.if_member(at, "density", [&](const JsonCursor& member) {
    combs.density =
        static_cast<int>(reader.integer(member, CombSettings::min_density, CombSettings::max_density));
  });
  reader.if_member(at, "scale", [&](const JsonCursor& member) {
    combs.scale = reader.number(member);
    if (!(combs.scale >= CombSettings::min_scale && combs.scale <= CombSettings::max_scale))
      reader.fail(member, "a number from 1/64 to 64 was expected");
  });
  return combs;
}

MapRange read_range(JsonReader& reader, const JsonCursor& at) {
  MapRange range;
  if (!reader.is_object(at)) return range;
  detail::refuse_unknown_members(reader, at, detail::range_members);
  reader.if_member(at, "mode", [&](const JsonCursor& member) {
    range.mode = static_cast<RangeMode>(reader.choice(member, detail::range_mode_names));
  });
  reader.if_member(at, "low", [&](const JsonCursor& member) { range.low = reader.number(member); });
  reader.if_member(at, "high", [&](const JsonCursor& member) { range.high = reader.number(member); });
  if (!reader.failed() && !(range.low < range.high)) reader.fail(at, "low must be below high");
  return range;
}

DisplaySettings read_display(JsonReader& reader, const JsonCursor& at) {
  DisplaySettings display;
  if (!reader.is_object(at)) return display;
  detail::refuse_unknown_members(reader, at, detail::display_members);
  const auto flag = [&](std::string_view name, bool& value) {
    reader.if_member(at, name, [&](const JsonCursor& member) { value = reader.boolean(member); });
  };
  flag("surface", display.surface);
  flag("polyhedron", display.polyhedron);
  flag("network", display.network);
  reader.if_member(at, "map", [&](const JsonCursor& member) {
    display.map = static_cast<SurfaceMap>(reader.choice(member, detail::map_names));
  });
  reader.if_member(at, "density", [&](const JsonCursor& member) {
    display.density =
        static_cast<int>(reader.integer(member, DisplaySettings::min_density, DisplaySettings::max_density));
  });
  reader.if_member(at, "colour",
                   [&](const JsonCursor& member) { display.colour = read_colour(reader, member); });
  reader.if_member(at, "material", [&](const JsonCursor& member) {
    display.material = static_cast<Material>(reader.choice(member, detail::material_names));
  });
  flag("points", display.points);
  reader.if_member(at, "wire", [&](const JsonCursor& member) {
    display.wire = static_cast<PatchWire>(reader.choice(member, detail::wire_names));
  });
  flag("tensions", display.tensions);
  flag("marks", display.marks);
  reader.if_member(at, "combs",
                   [&](const JsonCursor& member) { display.combs = read_combs(reader, member); });
  reader.if_member(at, "ranges", [&](const JsonCursor& ranges) {
    if (!reader.is_object(ranges)) return;
    detail::refuse_unknown_members(reader, ranges, detail::ranges_members);
    for (std::size_t i = 0; i < display.ranges.size(); ++i)
      reader.if_member(ranges, detail::ranges_members[i],
                       [&](const JsonCursor& member) { display.ranges[i] = read_range(reader, member); });
  });
  return display;
}

MakingSettings read_making(JsonReader& reader, const JsonCursor& at) {
  MakingSettings making;
  if (!reader.is_object(at)) return making;
  detail::refuse_unknown_members(reader, at, detail::making_members);
  const auto number = [&](std::string_view name, double& value) {
    reader.if_member(at, name, [&](const JsonCursor& member) { value = reader.number(member); });
  };
  reader.if_member(at, "pull", [&](const JsonCursor& member) { making.pull = reader.vector(member); });
  number("draft", making.draft);
  number("radius", making.radius);
  number("thickness", making.thickness);
  reader.if_member(at, "reference", [&](const JsonCursor& member) {
    making.reference.value = reader.integer(member, 0, no_index - 1);
  });
  if (const auto checked = check_making(making); !checked && !reader.failed()) {
    Message message = checked.error();
    message.text = at.path() + ": " + message.text;
    reader.fail(std::move(message));
  }
  return making;
}

std::string read_name(JsonReader& reader, const JsonCursor& at) {
  std::string name = reader.string(at);
  if (const auto checked = check_name(name); !checked && !reader.failed()) {
    Message message = checked.error();
    message.text = at.path() + ": " + message.text;
    reader.fail(std::move(message));
  }
  return name;
}

std::shared_ptr<const Object> read_object(JsonReader& reader, const JsonCursor& at, std::string_view text) {
  if (!reader.is_object(at)) return nullptr;
  ObjectId id;
  std::string name;
  bool visible = true, locked = false;
  Similarity transform;
  DisplaySettings display;
  std::optional<Source> source;
  reader.member(at, "id",
                [&](const JsonCursor& member) { id.value = reader.integer(member, 0, no_index - 1); });
  reader.member(at, "name", [&](const JsonCursor& member) { name = read_name(reader, member); });
  reader.if_member(at, "visible", [&](const JsonCursor& member) { visible = reader.boolean(member); });
  reader.if_member(at, "locked", [&](const JsonCursor& member) { locked = reader.boolean(member); });
  reader.if_member(at, "transform",
                   [&](const JsonCursor& member) { transform = read_transform(reader, member); });
  reader.if_member(at, "display", [&](const JsonCursor& member) { display = read_display(reader, member); });
  reader.member(at, "source",
                [&](const JsonCursor& member) { source = detail::read_source(reader, member, text); });
  if (reader.failed()) return nullptr;
  return std::make_shared<const Object>(Object{id, std::move(name), visible, locked, transform, display,
                                               *std::move(source),
                                               detail::kept_members(at, detail::object_members, text)});
}

/// Checks format and version (E_FORMAT, E_VERSION_NEWER) before anything else, because the rest of a newer
/// file may mean anything.
void check_head(JsonReader& reader, const JsonCursor& root) {
  const auto not_hariko = [&] {
    reader.fail(make_error(e_format, "The file is not a Hariko document.",
                           "Choose a file that Hariko has saved, or use Import for other formats."));
  };
  bool named = false;
  reader.if_member(root, "format", [&](const JsonCursor& at) {
    named = at.value().string() && *at.value().string() == "hariko";
  });
  if (!named) return not_hariko();
  reader.member(root, "version", [&](const JsonCursor& at) {
    const std::uint32_t version = reader.integer(at, 1, no_index - 1);
    if (version > static_cast<std::uint32_t>(format_version))
      reader.fail(make_error(e_version_newer,
                             "The file was saved by a newer Hariko: it has format version " +
                                 std::to_string(version) + ", this program reads versions up to " +
                                 std::to_string(format_version) + ".",
                             "Open it with a newer Hariko."));
    else
      reader.set_version(static_cast<int>(version));
  });
}

/// Checks that ids are unique and that new objects cannot get one of them again.
void check_object_ids(JsonReader& reader, const JsonCursor& root, Document& document, bool has_next_id) {
  std::vector<ObjectId> ids;
  for (const auto& object : document.objects) ids.push_back(object->id);
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end()) reader.fail(root, "two objects have the id " + std::to_string(twice->value));
  const std::uint32_t lowest = ids.empty() ? 1 : ids.back().value + 1;
  if (!has_next_id) document.next_object_id.value = lowest;
  if (document.next_object_id.value < lowest)
    reader.fail(root, "next_object_id must be above the ids of all objects");
}

}  // namespace

Result<Document> read_document(std::string_view text) {
  const Result<detail::JsonValue> parsed = detail::parse_json(text);
  if (!parsed) return parsed.error();
  JsonReader reader;
  const JsonCursor root(*parsed);
  check_head(reader, root);
  Document document;
  bool has_next_id = false;
  reader.if_member(root, "unit", [&](const JsonCursor& at) {
    document.unit = static_cast<Unit>(reader.choice(at, detail::unit_names));
  });
  reader.if_member(root, "next_object_id", [&](const JsonCursor& at) {
    document.next_object_id.value = reader.integer(at, 0, no_index);
    has_next_id = true;
  });
  reader.member(root, "objects", [&](const JsonCursor& list) {
    reader.array_size(list, 0, Document::max_objects);
    reader.for_each(list,
                    [&](const JsonCursor& at) { document.objects.push_back(read_object(reader, at, text)); });
  });
  reader.if_member(root, "dimensions",
                   [&](const JsonCursor& at) { document.dimensions = detail::read_dimensions(reader, at); });
  reader.if_member(root, "making", [&](const JsonCursor& at) { document.making = read_making(reader, at); });
  reader.if_member(root, "paper", [&](const JsonCursor& at) {
    document.paper = std::make_shared<const PaperModel>(detail::read_paper(reader, at, text));
  });
  if (!reader.failed()) check_object_ids(reader, root, document, has_next_id);
  if (!reader.failed())
    if (const auto checked = check_packed_pictures(document); !checked) reader.fail(checked.error());
  if (reader.failed()) return reader.error();
  document.kept = detail::kept_members(root, detail::document_members, text);
  return document;
}

}  // namespace hariko

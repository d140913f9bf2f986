// Dimensions in files.

#include <algorithm>

#include "core/document/format/archive.hpp"
#include "core/document/format/described.hpp"
#include "core/document/words.hpp"

namespace hariko::detail {

/// Element as in the names of a paper model: an edge has two ids.
static void read_value(JsonReader& reader, const JsonCursor& at, Element& element) {
  const std::size_t size = reader.array_size(at, 2, 3);
  if (reader.failed()) return;
  const auto id = [&](std::size_t i) { return std::uint64_t{reader.integer(JsonCursor(at, i), 0, max_id)}; };
  read_value(reader, JsonCursor(at, 0), element.kind);
  if ((element.kind == Element::Kind::edge) != (size == 3))
    reader.fail(at, "[kind, id] was expected, for an edge [kind, id, id]");
  if (reader.failed()) return;
  element.id = id(1);
  if (size == 3) element.id = element.id << 32 | id(2);
}
static void write_value(DocumentText& text, const Element& element) {
  const bool edge = element.kind == Element::Kind::edge;
  text.row(edge ? 3 : 2, [&](std::size_t i) {
    if (i == 0)
      text.string(enum_word(element.kind));
    else
      text.number(static_cast<std::uint32_t>(edge && i == 1 ? element.id >> 32 : element.id));
  });
}

template <class Archive>
void describe(Archive& archive, Described<Archive, Vector2>& parameter) {
  archive.row(2);
  archive.entry(parameter.x());
  archive.entry(parameter.y());
}

template <class Archive>
void describe_held(Archive& archive, Described<Archive, SpaceAnchor>& anchor) {
  archive.required("point", anchor.point);
}
template <class Archive>
void describe_held(Archive& archive, Described<Archive, ObjectAnchor>& anchor) {
  archive.required("object", anchor.object);
  archive.required("point", anchor.point);
  archive.member("solid", anchor.solid);
}
template <class Archive>
void describe_held(Archive& archive, Described<Archive, VertexAnchor>& anchor) {
  archive.required("object", anchor.object);
  archive.required("vertex", anchor.vertex);
  archive.changed("image", anchor.image, false);
}
template <class Archive>
void describe_held(Archive& archive, Described<Archive, EdgeAnchor>& anchor) {
  archive.required("object", anchor.object);
  archive.required("edge", anchor.edge, std::string_view("the lower number comes first"));
  archive.required("share", anchor.share);
  archive.changed("straight", anchor.straight, false);
}
template <class Archive>
void describe_held(Archive& archive, Described<Archive, PatchAnchor>& anchor) {
  archive.required("object", anchor.object);
  archive.required("patch", anchor.element);
  archive.required("side", anchor.side, Whole{0, no_index});
  archive.required("at", anchor.parameter);
}
template <class Archive>
void describe_held(Archive& archive, Described<Archive, NearestAnchor>& anchor) {
  archive.required("object", anchor.object);
  archive.required("nearest", anchor.point);
}

/// Anchor of the kind that follows from the members of an object.
static Anchor kind_of_anchor(ReadArchive& archive) {
  const std::pair<std::string_view, Anchor> kinds[] = {
      {"point", archive.has("object") ? Anchor(ObjectAnchor{}) : Anchor(SpaceAnchor{})},
      {"vertex", VertexAnchor{}},
      {"edge", EdgeAnchor{}},
      {"patch", PatchAnchor{}},
      {"nearest", NearestAnchor{}}};
  archive.require([&] { return archive.has("object") || archive.has("point"); },
                  "the member \"object\" is missing");
  const auto is_there = [&](const auto& kind) { return archive.has(kind.first); };
  archive.require([&] { return std::ranges::count_if(kinds, is_there) == 1; },
                  "one of point, vertex, edge, patch and nearest was expected");
  const auto found = std::ranges::find_if(kinds, is_there);
  return found == std::end(kinds) ? Anchor(SpaceAnchor{}) : found->second;
}

template <class Archive>
void describe(Archive& archive, Described<Archive, Anchor>& anchor) {
  archive.line();
  archive.known({"object", "point", "solid", "vertex", "image", "edge", "share", "straight", "patch", "side",
                 "at", "nearest"});
  if constexpr (Archive::reads) anchor = kind_of_anchor(archive);
  std::visit([&](auto& held) { describe_held(archive, held); }, anchor);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, Dimension>& dimension) {
  archive.line();
  archive.required("id", dimension.id, Whole{0, max_dimension_id});
  archive.required("kind", dimension.kind);
  const std::size_t count = anchor_count(dimension.kind);
  archive.required("anchors", dimension.anchors, Count{count, count});
  archive.changed("label", dimension.label, Vector3::Zero());
  archive.require([&] { return is_sound(dimension); },
                  "a share, a parameter or the anchor of a radius is out of its range");
}

void read_value(JsonReader& reader, const JsonCursor& at, Dimensions& dimensions) {
  reader.array_size(at, 0, Document::max_dimensions);
  reader.for_each(at,
                  [&](const JsonCursor& entry) { read_described(reader, entry, dimensions.emplace_back()); });
  if (reader.failed()) return;
  std::vector<DimensionId> ids;
  for (const Dimension& dimension : dimensions) ids.push_back(dimension.id);
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end()) reader.fail(at, "two dimensions have the id " + std::to_string(twice->value));
}
void write_value(DocumentText& text, const Dimension& dimension) {
  write_described(text, dimension);
}

}  // namespace hariko::detail

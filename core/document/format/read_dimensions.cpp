#include "core/document/format/read_dimensions.hpp"

#include <algorithm>
#include <optional>

#include "core/document/document.hpp"
#include "core/document/format/format_names.hpp"
#include "core/document/format/read_source.hpp"

namespace hariko::detail {

namespace {

/// Reads the anchors of dimensions; which kind one is follows from its members.
class AnchorReader {
 public:
  explicit AnchorReader(JsonReader& reader) : reader_(reader) {}

  Anchor read(const JsonCursor& at) {
    if (!reader_.is_object(at)) return SpaceAnchor{};
    refuse_unknown_members(reader_, at, anchor_members);
    std::optional<ObjectId> object;
    reader_.if_member(at, "object", [&](const JsonCursor& m) { object = ObjectId{id(m)}; });
    std::optional<Anchor> found;
    const auto take = [&](Anchor anchor) {
      if (found) reader_.fail(at, "one of point, vertex, edge, patch and nearest was expected");
      found = std::move(anchor);
    };
    reader_.if_member(at, "point", [&](const JsonCursor& m) { take(point(at, m, object)); });
    if (!object && !found) reader_.fail(at, "the member \"object\" is missing");
    const ObjectId of = object.value_or(ObjectId{});
    reader_.if_member(at, "vertex", [&](const JsonCursor& m) { take(vertex(at, m, of)); });
    reader_.if_member(at, "edge", [&](const JsonCursor& m) { take(edge(at, m, of)); });
    reader_.if_member(at, "patch", [&](const JsonCursor& m) { take(patch(at, m, of)); });
    reader_.if_member(at, "nearest", [&](const JsonCursor& m) {
      take(NearestAnchor{of, reader_.vector(m)});
    });
    if (!found) reader_.fail(at, "one of point, vertex, edge, patch and nearest was expected");
    return found.value_or(SpaceAnchor{});
  }

 private:
  std::uint32_t id(const JsonCursor& at) { return reader_.integer(at, 0, max_id); }

  bool flag(const JsonCursor& at, std::string_view name) {
    bool on = false;
    reader_.if_member(at, name, [&](const JsonCursor& m) { on = reader_.boolean(m); });
    return on;
  }

  Anchor point(const JsonCursor& at, const JsonCursor& member, const std::optional<ObjectId>& object) {
    const Vector3 place = reader_.vector(member);
    if (!object) return SpaceAnchor{place};
    ObjectAnchor anchor{*object, place, {}};
    reader_.if_member(at, "solid", [&](const JsonCursor& m) { anchor.solid = id(m); });
    return anchor;
  }

  Anchor vertex(const JsonCursor& at, const JsonCursor& member, ObjectId object) {
    return VertexAnchor{object, VertexId{id(member)}, flag(at, "image")};
  }

  Anchor edge(const JsonCursor& at, const JsonCursor& member, ObjectId object) {
    EdgeAnchor anchor;
    anchor.object = object;
    if (reader_.array_size(member, 2, 2) == 2)
      anchor.edge = {VertexId{id(JsonCursor(member, 0))}, VertexId{id(JsonCursor(member, 1))}};
    if (!(anchor.edge.low < anchor.edge.high)) reader_.fail(member, "the lower number comes first");
    reader_.member(at, "share", [&](const JsonCursor& m) { anchor.share = reader_.number(m); });
    anchor.straight = flag(at, "straight");
    return anchor;
  }

  Anchor patch(const JsonCursor& at, const JsonCursor& member, ObjectId object) {
    PatchAnchor anchor;
    anchor.object = object;
    const std::size_t size = reader_.array_size(member, 2, 3);
    if (reader_.failed()) return anchor;
    anchor.element.kind = static_cast<Element::Kind>(reader_.choice(JsonCursor(member, 0), element_names));
    if ((anchor.element.kind == Element::Kind::edge) != (size == 3))
      reader_.fail(member, "[kind, id] was expected, for an edge [kind, id, id]");
    if (reader_.failed()) return anchor;
    anchor.element.id = id(JsonCursor(member, 1));
    if (size == 3) anchor.element.id = anchor.element.id << 32 | id(JsonCursor(member, 2));
    reader_.member(at, "side", [&](const JsonCursor& m) { anchor.side = reader_.integer(m, 0, no_index); });
    reader_.member(at, "at", [&](const JsonCursor& m) {
      if (reader_.array_size(m, 2, 2) != 2) return;
      anchor.parameter.x() = reader_.number(JsonCursor(m, 0));
      anchor.parameter.y() = reader_.number(JsonCursor(m, 1));
    });
    return anchor;
  }

  JsonReader& reader_;
};

Dimension read_dimension(JsonReader& reader, const JsonCursor& at) {
  Dimension dimension;
  if (!reader.is_object(at)) return dimension;
  refuse_unknown_members(reader, at, dimension_members);
  reader.member(at, "id",
                [&](const JsonCursor& m) { dimension.id.value = reader.integer(m, 0, max_dimension_id); });
  reader.member(at, "kind", [&](const JsonCursor& m) {
    dimension.kind = static_cast<DimensionKind>(reader.choice(m, dimension_names));
  });
  reader.member(at, "anchors", [&](const JsonCursor& list) {
    const std::size_t count = anchor_count(dimension.kind);
    if (reader.array_size(list, count, count) != count) return;
    reader.for_each(list,
                    [&](const JsonCursor& m) { dimension.anchors.push_back(AnchorReader(reader).read(m)); });
  });
  reader.if_member(at, "label", [&](const JsonCursor& m) { dimension.label = reader.vector(m); });
  if (!reader.failed() && !is_sound(dimension))
    reader.fail(at, "a share, a parameter or the anchor of a radius is out of its range");
  return dimension;
}

}  // namespace

Dimensions read_dimensions(JsonReader& reader, const JsonCursor& at) {
  Dimensions out;
  reader.array_size(at, 0, Document::max_dimensions);
  reader.for_each(at, [&](const JsonCursor& entry) { out.push_back(read_dimension(reader, entry)); });
  if (reader.failed()) return {};
  std::vector<DimensionId> ids;
  for (const Dimension& dimension : out) ids.push_back(dimension.id);
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end()) reader.fail(at, "two dimensions have the id " + std::to_string(twice->value));
  return out;
}

}  // namespace hariko::detail

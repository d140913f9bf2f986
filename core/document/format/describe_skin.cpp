// Skins in files: as sources of documents, and in the plain layout of sections drawn in other programs, where
// points have no ids, and links and merges name their strip and their points by numbers.

#include <set>

#include "core/document/format/describe_origin.hpp"
#include "core/document/format/described.hpp"
#include "core/document/format/format.hpp"
#include "core/document/format/read_skin.hpp"
#include "core/document/format/read_text.hpp"
#include "core/document/words.hpp"
#include "core/skinning/sections/section_direction.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko::detail {

static constexpr std::uint32_t max_count = 100'000;

static void fail_index(JsonReader& reader, const JsonCursor& at) {
  reader.fail(
      make_error(e_skin_index, at.path() + " refers to a point that no longer exists.", "Delete it."));
}

/// Numbers of the points that are corners.
static void describe_sharp(ReadArchive& archive, SubdivisionCurve& curve) {
  archive.with("sharp", [&](const JsonCursor& list) {
    std::vector<std::uint32_t> numbers;
    read_value(archive.reader(), list, numbers, Whole{0, max_count});
    curve.sharp.assign(curve.points.size(), 0);
    for (const std::uint32_t i : numbers) {
      if (i >= curve.sharp.size()) return archive.reader().fail(list, "there are not so many points");
      curve.sharp[i] = 1;
    }
  });
}
static void describe_sharp(WriteArchive& archive, const SubdivisionCurve& curve) {
  std::vector<std::uint32_t> numbers;
  for (int i = 0; i < curve.size(); ++i)
    if (curve.is_sharp(i)) numbers.push_back(std::uint32_t(i));
  if (!curve.sharp.empty()) archive.member("sharp", numbers);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, SubdivisionCurve>& curve) {
  archive.lines();
  archive.required("points", curve.points);
  archive.member("closed", curve.closed);
  describe_sharp(archive, curve);
  archive.others_ignored();
}

/// Ids for the sections and points of a file without ids.
struct FreshIds {
  std::uint32_t section = 0, point = 0;
};

/// The points of a section lie in three lists.
static void describe_points(ReadArchive& archive, SkinSection& section, FreshIds& fresh) {
  std::vector<Vector3> points;
  archive.required("points", points);
  std::vector<std::uint32_t> ids, sharp;
  for (std::size_t i = 0; i < points.size(); ++i) ids.push_back(fresh.point++);
  archive.with("ids", [&](const JsonCursor& list) {
    ids.clear();
    read_value(archive.reader(), list, ids);
    if (ids.size() != points.size()) archive.reader().fail(list, "one id a point was expected");
  });
  for (std::size_t i = 0; i < points.size() && !archive.reader().failed(); ++i)
    section.points.push_back({ids[i], points[i], false});
  archive.with("sharp", [&](const JsonCursor& list) {
    read_value(archive.reader(), list, sharp, Whole{0, max_count});
    for (const std::uint32_t i : sharp) {
      if (i >= section.points.size()) return fail_index(archive.reader(), list);
      section.points[i].sharp = true;
    }
  });
}
static void describe_points(WriteArchive& archive, const SkinSection& section, FreshIds&) {
  std::vector<Vector3> points;
  std::vector<std::uint32_t> ids, sharp;
  for (const SectionPoint& point : section.points) {
    if (point.sharp) sharp.push_back(std::uint32_t(points.size()));
    points.push_back(point.position);
    ids.push_back(point.id);
  }
  archive.member("points", points);
  archive.member("ids", ids);
  archive.changed("sharp", sharp, {});
}

template <class Archive>
void describe(Archive& archive, Described<Archive, SkinSection>& section, FreshIds* fresh = nullptr) {
  FreshIds none;
  archive.lines();
  if (fresh) archive.assume(section.id, fresh->section++);
  archive.member("id", section.id);
  archive.required("v", section.v);
  archive.member("closed", section.closed);
  archive.changed("direction_chosen", section.direction_chosen, false);
  archive.changed("start_chosen", section.start_chosen, archive.before(2) && section.closed);
  archive.member("reference", section.reference);
  describe_points(archive, section, fresh ? *fresh : none);
  archive.others_ignored();
}

/// Sections of a link or merge; the plain layout has the number of their strip.
static void describe_strip(ReadArchive& archive, const Skin& skin, std::uint32_t& first,
                           std::uint32_t& second) {
  if (!archive.has("strip")) return archive.required_row("sections", Whole{}, first, second);
  archive.with("strip", [&](const JsonCursor& at) {
    const std::uint32_t strip = archive.reader().integer(at, 0, max_count);
    if (archive.reader().failed()) return;
    if (int(strip) >= skin.strip_count()) return fail_index(archive.reader(), archive.at());
    first = skin.sections[strip].id;
    second = skin.sections[(strip + 1) % skin.sections.size()].id;
  });
}
static void describe_strip(WriteArchive& archive, const Skin&, std::uint32_t first, std::uint32_t second) {
  archive.required_row("sections", Whole{}, first, second);
}

/// Replaces the number of a point in a section by the point's id.
static void to_id(JsonReader& reader, const JsonCursor& at, const SkinSection* section,
                  std::uint32_t& point) {
  if (section && point < section->points.size())
    point = section->points[point].id;
  else
    fail_index(reader, at);
}
static void to_id(JsonReader& reader, const JsonCursor& at, const SkinSection* section,
                  std::vector<std::uint32_t>& points) {
  for (std::uint32_t& point : points) to_id(reader, at, section, point);
}
/// Describes points of a section by their ids; the plain layout has their numbers.
template <class Archive, class Points>
void describe_ids(Archive& archive, const Skin& skin, std::string_view name, std::uint32_t section,
                  Points& points) {
  archive.required(name, points);
  if constexpr (Archive::reads) {
    if (!archive.has("strip")) return;
    const int k = skin.find_section(section);
    archive.with(name, [&](const JsonCursor& at) {
      to_id(archive.reader(), at, k < 0 ? nullptr : &skin.sections[std::size_t(k)], points);
    });
  }
}

template <class Archive>
void describe(Archive& archive, Described<Archive, SkinLink>& link, const Skin& skin = {}) {
  archive.line();
  if (Archive::reads) archive.assume(link.id, skin.free_link_id());
  archive.member("id", link.id);
  describe_strip(archive, skin, link.first, link.second);
  describe_ids(archive, skin, "a", link.first, link.a);
  describe_ids(archive, skin, "b", link.second, link.b);
  archive.changed("lasso", link.lasso, false);
  archive.changed("locked", link.locked, false);
  archive.others_ignored();
}

template <class Archive>
void describe(Archive& archive, Described<Archive, SkinMerge>& merge, const Skin& skin = {}) {
  archive.line();
  if (Archive::reads) archive.assume(merge.id, skin.free_link_id());
  archive.member("id", merge.id);
  describe_strip(archive, skin, merge.first, merge.second);
  archive.member("side", merge.side);
  const bool a = merge.side == StripSide::a;
  describe_ids(archive, skin, "members", a ? merge.first : merge.second, merge.members);
  describe_ids(archive, skin, "target", a ? merge.second : merge.first, merge.target);
  archive.required("v", merge.v);
  archive.changed("locked", merge.locked, false);
  archive.others_ignored();
}

template <class Archive>
void describe(Archive& archive, Described<Archive, MirrorPlane>& plane) {
  archive.line();
  auto axis = static_cast<Axis>(plane.axis);
  archive.required("axis", axis);
  archive.assume(plane.axis, static_cast<int>(axis));
  archive.required("position", plane.position);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, SmoothOptions>& options) {
  archive.lines();
  archive.member("columns", options.columns, Whole{0, max_count});
  archive.member("rows", options.rows, Whole{0, max_count});
  archive.member("parameters", options.parameters);
  archive.member("blend", options.blend);
  archive.list("anchors", options.anchors);
  archive.others_ignored();
}

template <class Archive>
void describe(Archive& archive, Described<Archive, PleatOptions>& options) {
  archive.lines();
  archive.member("rows", options.rows);
  archive.member("quad_fans", options.quad_fans);
  archive.member("collars", options.collars);
  archive.member("exact", options.fit);
  archive.member("cost", options.cost);
  archive.member("tension", options.tension, positive);
  archive.member("density", options.density, positive);
  archive.others_ignored();
}

static void check_ids(JsonReader& reader, const Skin& skin) {
  std::set<std::uint32_t> sections, points;
  for (const SkinSection& section : skin.sections) {
    bool fresh = sections.insert(section.id).second;
    for (const SectionPoint& p : section.points) fresh = points.insert(p.id).second && fresh;
    if (!fresh) reader.fail(make_error(e_schema, "sections: ids of sections and points must be unique."));
  }
}

template <class Archive>
void describe_members(Archive& archive, Described<Archive, Skin>& skin) {
  archive.required("path", skin.path);
  archive.member("rail2", skin.second_rail);
  archive.member("frame", skin.frame);
  FreshIds fresh;
  archive.required_list("sections", skin.sections, &fresh);
  if constexpr (Archive::reads) check_ids(archive.reader(), skin);
  archive.member("method", skin.method);
  archive.member("caps", skin.caps);
  archive.member("creases", skin.creases);
  archive.member("flip_normals", skin.flip_normals);
  archive.member("mirror", skin.mirror);
  archive.member("smooth", skin.smooth);
  archive.member("pleat", skin.pleat);
  archive.list("links", skin.links, skin);
  archive.list("merges", skin.merges, skin);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, SkinSource>& source) {
  archive.lines();
  archive.constant("kind", SkinSource::kind);
  describe_origin(archive);
  archive.shared(source.skin, [&](auto& skin) { describe_members(archive, skin); });
  archive.kept(source.kept);
}

void read_value(JsonReader& reader, const JsonCursor& at, SkinSource& source) {
  read_described(reader, at, source);
}
void write_value(DocumentText& text, const SkinSource& source) {
  write_described(text, source);
}

}  // namespace hariko::detail

namespace hariko {

Result<Skin> read_skin_layout(std::string_view text) {
  Result<Skin> skin = detail::read_text<Skin>(
      text, [](detail::ReadArchive& archive, Skin& value) { describe_members(archive, value); });
  if (!skin) return skin.error();
  return turn_sections(std::move(skin).value());
}

}  // namespace hariko

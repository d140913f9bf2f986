// Outlines in files.

#include "core/document/format/archive.hpp"
#include "core/document/format/describe_origin.hpp"
#include "core/document/format/described.hpp"
#include "core/document/format/read_outline.hpp"
#include "core/document/format/read_text.hpp"
#include "core/document/words.hpp"

namespace hariko {

namespace detail {
/// Patches over the points of an outline.
enum class OutlinePatches : std::uint8_t { fair, g2 };
}  // namespace detail

template <>
inline constexpr auto enum_words<detail::OutlinePatches> = all_words<detail::OutlinePatches>(
    {{detail::OutlinePatches::fair, "fair"}, {detail::OutlinePatches::g2, "g2"}});

namespace detail {

/// Describes a loop; `room` counts the points that all loops of an outline may still have.
template <class Archive>
void describe(Archive& archive, Described<Archive, OutlineLoop>& loop, std::size_t* room = nullptr) {
  archive.lines();
  archive.required("points", loop.points, Count{0, room ? *room : 0});
  const std::size_t count = loop.points.size();
  if (room) *room -= count;
  archive.required("normals", loop.normals, Count{count, count});
  archive.changed("K", loop.curvature, {}, Count{count, count});
}

template <class Archive>
void describe_members(Archive& archive, Described<Archive, Outline>& outline) {
  std::size_t room = max_outline_points;
  archive.required_list("loops", outline.loops, &room);
}

/// Mode of an outline; files before version 10 may have the word of one that does not exist any more.
static void describe_outline_mode(ReadArchive& archive, OutlineSettings& settings) {
  archive.with("method", [&](const JsonCursor& at) {
    settings.mode_replaced = at.value().string() && *at.value().string() == replaced_outline_mode;
    settings.mode = GaussMode::umbilic;
    if (!settings.mode_replaced) read_value(archive.reader(), at, settings.mode);
  });
}
static void describe_outline_mode(WriteArchive& archive, const OutlineSettings& settings) {
  archive.member("method", settings.mode);
}

template <class Archive>
void describe_members(Archive& archive, Described<Archive, OutlineSettings>& settings) {
  describe_outline_mode(archive, settings);
  archive.member("curvature_sign", settings.sign);
  archive.member("radius", settings.radius,
                 Range{OutlineSettings::smallest_radius, OutlineSettings::largest_radius,
                       "a number from 0.01 to 100 was expected"});
  archive.member("most_points", settings.most_points, Whole{0, OutlineSettings::point_limit});
  archive.member("gap", settings.gap, positive);
  auto patches = settings.curvature_continuous ? OutlinePatches::g2 : OutlinePatches::fair;
  archive.member("mode", patches);
  archive.assume(settings.curvature_continuous, patches == OutlinePatches::g2);
  archive.changed("frames", settings.frames, Frames::equal);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, OutlineSource>& source) {
  archive.lines();
  archive.constant("kind", OutlineSource::kind);
  describe_origin(archive);
  archive.shared(source.outline, [&](auto& outline) { describe_members(archive, outline); });
  describe_members(archive, source.settings);
  archive.kept(source.kept);
}

void read_value(JsonReader& reader, const JsonCursor& at, OutlineSource& source) {
  read_described(reader, at, source);
}
void write_value(DocumentText& text, const OutlineSource& source) {
  write_described(text, source);
}

}  // namespace detail

Result<Outline> read_outline(std::string_view text) {
  return detail::read_text<Outline>(
      text, [](detail::ReadArchive& archive, Outline& outline) { describe_members(archive, outline); });
}

}  // namespace hariko

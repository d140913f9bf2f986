// Solids in files.

#include <algorithm>
#include <set>
#include <string>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/format/describe_origin.hpp"
#include "core/document/format/described.hpp"
#include "core/document/format/read_solids.hpp"
#include "core/document/format/read_text.hpp"
#include "core/document/words.hpp"
#include "core/envelope/ball/tightness.hpp"

namespace hariko {

namespace detail {
/// Methods in files; `automatic` and `field` occur only in files before version 4.
enum class FileMethod : std::uint8_t { automatic, network, field, ball };
/// Surfaces over the network in such files.
enum class FileSurface : std::uint8_t { rational, fair };
}  // namespace detail

template <>
inline constexpr auto enum_words<detail::FileMethod> =
    all_words<detail::FileMethod>({{detail::FileMethod::automatic, "auto"},
                                   {detail::FileMethod::network, "network"},
                                   {detail::FileMethod::field, "field"},
                                   {detail::FileMethod::ball, "ball"}});
template <>
inline constexpr auto enum_words<detail::FileSurface> = all_words<detail::FileSurface>(
    {{detail::FileSurface::rational, "rational"}, {detail::FileSurface::fair, "fair"}});

namespace detail {

static void read_value(JsonReader& reader, const JsonCursor& at, SolidKind& kind) {
  const std::string name = reader.string(at);
  if (const auto named = enum_value<SolidKind>(name))
    kind = *named;
  else
    reader.fail(at, "there is no solid \"" + shortened(name, 120) + "\"");
}
static void write_value(DocumentText& text, const SolidKind& kind) {
  text.string(name_of(kind));
}

template <class Archive>
void describe(Archive& archive, Described<Archive, Bridge>& bridge) {
  archive.line();
  archive.required("between", bridge.between);
  archive.member("ball_radius", bridge.ball_radius);
  archive.others_ignored();
}

template <class Archive>
void describe(Archive& archive, Described<Archive, Pull>& pull) {
  archive.line();
  archive.required("place", pull.place);
  archive.required("radius", pull.radius);
  archive.others_ignored();
}

/// Sizes without meaning for the kind are left out unless they were changed.
template <class Archive>
void describe(Archive& archive, Described<Archive, Solid>& solid) {
  const Solid usual;
  archive.line();
  archive.required("type", solid.kind);
  archive.assume(solid.id, no_index);
  archive.member("id", solid.id);
  const auto is = [&](auto... kinds) { return ((solid.kind == kinds) || ...); };
  const auto size = [&](bool means, std::string_view name, auto& value, const auto& plain) {
    means ? archive.member(name, value) : archive.changed(name, value, plain);
  };
  using enum SolidKind;
  size(is(box), "size", solid.size, usual.size);
  size(!is(box, polyhedron), "radius", solid.radius, usual.radius);
  size(is(cylinder, cone, prism, pyramid), "height", solid.height, usual.height);
  size(is(capsule), "length", solid.length, usual.length);
  size(is(torus), "tube", solid.tube, usual.tube);
  size(is(prism, pyramid), "sides", solid.sides, usual.sides);
  archive.changed("position", solid.position, usual.position);
  archive.changed("rotation", solid.rotation, usual.rotation);
  archive.changed("scale", solid.scale, usual.scale);
  archive.member("roundness", solid.roundness);
  archive.member("bridge", solid.bridge);
  archive.list("pulls", solid.pulls, First{max_pulls + 1});
  archive.changed("vertices", solid.points, {}, First{max_solid_points + 1});
  archive.others_ignored();
}

/// Gives solids without an id, or with one that is taken, the lowest free one.
static void number_solids(std::vector<Solid>& solids) {
  std::set<std::uint32_t> taken;
  std::vector<Solid*> open;
  for (Solid& solid : solids)
    if (solid.id == no_index || !taken.insert(solid.id).second) open.push_back(&solid);
  std::uint32_t next = 0;
  for (Solid* solid : open) {
    while (taken.contains(next)) ++next;
    taken.insert(solid->id = next);
  }
}

/// Settings in files before version 4, and the names of those with unusual values.
struct SettingsBefore {
  std::optional<FileMethod> method;
  double tightness = 0;
  std::string lost;
};

static SettingsBefore read_settings_before(ReadArchive& archive) {
  SettingsBefore out;
  archive.member("method", out.method);
  archive.member("tightness", out.tightness);
  const auto lose = [&](std::string_view name, bool unusual) {
    if (unusual) out.lost += (out.lost.empty() ? "" : ", ") + std::string(name);
  };
  const std::pair<std::string_view, double> numbers[] = {
      {"waist", 0.5}, {"detail", 0.09}, {"merge_deg", 40}, {"cage_detail", 1}};
  for (const auto& [name, usual] : numbers) {
    double value = usual;
    archive.member(name, value);
    lose(name, value != usual);
  }
  FileSurface surface = FileSurface::rational;
  archive.member("surface", surface);
  lose("surface", surface != FileSurface::rational);
  for (const std::string_view name : {"waists", "fullness", "offsets"})
    archive.with(name, [&](const JsonCursor& list) {
      bool any = false;
      archive.reader().for_each(list, [&](const JsonCursor&) { any = true; });
      lose(name, any);
    });
  return out;
}

/// Converts the methods of files before version 4: the network at tightness 0 still exists, all others become
/// the ball. Scene files have no version; they count as old where they have settings of those methods.
static void settle_method(const ReadArchive& archive, SettingsBefore before, EnvelopeInput& out) {
  EnvelopeSettings& s = out.settings;
  if (std::ranges::any_of(out.solids, [](const Solid& solid) { return !check_solid(solid, 0); })) return;
  const auto has = [&](std::string_view name) { return archive.has(name); };
  if (before.method == FileMethod::ball || (!before.method && (has("rounding") || has("ball_radius")))) {
    const std::optional<double> radius = s.ball_radius;
    const double rounding = s.rounding;
    choose_ball(out);
    if (has("rounding")) s.rounding = rounding;
    if (has("ball_radius")) s.ball_radius = radius;
    return;
  }
  const std::string_view old[] = {"tightness", "waist", "detail", "merge_deg", "cage_detail"};
  if (!before.method && std::ranges::none_of(old, has)) return choose_ball(out);
  s.converted.lost = std::move(before.lost);
  if (before.method == FileMethod::network || (before.method != FileMethod::field && before.tightness == 0)) {
    s.method = EnvelopeMethod::network;
    if (before.tightness > 0)
      s.converted.lost = "tightness" + (s.converted.lost.empty() ? "" : ", " + s.converted.lost);
  } else {
    choose_ball_as_before(out, before.tightness);
    s.converted.method = true;
  }
}

/// Radius of the ball, "hull" without one.
static void describe_ball_radius(ReadArchive& archive, std::optional<double>& radius) {
  archive.with("ball_radius", [&](const JsonCursor& at) {
    if (!at.value().string() || *at.value().string() != "hull") radius = archive.reader().number(at);
  });
}
static void describe_ball_radius(WriteArchive& archive, const std::optional<double>& radius) {
  archive.member("ball_radius", radius);
  if (!radius) archive.constant("ball_radius", "hull");
}

template <class Archive>
void describe_members(Archive& archive, Described<Archive, EnvelopeInput>& input) {
  archive.required_list("primitives", input.solids, First{max_solids + 1});
  Described<Archive, EnvelopeSettings>& settings = input.settings;
  archive.assume(settings.roundness, 0.5);
  archive.member("roundness", settings.roundness);
  archive.member("clearance", settings.clearance);
  archive.member("rounding", settings.rounding);
  describe_ball_radius(archive, settings.ball_radius);
  archive.constant("method", enum_word(settings.method));
  archive.member("symmetry", settings.symmetry);
  archive.changed("on_faces", settings.on_faces, false);
  archive.changed("finer_patches", settings.finer_patches, false);
  if constexpr (Archive::reads) {
    number_solids(input.solids);
    SettingsBefore before = read_settings_before(archive);
    if (!archive.reader().failed() && !input.solids.empty()) settle_method(archive, std::move(before), input);
    archive.check([&] { return check_envelope(input); });
  }
}

template <class Archive>
void describe(Archive& archive, Described<Archive, SolidsSource>& source) {
  archive.lines();
  archive.constant("kind", SolidsSource::kind);
  describe_origin(archive);
  archive.shared(source.input, [&](auto& input) { describe_members(archive, input); });
  archive.kept(source.kept);
}

void read_value(JsonReader& reader, const JsonCursor& at, SolidsSource& source) {
  read_described(reader, at, source);
}
void write_value(DocumentText& text, const SolidsSource& source) {
  write_described(text, source);
}

}  // namespace detail

Result<EnvelopeInput> read_scene(std::string_view text) {
  return detail::read_text<EnvelopeInput>(
      text, [](detail::ReadArchive& archive, EnvelopeInput& input) { describe_members(archive, input); });
}

}  // namespace hariko

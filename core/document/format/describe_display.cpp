// Placement and look of objects, and the settings of making, in files.

#include <algorithm>

#include "core/document/format/archive.hpp"
#include "core/document/format/described.hpp"
#include "core/document/words.hpp"

namespace hariko::detail {

/// Digits of colours such as "#b9b4ac".
static constexpr std::string_view colour_digits = "0123456789abcdef";

void read_value(JsonReader& reader, const JsonCursor& at, Colour& colour) {
  const std::string text = reader.string(at);
  const bool valid =
      text.size() == 7 && text[0] == '#' && text.find_first_not_of(colour_digits, 1) == std::string::npos;
  if (!valid) return reader.fail(at, "a colour such as \"#b9b4ac\" was expected");
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint8_t>(16 * colour_digits.find(text[i]) + colour_digits.find(text[i + 1]));
  };
  colour = {byte(1), byte(3), byte(5)};
}
void write_value(DocumentText& text, const Colour& colour) {
  std::string word = "#";
  for (const std::uint8_t part : {colour.red, colour.green, colour.blue}) {
    word += colour_digits[part / 16];
    word += colour_digits[part % 16];
  }
  text.string(word);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, Eigen::Quaterniond>& rotation) {
  archive.row(4);
  archive.entry(rotation.w());
  archive.entry(rotation.x());
  archive.entry(rotation.y());
  archive.entry(rotation.z());
  archive.require([&] { return std::abs(rotation.norm() - 1) <= 1e-9; }, "a unit quaternion was expected");
}

template <class Archive>
void describe(Archive& archive, Described<Archive, Similarity>& transform) {
  archive.line();
  archive.member("rotation", transform.rotation);
  archive.member(
      "scale", transform.scale,
      Range{Similarity::min_scale, Similarity::max_scale, "a number from 1e-9 to 1e9 was expected"});
  archive.member("translation", transform.translation);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, CombSettings>& combs) {
  archive.line();
  archive.member("shown", combs.shown);
  archive.member("density", combs.density, Whole{CombSettings::min_density, CombSettings::max_density});
  archive.member(
      "scale", combs.scale,
      Range{CombSettings::min_scale, CombSettings::max_scale, "a number from 1/64 to 64 was expected"});
}

template <class Archive>
void describe(Archive& archive, Described<Archive, MapRange>& range) {
  archive.line();
  archive.member("mode", range.mode);
  archive.member("low", range.low);
  archive.member("high", range.high);
  archive.require([&] { return range.low < range.high; }, "low must be below high");
}

/// The ranges under the words of their maps.
template <class Archive>
void describe(Archive& archive, Described<Archive, MapRanges>& ranges) {
  archive.line();
  for (std::size_t map = 0; map < enum_words<SurfaceMap>.size(); ++map)
    if (const auto slot = range_slot(SurfaceMap(map)))
      archive.changed(
          enum_words<SurfaceMap>[map], ranges[*slot], MapRange {});
}
static void read_value(JsonReader& reader, const JsonCursor& at, MapRanges& ranges) {
  read_described(reader, at, ranges);
}
static void write_value(DocumentText& text, const MapRanges& ranges) {
  write_described(text, ranges);
}

/// The members after the colour are written where they differ, so that simple files stay simple.
template <class Archive>
void describe(Archive& archive, Described<Archive, DisplaySettings>& display) {
  const DisplaySettings plain;
  archive.line();
  archive.member("surface", display.surface);
  archive.member("polyhedron", display.polyhedron);
  archive.member("network", display.network);
  archive.member("map", display.map);
  archive.member("density", display.density,
                 Whole{DisplaySettings::min_density, DisplaySettings::max_density});
  archive.member("colour", display.colour);
  archive.changed("material", display.material, plain.material);
  archive.changed("points", display.points, plain.points);
  archive.changed("wire", display.wire, plain.wire);
  archive.changed("tensions", display.tensions, plain.tensions);
  archive.changed("marks", display.marks, plain.marks);
  archive.changed("combs", display.combs, plain.combs);
  archive.changed("ranges", display.ranges, plain.ranges);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, MakingSettings>& making) {
  archive.line();
  archive.member("pull", making.pull);
  archive.member("draft", making.draft);
  archive.member("radius", making.radius);
  archive.member("thickness", making.thickness);
  archive.changed("reference", making.reference, ObjectId{});
  archive.check([&] { return check_making(making); });
}

void read_value(JsonReader& reader, const JsonCursor& at, Eigen::Quaterniond& rotation) {
  read_described(reader, at, rotation);
}
void write_value(DocumentText& text, const Eigen::Quaterniond& rotation) {
  write_described(text, rotation);
}
void read_value(JsonReader& reader, const JsonCursor& at, Similarity& transform) {
  read_described(reader, at, transform);
}
void write_value(DocumentText& text, const Similarity& transform) {
  write_described(text, transform);
}
void read_value(JsonReader& reader, const JsonCursor& at, DisplaySettings& display) {
  read_described(reader, at, display);
}
void write_value(DocumentText& text, const DisplaySettings& display) {
  write_described(text, display);
}
void read_value(JsonReader& reader, const JsonCursor& at, MakingSettings& making) {
  read_described(reader, at, making);
}
void write_value(DocumentText& text, const MakingSettings& making) {
  write_described(text, making);
}

}  // namespace hariko::detail

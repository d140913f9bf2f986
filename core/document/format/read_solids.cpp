#include "core/document/format/read_solids.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/format/format_names.hpp"
#include "core/document/format/read_text.hpp"
#include "core/envelope/ball/tightness.hpp"

namespace hariko {

namespace detail {

namespace {

constexpr double scene_roundness = 0.5;
constexpr std::uint32_t max_number = no_index - 1;

/// Methods in files, in the order of `method_names`.
enum class FileMethod : std::uint8_t { automatic, network, field, ball };

class SolidsReader {
 public:
  explicit SolidsReader(JsonReader& reader) : reader_(reader) {}

  EnvelopeInput read(const JsonCursor& at) {
    EnvelopeInput out;
    reader_.member(at, "primitives", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) {
        if (out.solids.size() <= max_solids) out.solids.push_back(solid(row));
      });
    });
    number_solids(out.solids);
    EnvelopeSettings& s = out.settings;
    s.roundness = scene_roundness;
    number(at, "roundness", s.roundness);
    number(at, "clearance", s.clearance);
    number(at, "rounding", s.rounding);
    reader_.if_member(at, "ball_radius", [&](const JsonCursor& member) {
      if (!member.value().string() || *member.value().string() != "hull")
        s.ball_radius = reader_.number(member);
    });
    choice(at, "symmetry", symmetry_names, s.symmetry);
    boolean(at, "on_faces", s.on_faces);
    boolean(at, "finer_patches", s.finer_patches);
    read_before(at);
    if (!reader_.failed() && !out.solids.empty()) settle_method(at, out);
    return out;
  }

 private:
  bool has_any(const JsonCursor& at, std::initializer_list<std::string_view> names) {
    bool out = false;
    for (const std::string_view name : names)
      reader_.if_member(at, name, [&](const JsonCursor&) { out = true; });
    return out;
  }

  /// Reads obsolete members of files before version 4, and records those with unusual values as lost.
  void read_before(const JsonCursor& at) {
    reader_.if_member(at, "method", [&](const JsonCursor& member) {
      method_ = FileMethod(reader_.choice(member, method_names));
    });
    number(at, "tightness", tightness_);
    const auto lose = [&](std::string_view name, bool unusual) {
      if (unusual) lost_ += (lost_.empty() ? "" : ", ") + std::string(name);
    };
    struct Number {
      std::string_view name;
      double usual;
    };
    for (const auto& [name, usual] :
         {Number{"waist", 0.5}, Number{"detail", 0.09}, Number{"merge_deg", 40}, Number{"cage_detail", 1}}) {
      double value = usual;
      number(at, name, value);
      lose(name, value != usual);
    }
    choice(at, "surface", envelope_surface_names, fair_);
    lose("surface", fair_ != 0);
    for (const std::string_view name : {"waists"sv, "fullness"sv, "offsets"sv})
      reader_.if_member(at, name, [&](const JsonCursor& list) {
        bool any = false;
        reader_.for_each(list, [&](const JsonCursor&) { any = true; });
        lose(name, any);
      });
  }

  /// Converts the methods of files before version 4: the network at tightness 0 still exists, all others
  /// become the ball. Scene files have no version; they count as old where they have settings of those
  /// methods.
  void settle_method(const JsonCursor& at, EnvelopeInput& out) {
    EnvelopeSettings& s = out.settings;
    if (std::ranges::any_of(out.solids, [](const Solid& solid) { return !check_solid(solid, 0); })) return;
    const bool with_ball = has_any(at, {"rounding", "ball_radius"});
    if (method_ == FileMethod::ball || (!method_ && with_ball)) {
      const std::optional<double> radius = s.ball_radius;
      const double rounding = s.rounding;
      choose_ball(out);
      if (has_any(at, {"rounding"})) s.rounding = rounding;
      if (has_any(at, {"ball_radius"})) s.ball_radius = radius;
      return;
    }
    if (!method_ && !has_any(at, {"tightness", "waist", "detail", "merge_deg", "cage_detail"}))
      return choose_ball(out);
    s.lost = std::move(lost_);
    if (method_ == FileMethod::network || (method_ != FileMethod::field && tightness_ == 0)) {
      s.method = EnvelopeMethod::network;
      if (tightness_ > 0) s.lost = "tightness" + (s.lost.empty() ? "" : ", " + s.lost);
    } else {
      choose_ball_as_before(out, tightness_);
      s.from_before = true;
    }
  }

  void number(const JsonCursor& at, std::string_view name, double& value) {
    reader_.if_member(at, name, [&](const JsonCursor& member) { value = reader_.number(member); });
  }
  void boolean(const JsonCursor& at, std::string_view name, bool& value) {
    reader_.if_member(at, name, [&](const JsonCursor& member) { value = reader_.boolean(member); });
  }
  void vector(const JsonCursor& at, std::string_view name, Vector3& value) {
    reader_.if_member(at, name, [&](const JsonCursor& member) { value = reader_.vector(member); });
  }
  template <class Choice>
  void choice(const JsonCursor& at, std::string_view name, std::span<const std::string_view> names,
              Choice& value) {
    reader_.if_member(at, name,
                      [&](const JsonCursor& member) { value = Choice(reader_.choice(member, names)); });
  }

  Solid solid(const JsonCursor& at) {
    Solid out;
    if (!reader_.is_object(at)) return out;
    reader_.member(at, "type", [&](const JsonCursor& member) {
      const std::string name = reader_.string(member);
      if (const auto kind = solid_kind_named(name))
        out.kind = *kind;
      else
        reader_.fail(member, "there is no solid \"" + shortened(name, 120) + "\"");
    });
    out.id = no_index;
    reader_.if_member(at, "id",
                      [&](const JsonCursor& member) { out.id = reader_.integer(member, 0, max_number); });
    vector(at, "size", out.size);
    number(at, "radius", out.radius);
    number(at, "height", out.height);
    number(at, "length", out.length);
    number(at, "tube", out.tube);
    reader_.if_member(at, "sides",
                      [&](const JsonCursor& member) { out.sides = reader_.integer(member, 0, max_number); });
    vector(at, "position", out.position);
    vector(at, "rotation", out.rotation);
    vector(at, "scale", out.scale);
    reader_.if_member(at, "roundness",
                      [&](const JsonCursor& member) { out.roundness = reader_.number(member); });
    reader_.if_member(at, "bridge", [&](const JsonCursor& member) { out.bridge = bridge(member); });
    reader_.if_member(at, "vertices", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) {
        if (out.points.size() <= max_solid_points) out.points.push_back(reader_.vector(row));
      });
    });
    return out;
  }

  Bridge bridge(const JsonCursor& at) {
    Bridge out;
    if (!reader_.is_object(at)) return out;
    reader_.member(at, "between", [&](const JsonCursor& ids) {
      if (reader_.array_size(ids, 2, 2) != 2) return;
      std::size_t next = 0;
      reader_.for_each(
          ids, [&](const JsonCursor& id) { out.between[next++] = reader_.integer(id, 0, max_number); });
    });
    reader_.if_member(at, "ball_radius",
                      [&](const JsonCursor& member) { out.ball_radius = reader_.number(member); });
    return out;
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

  JsonReader& reader_;
  std::optional<FileMethod> method_;
  double tightness_ = 0;
  int fair_ = 0;
  std::string lost_;
};

}  // namespace

EnvelopeInput read_solids(JsonReader& reader, const JsonCursor& at) {
  EnvelopeInput input = SolidsReader(reader).read(at);
  if (reader.failed()) return input;
  if (const auto checked = check_envelope(input); !checked) {
    Message message = checked.error();
    message.text = at.path() + ": " + message.text;
    reader.fail(std::move(message));
  }
  return input;
}

}  // namespace detail

Result<EnvelopeInput> read_scene(std::string_view text) {
  return detail::read_text<EnvelopeInput>(text, detail::read_solids);
}

}  // namespace hariko

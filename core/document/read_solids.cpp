#include "core/document/read_solids.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "core/base/printable.hpp"
#include "core/document/format_names.hpp"
#include "core/document/read_text.hpp"
#include "core/envelope/ball/tightness.hpp"

namespace hariko {

namespace detail {

namespace {

constexpr double scene_roundness = 0.5;
constexpr std::uint32_t max_number = no_index - 1;

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
    number(at, "waist", s.waist);
    number(at, "tightness", s.tightness);
    number(at, "clearance", s.clearance);
    number(at, "detail", s.detail);
    number(at, "merge_deg", s.merge_angle);
    number(at, "cage_detail", s.cage_detail);
    bool named = false;
    reader_.if_member(at, "method", [&](const JsonCursor&) { named = true; });
    choice(at, "method", method_names, s.method);
    number(at, "rounding", s.rounding);
    reader_.if_member(at, "ball_radius", [&](const JsonCursor& member) {
      if (!member.value().string() || *member.value().string() != "hull")
        s.ball_radius = reader_.number(member);
    });
    choice(at, "surface", envelope_surface_names, s.patches);
    choice(at, "symmetry", symmetry_names, s.symmetry);
    overrides(at, s);
    if (!reader_.failed() && !out.solids.empty()) settle_method(at, named, out);
    return out;
  }

 private:
  bool has_any(const JsonCursor& at, std::initializer_list<std::string_view> names) {
    bool out = false;
    for (const std::string_view name : names)
      reader_.if_member(at, name, [&](const JsonCursor&) { out = true; });
    return out;
  }

  /// Before there was the ball there were other methods: the network at tightness 0 is still there, all else
  /// becomes the ball. Scenes, which have no version, are of before where they have settings of those
  /// methods.
  void settle_method(const JsonCursor& at, bool named, EnvelopeInput& out) {
    EnvelopeSettings& s = out.settings;
    if (std::ranges::any_of(out.solids, [](const Solid& solid) { return !check_solid(solid, 0); })) return;
    const bool with_ball = has_any(at, {"rounding", "ball_radius"});
    if (s.method == EnvelopeMethod::ball || (!named && with_ball)) {
      const std::optional<double> radius = s.ball_radius;
      const double rounding = s.rounding;
      choose_ball(out);
      if (has_any(at, {"rounding"})) s.rounding = rounding;
      if (has_any(at, {"ball_radius"})) s.ball_radius = radius;
      return;
    }
    if (s.method == EnvelopeMethod::network) return;
    const bool before = named || has_any(at, {"tightness", "waist", "detail", "merge_deg", "cage_detail"});
    if (!before) {
      choose_ball(out);
    } else if (s.method == EnvelopeMethod::automatic && s.tightness == 0) {
      s.method = EnvelopeMethod::network;
    } else {
      choose_ball_as_before(out);
      s.from_before = true;
    }
  }

  void number(const JsonCursor& at, std::string_view name, double& value) {
    reader_.if_member(at, name, [&](const JsonCursor& member) { value = reader_.number(member); });
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
    reader_.if_member(at, "vertices", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) {
        if (out.points.size() <= max_solid_points) out.points.push_back(reader_.vector(row));
      });
    });
    return out;
  }

  /// Solids without an id, or with one that is taken, get the least free one.
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

  std::uint32_t integer(const JsonCursor& row, std::size_t i) {
    return reader_.integer(JsonCursor(row, i), 0, max_number);
  }

  /// From entries i and i + 1: an id, or in a valley both ids, and a number.
  NetworkVertexKey network_vertex(const JsonCursor& row, std::size_t i) {
    const JsonCursor solid(row, i);
    NetworkVertexKey out;
    out.vertex = reader_.integer(JsonCursor(row, i + 1), 0, no_index);
    if (!solid.value().array()) {
      out.solid = integer(row, i);
    } else if (reader_.array_size(solid, 2, 2) == 2) {
      std::tie(out.solid, out.other) = std::minmax({integer(solid, 0), integer(solid, 1)});
    }
    return out;
  }

  void overrides(const JsonCursor& at, EnvelopeSettings& s) {
    reader_.if_member(at, "waists", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) {
        if (reader_.array_size(row, 3, 3) != 3) return;
        s.waists.set(SolidPair::of(integer(row, 0), integer(row, 1)), reader_.number(JsonCursor(row, 2)));
      });
    });
    reader_.if_member(at, "fullness", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) {
        if (reader_.array_size(row, 5, 5) != 5) return;
        s.fullness.set(NetworkEdgeKey::of(network_vertex(row, 0), network_vertex(row, 2)),
                       reader_.number(JsonCursor(row, 4)));
      });
    });
    reader_.if_member(at, "offsets", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) {
        if (reader_.array_size(row, 5, 5) != 5) return;
        Vector3 offset;
        for (std::size_t i = 0; i < 3; ++i) offset[Eigen::Index(i)] = reader_.number(JsonCursor(row, i + 2));
        s.offsets.set(network_vertex(row, 0), offset);
      });
    });
  }

  JsonReader& reader_;
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

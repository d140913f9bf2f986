#include "core/document/format/read_skin.hpp"

#include <algorithm>
#include <set>

#include "core/document/format/format_names.hpp"
#include "core/document/format/read_source.hpp"
#include "core/document/format/read_text.hpp"
#include "core/skinning/sections/section_direction.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko::detail {

namespace {

constexpr std::uint32_t max_count = 100'000;

std::vector<Vector3> read_points(JsonReader& reader, const JsonCursor& list) {
  std::vector<Vector3> out;
  reader.for_each(list, [&](const JsonCursor& row) { out.push_back(reader.vector(row)); });
  return out;
}

std::vector<std::uint32_t> read_numbers(JsonReader& reader, const JsonCursor& list, std::uint32_t most) {
  std::vector<std::uint32_t> out;
  reader.for_each(list, [&](const JsonCursor& entry) { out.push_back(reader.integer(entry, 0, most)); });
  return out;
}

SubdivisionCurve read_path(JsonReader& reader, const JsonCursor& at) {
  SubdivisionCurve path;
  if (!reader.is_object(at)) return path;
  reader.member(at, "points", [&](const JsonCursor& list) { path.points = read_points(reader, list); });
  reader.if_member(at, "closed", [&](const JsonCursor& member) { path.closed = reader.boolean(member); });
  reader.if_member(at, "sharp", [&](const JsonCursor& list) {
    path.sharp.assign(path.points.size(), 0);
    for (const std::uint32_t i : read_numbers(reader, list, max_count)) {
      if (i >= path.sharp.size()) return reader.fail(list, "there are not so many points");
      path.sharp[i] = 1;
    }
  });
  return path;
}

class SkinReader {
 public:
  explicit SkinReader(JsonReader& reader) : reader_(reader) {}

  Skin read(const JsonCursor& at) {
    reader_.member(at, "path", [&](const JsonCursor& m) { skin_.path = read_path(reader_, m); });
    reader_.if_member(at, "rail2", [&](const JsonCursor& m) { skin_.second_rail = read_path(reader_, m); });
    read_choice(at, "frame", frame_names, skin_.frame);
    reader_.member(at, "sections", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) { read_section(row); });
    });
    check_ids();
    read_options(at);
    reader_.if_member(at, "links", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) { read_link(row); });
    });
    reader_.if_member(at, "merges", [&](const JsonCursor& list) {
      reader_.for_each(list, [&](const JsonCursor& row) { read_merge(row); });
    });
    return std::move(skin_);
  }

 private:
  template <class Enum>
  void read_choice(const JsonCursor& at, std::string_view name, Names names, Enum& value) {
    reader_.if_member(at, name, [&](const JsonCursor& m) { value = Enum(reader_.choice(m, names)); });
  }
  void read_flag(const JsonCursor& at, std::string_view name, bool& value) {
    reader_.if_member(at, name, [&](const JsonCursor& m) { value = reader_.boolean(m); });
  }

  void read_section(const JsonCursor& at) {
    if (!reader_.is_object(at)) return;
    SkinSection section;
    section.id = std::uint32_t(skin_.sections.size());
    reader_.if_member(at, "id", [&](const JsonCursor& m) { section.id = reader_.integer(m, 0, max_id); });
    reader_.member(at, "v", [&](const JsonCursor& m) { section.v = reader_.number(m); });
    read_flag(at, "closed", section.closed);
    read_flag(at, "direction_chosen", section.direction_chosen);
    section.start_chosen = section.closed && reader_.version() < 2;
    read_flag(at, "start_chosen", section.start_chosen);
    reader_.if_member(at, "reference", [&](const JsonCursor& m) { section.reference = reader_.vector(m); });
    std::vector<Vector3> points;
    reader_.member(at, "points", [&](const JsonCursor& list) { points = read_points(reader_, list); });
    std::vector<std::uint32_t> ids;
    reader_.if_member(at, "ids", [&](const JsonCursor& list) {
      ids = read_numbers(reader_, list, max_id);
      if (ids.size() != points.size()) reader_.fail(list, "one id a point was expected");
    });
    for (std::size_t i = 0; i < points.size() && !reader_.failed(); ++i)
      section.points.push_back({ids.empty() ? next_id_ + std::uint32_t(i) : ids[i], points[i], false});
    next_id_ += std::uint32_t(points.size());
    reader_.if_member(at, "sharp", [&](const JsonCursor& list) {
      for (const std::uint32_t i : read_numbers(reader_, list, max_count)) {
        if (i >= section.points.size()) return fail_index(list);
        section.points[i].sharp = true;
      }
    });
    skin_.sections.push_back(std::move(section));
  }

  void check_ids() {
    std::set<std::uint32_t> sections, points;
    for (const SkinSection& section : skin_.sections) {
      bool fresh = sections.insert(section.id).second;
      for (const SectionPoint& p : section.points) fresh = points.insert(p.id).second && fresh;
      if (fresh || reader_.failed()) continue;
      reader_.fail(make_error(Code{"E_SCHEMA"}, "sections: ids of sections and points must be unique."));
    }
  }

  void fail_index(const JsonCursor& at) {
    reader_.fail(
        make_error(e_skin_index, at.path() + " refers to a point that no longer exists.", "Delete it."));
  }

  void read_options(const JsonCursor& at) {
    read_choice(at, "method", skin_method_names, skin_.method);
    read_choice(at, "caps", caps_names, skin_.caps);
    read_flag(at, "creases", skin_.creases);
    read_flag(at, "flip_normals", skin_.flip_normals);
    reader_.if_member(at, "mirror", [&](const JsonCursor& mirror) { skin_.mirror = read_mirror(mirror); });
    reader_.if_member(at, "smooth", [&](const JsonCursor& smooth) {
      if (!reader_.is_object(smooth)) return;
      const auto count = [&](std::string_view name, int& value) {
        reader_.if_member(smooth, name,
                          [&](const JsonCursor& m) { value = int(reader_.integer(m, 0, max_count)); });
      };
      count("columns", skin_.smooth.columns);
      count("rows", skin_.smooth.rows);
      read_choice(smooth, "parameters", parameters_names, skin_.smooth.parameters);
      read_choice(smooth, "blend", blend_names, skin_.smooth.blend);
      reader_.if_member(smooth, "anchors", [&](const JsonCursor& list) {
        reader_.for_each(list, [&](const JsonCursor& row) {
          auto& anchor = skin_.smooth.anchors.emplace_back();
          reader_.for_each(row, [&](const JsonCursor& u) { anchor.push_back(reader_.number(u)); });
        });
      });
    });
    reader_.if_member(at, "pleat", [&](const JsonCursor& pleat) {
      if (!reader_.is_object(pleat)) return;
      read_choice(pleat, "rows", row_names, skin_.pleat.rows);
      read_flag(pleat, "quad_fans", skin_.pleat.quad_fans);
      read_flag(pleat, "collars", skin_.pleat.collars);
      read_choice(pleat, "exact", fit_names, skin_.pleat.fit);
      read_choice(pleat, "cost", cost_names, skin_.pleat.cost);
      const auto positive = [&](std::string_view name, double& value) {
        reader_.if_member(pleat, name, [&](const JsonCursor& m) {
          value = reader_.number(m);
          if (!(value > 0)) reader_.fail(m, "a positive number was expected");
        });
      };
      positive("tension", skin_.pleat.tension);
      positive("density", skin_.pleat.density);
    });
  }

  MirrorPlane read_mirror(const JsonCursor& at) {
    MirrorPlane plane;
    if (!reader_.is_object(at)) return plane;
    refuse_unknown_members(reader_, at, skin_mirror_members);
    reader_.member(at, "axis", [&](const JsonCursor& m) { plane.axis = int(reader_.choice(m, axis_names)); });
    reader_.member(at, "position", [&](const JsonCursor& m) { plane.position = reader_.number(m); });
    return plane;
  }

  /// Reads the sections of a strip: by index in the plain layout, by ids otherwise.
  bool read_strip(const JsonCursor& at, std::uint32_t& first, std::uint32_t& second, bool& by_index) {
    by_index = false;
    reader_.if_member(at, "strip", [&](const JsonCursor& m) {
      by_index = true;
      const std::uint32_t strip = reader_.integer(m, 0, max_count);
      if (reader_.failed()) return;
      if (int(strip) >= skin_.strip_count()) return fail_index(at);
      first = skin_.sections[strip].id;
      second = skin_.sections[(strip + 1) % skin_.sections.size()].id;
    });
    if (!by_index)
      reader_.member(at, "sections", [&](const JsonCursor& m) {
        if (reader_.array_size(m, 2, 2) != 2) return;
        first = reader_.integer(JsonCursor(m, 0), 0, max_id);
        second = reader_.integer(JsonCursor(m, 1), 0, max_id);
      });
    return !reader_.failed();
  }
  std::uint32_t id_of(const JsonCursor& at, std::uint32_t section, std::uint32_t value, bool by_index) {
    if (!by_index) return value;
    const int k = skin_.find_section(section);
    if (k < 0 || value >= skin_.sections[std::size_t(k)].points.size()) {
      fail_index(at);
      return 0;
    }
    return skin_.sections[std::size_t(k)].points[value].id;
  }
  std::vector<std::uint32_t> read_ids(const JsonCursor& at, std::string_view name, std::uint32_t section,
                                      bool by_index) {
    std::vector<std::uint32_t> out;
    reader_.member(at, name, [&](const JsonCursor& list) {
      for (const std::uint32_t i : read_numbers(reader_, list, max_id))
        out.push_back(id_of(list, section, i, by_index));
    });
    return out;
  }
  std::uint32_t read_own_id(const JsonCursor& at) {
    std::uint32_t id = skin_.free_link_id();
    reader_.if_member(at, "id", [&](const JsonCursor& m) { id = reader_.integer(m, 0, max_id); });
    return id;
  }

  void read_link(const JsonCursor& at) {
    if (!reader_.is_object(at)) return;
    SkinLink link;
    link.id = read_own_id(at);
    bool by_index = false;
    if (!read_strip(at, link.first, link.second, by_index)) return;
    link.a = read_ids(at, "a", link.first, by_index);
    link.b = read_ids(at, "b", link.second, by_index);
    read_flag(at, "lasso", link.lasso);
    read_flag(at, "locked", link.locked);
    skin_.links.push_back(std::move(link));
  }

  void read_merge(const JsonCursor& at) {
    if (!reader_.is_object(at)) return;
    SkinMerge merge;
    merge.id = read_own_id(at);
    bool by_index = false;
    if (!read_strip(at, merge.first, merge.second, by_index)) return;
    read_choice(at, "side", strip_side_names, merge.side);
    const bool a = merge.side == StripSide::a;
    merge.members = read_ids(at, "members", a ? merge.first : merge.second, by_index);
    reader_.member(at, "target", [&](const JsonCursor& m) {
      merge.target = id_of(m, a ? merge.second : merge.first, reader_.integer(m, 0, max_id), by_index);
    });
    reader_.member(at, "v", [&](const JsonCursor& m) { merge.v = reader_.number(m); });
    read_flag(at, "locked", merge.locked);
    skin_.merges.push_back(std::move(merge));
  }

  JsonReader& reader_;
  Skin skin_;
  std::uint32_t next_id_ = 0;
};

}  // namespace

Skin read_skin(JsonReader& reader, const JsonCursor& at) {
  if (!reader.is_object(at)) return {};
  return SkinReader(reader).read(at);
}

}  // namespace hariko::detail

namespace hariko {

Result<Skin> read_skin_layout(std::string_view text) {
  Result<Skin> skin = detail::read_text<Skin>(text, detail::read_skin);
  if (!skin) return skin.error();
  return turn_sections(std::move(skin).value());
}

}  // namespace hariko

#include "core/document/format/read_source.hpp"

#include <algorithm>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/edits/edge_set.hpp"
#include "core/document/edits/edit_elements.hpp"
#include "core/document/format/format_names.hpp"
#include "core/document/format/read_outline.hpp"
#include "core/document/format/read_picture.hpp"
#include "core/document/format/read_skin.hpp"
#include "core/document/format/read_solids.hpp"

namespace hariko::detail {
namespace {

bool is_known(std::string_view name, Names known) {
  return std::find(known.begin(), known.end(), name) != known.end();
}

/// Reports the error of a check of a value with the value's path.
void take_error(JsonReader& reader, const JsonCursor& at, const Result<Done>& checked) {
  if (checked) return;
  Message message = checked.error();
  message.text = at.path() + ": " + message.text;
  reader.fail(std::move(message));
}

/// Checks that ids ascend, so that each occurs once and lists are read in linear time.
template <class Id>
bool ascends(JsonReader& reader, const JsonCursor& at, std::optional<Id>& last, Id id) {
  if (!last || *last < id) {
    last = id;
    return true;
  }
  reader.fail(at, "entries must be in ascending order, each once");
  return false;
}

/// Vertex and face lists of a polyhedron in the file.
struct Lists {
  PolygonMesh mesh;
  std::vector<VertexId> vertex_ids;
  std::vector<FaceId> face_ids;
};

/// Reads rows [id, x, y, z].
void read_vertices(JsonReader& reader, const JsonCursor& at, Lists& lists) {
  std::optional<VertexId> last;
  reader.for_each(at, [&](const JsonCursor& row) {
    if (reader.array_size(row, 4, 4) != 4) return;
    const VertexId id{reader.integer(JsonCursor(row, 0), 0, max_id)};
    Vector3 position;
    for (int i = 0; i < 3; ++i) position[i] = reader.number(JsonCursor(row, static_cast<std::size_t>(i) + 1));
    if (!ascends(reader, row, last, id)) return;
    lists.vertex_ids.push_back(id);
    lists.mesh.positions.push_back(position);
  });
}

/// Reads rows [id, vertex id, vertex id, ...].
void read_faces(JsonReader& reader, const JsonCursor& at, Lists& lists) {
  std::optional<FaceId> last;
  std::vector<Index> corners;
  reader.for_each(at, [&](const JsonCursor& row) {
    const std::size_t size = reader.array_size(row, 1, std::size_t(-1));
    if (size == 0) return;
    const FaceId id{reader.integer(JsonCursor(row, 0), 0, max_id)};
    if (!ascends(reader, row, last, id)) return;
    corners.clear();
    for (std::size_t i = 1; i < size && !reader.failed(); ++i) {
      const JsonCursor corner(row, i);
      const VertexId vertex{reader.integer(corner, 0, max_id)};
      const auto found = std::lower_bound(lists.vertex_ids.begin(), lists.vertex_ids.end(), vertex);
      if (found == lists.vertex_ids.end() || *found != vertex)
        reader.fail(corner, "there is no vertex with this id");
      corners.push_back(static_cast<Index>(found - lists.vertex_ids.begin()));
    }
    lists.face_ids.push_back(id);
    lists.mesh.add_face(corners);
  });
}

/// Reads the settings of elements; each list ascends in its ids.
class ShapingReader {
 public:
  ShapingReader(JsonReader& reader, const Polyhedron& polyhedron)
      : reader_(reader), polyhedron_(polyhedron) {}

  Shaping read(const JsonCursor& at) {
    Shaping shaping;
    reader_.if_member(at, "alpha", [&](const JsonCursor& list) { read_alpha(list, shaping); });
    reader_.if_member(at, "beta", [&](const JsonCursor& list) { read_beta(list, shaping); });
    reader_.if_member(at, "crease", [&](const JsonCursor& list) { read_crease(list, shaping); });
    reader_.if_member(at, "tag", [&](const JsonCursor& list) { read_tags(list, shaping); });
    reader_.if_member(at, "pin", [&](const JsonCursor& list) { read_pins(list, shaping); });
    reader_.if_member(at, "form", [&](const JsonCursor& list) { read_forms(list, shaping); });
    reader_.if_member(at, "kept_area", [&](const JsonCursor& list) { read_areas(list, shaping); });
    return shaping;
  }

 private:
  VertexId vertex(const JsonCursor& at) {
    const VertexId id{reader_.integer(at, 0, max_id)};
    if (!reader_.failed() && polyhedron_.find(id) == no_index)
      reader_.fail(at, "there is no vertex with this id");
    return id;
  }
  EdgeId edge(const JsonCursor& row) {
    const EdgeId id{{reader_.integer(JsonCursor(row, 0), 0, max_id)},
                    {reader_.integer(JsonCursor(row, 1), 0, max_id)}};
    if (!edges_) edges_.emplace(polyhedron_);
    if (!reader_.failed() && !edges_->contains(id))
      reader_.fail(row, "there is no edge between these vertices, the smaller id first");
    return id;
  }

  void read_alpha(const JsonCursor& list, Shaping& shaping) {
    std::optional<VertexId> last;
    reader_.for_each(list, [&](const JsonCursor& row) {
      if (reader_.array_size(row, 2, 2) != 2) return;
      const VertexId id = vertex(JsonCursor(row, 0));
      const double value = reader_.number(JsonCursor(row, 1));
      take_error(reader_, row, check_alpha(value));
      if (ascends(reader_, row, last, id)) shaping.alpha.set(id, value);
    });
  }
  void read_beta(const JsonCursor& list, Shaping& shaping) {
    std::optional<EdgeId> last;
    reader_.for_each(list, [&](const JsonCursor& row) {
      if (reader_.array_size(row, 3, 3) != 3) return;
      const EdgeId id = edge(row);
      const double value = reader_.number(JsonCursor(row, 2));
      take_error(reader_, row, check_beta(value));
      if (ascends(reader_, row, last, id)) shaping.beta.set(id, value);
    });
  }
  void read_crease(const JsonCursor& list, Shaping& shaping) {
    std::optional<EdgeId> last;
    reader_.for_each(list, [&](const JsonCursor& row) {
      if (reader_.array_size(row, 2, 2) != 2) return;
      const EdgeId id = edge(row);
      if (ascends(reader_, row, last, id)) shaping.crease.set(id, true);
    });
  }
  void read_tags(const JsonCursor& list, Shaping& shaping) {
    std::optional<VertexId> last;
    reader_.for_each(list, [&](const JsonCursor& row) {
      if (reader_.array_size(row, 2, 2) != 2) return;
      const VertexId id = vertex(JsonCursor(row, 0));
      const auto tag = static_cast<VertexTag>(reader_.choice(JsonCursor(row, 1), tag_names));
      if (ascends(reader_, row, last, id)) shaping.tag.set(id, tag);
    });
  }
  void read_pins(const JsonCursor& list, Shaping& shaping) {
    std::optional<VertexId> last;
    reader_.for_each(list, [&](const JsonCursor& row) {
      if (!reader_.is_object(row)) return;
      refuse_unknown_members(reader_, row, pin_members);
      VertexId id;
      Pin pin;
      reader_.member(row, "vertex", [&](const JsonCursor& at) { id = vertex(at); });
      reader_.member(row, "kind", [&](const JsonCursor& at) {
        pin.kind = static_cast<Pin::Kind>(reader_.choice(at, pin_names));
      });
      reader_.member(row, "vectors", [&](const JsonCursor& at) {
        reader_.for_each(at,
                         [&](const JsonCursor& vector) { pin.vectors.push_back(reader_.vector(vector)); });
      });
      if (reader_.failed()) return;
      take_error(reader_, row, check_pin(pin));
      if (ascends(reader_, row, last, id)) shaping.pin.set(id, std::move(pin));
    });
  }

  void read_forms(const JsonCursor& list, Shaping& shaping) {
    std::optional<VertexId> last;
    reader_.for_each(list, [&](const JsonCursor& row) {
      if (!reader_.is_object(row)) return;
      refuse_unknown_members(reader_, row, form_members);
      VertexId id;
      KeptForm form;
      reader_.member(row, "vertex", [&](const JsonCursor& at) { id = vertex(at); });
      reader_.member(row, "edges", [&](const JsonCursor& at) {
        std::optional<VertexId> last_end;
        reader_.for_each(at, [&](const JsonCursor& edge) {
          // Before version 6 a row ends in a force, which is ignored now.
          const std::size_t size = reader_.version() < 6 ? 9 : 8;
          if (reader_.array_size(edge, size, size) != size) return;
          KeptForm::Edge kept;
          kept.to = vertex(JsonCursor(edge, 0));
          kept.turn = reader_.number(JsonCursor(edge, 1));
          kept.stretch = reader_.number(JsonCursor(edge, 2));
          for (Eigen::Index i = 0; i < 3; ++i)
            kept.offset[i] = reader_.number(JsonCursor(edge, std::size_t(i) + 3));
          if (size == 8) {
            kept.lean = reader_.number(JsonCursor(edge, 6));
            kept.side = reader_.number(JsonCursor(edge, 7));
          }
          if (ascends(reader_, edge, last_end, kept.to)) form.edges.push_back(kept);
        });
      });
      if (reader_.failed()) return;
      take_error(reader_, row, check_form(form));
      if (ascends(reader_, row, last, id)) shaping.form.set(id, std::move(form));
    });
  }

  void read_areas(const JsonCursor& list, Shaping& shaping) {
    std::optional<FaceId> last;
    reader_.for_each(list, [&](const JsonCursor& row) {
      if (reader_.array_size(row, 2, 2) != 2) return;
      const FaceId id{reader_.integer(JsonCursor(row, 0), 0, max_id)};
      if (!reader_.failed() && polyhedron_.find(id) == no_index)
        reader_.fail(row, "there is no face with this id");
      const double factor = reader_.number(JsonCursor(row, 1));
      take_error(reader_, row, check_kept_area(factor));
      if (ascends(reader_, row, last, id)) shaping.kept_area.set(id, factor);
    });
  }

  JsonReader& reader_;
  const Polyhedron& polyhedron_;
  std::optional<EdgeSet> edges_;  ///< made at the first lookup
};

Vector3 read_origin(JsonReader& reader, const JsonCursor& at) {
  Vector3 origin = Vector3::Zero();
  reader.if_member(at, "origin", [&](const JsonCursor& member) { origin = reader.vector(member); });
  return origin;
}

Mirror read_mirror(JsonReader& reader, const JsonCursor& at) {
  Mirror mirror;
  if (!reader.is_object(at)) return mirror;
  refuse_unknown_members(reader, at, mirror_members);
  reader.member(at, "axis", [&](const JsonCursor& member) {
    mirror.axis = static_cast<Axis>(reader.choice(member, axis_names));
  });
  reader.member(at, "weld_distance",
                [&](const JsonCursor& member) { mirror.weld_distance = reader.number(member); });
  if (!reader.failed()) take_error(reader, at, check_mirror(mirror));
  return mirror;
}

Preparation read_preparation(JsonReader& reader, const JsonCursor& at) {
  Preparation preparation;
  if (!reader.is_object(at)) return preparation;
  refuse_unknown_members(reader, at, preparation_members);
  reader.if_member(at, "split_concave",
                   [&](const JsonCursor& member) { preparation.split_concave = reader.boolean(member); });
  reader.if_member(at, "merge_coplanar",
                   [&](const JsonCursor& member) { preparation.merge_coplanar = reader.boolean(member); });
  reader.if_member(at, "automatic_tension",
                   [&](const JsonCursor& member) { preparation.automatic_tension = reader.number(member); });
  if (!reader.failed()) take_error(reader, at, check_preparation(preparation));
  return preparation;
}

FrozenSide read_frozen(JsonReader& reader, const JsonCursor& at) {
  FrozenSide frozen;
  if (!reader.is_object(at)) return frozen;
  refuse_unknown_members(reader, at, frozen_members);
  const auto points = [&](std::string_view name, std::array<Vector3, 4>& out) {
    reader.member(at, name, [&](const JsonCursor& list) {
      if (reader.array_size(list, 4, 4) != 4) return;
      for (std::size_t i = 0; i < 4; ++i) out[i] = reader.vector(JsonCursor(list, i));
    });
  };
  points("curve", frozen.curve);
  points("row", frozen.row);
  return frozen;
}

/// Reads attachments. The objects and sides they refer to need not exist; the surface reports that.
Attachments read_attachments(JsonReader& reader, const JsonCursor& list) {
  Attachments out;
  std::optional<EdgeId> last;
  reader.for_each(list, [&](const JsonCursor& row) {
    if (!reader.is_object(row)) return;
    refuse_unknown_members(reader, row, attachment_members);
    EdgeId edge;
    Attachment attachment;
    reader.member(row, "edge", [&](const JsonCursor& at) {
      if (reader.array_size(at, 2, 2) != 2) return;
      edge = {{reader.integer(JsonCursor(at, 0), 0, max_id)}, {reader.integer(JsonCursor(at, 1), 0, max_id)}};
      if (!(edge.low < edge.high)) reader.fail(at, "the smaller id comes first");
    });
    reader.if_member(row, "frozen",
                     [&](const JsonCursor& at) { attachment.frozen = read_frozen(reader, at); });
    if (!attachment.frozen) {
      reader.member(row, "patch",
                    [&](const JsonCursor& at) { attachment.patch.value = reader.integer(at, 0, max_id); });
      reader.member(row, "side", [&](const JsonCursor& at) {
        if (reader.array_size(at, 2, 2) != 2) return;
        attachment.side.side = static_cast<std::uint8_t>(reader.integer(JsonCursor(at, 0), 0, 3));
        attachment.side.place = reader.integer(JsonCursor(at, 1), 0, PatchSource::max_patches);
      });
      reader.if_member(row, "reversed",
                       [&](const JsonCursor& at) { attachment.reversed = reader.boolean(at); });
    }
    reader.if_member(row, "continuity", [&](const JsonCursor& at) {
      attachment.continuity = static_cast<Continuity>(reader.choice(at, continuity_names));
    });
    reader.if_member(row, "adapts", [&](const JsonCursor& at) {
      attachment.adapts = static_cast<Adapts>(reader.choice(at, adapts_names));
    });
    if (ascends(reader, row, last, edge)) out.set(edge, attachment);
  });
  return out;
}

std::optional<Source> read_polyhedron(JsonReader& reader, const JsonCursor& at, std::string_view text) {
  Mode mode = Mode::fair;
  reader.if_member(at, "mode", [&](const JsonCursor& member) {
    mode = static_cast<Mode>(reader.choice(member, mode_names));
  });
  Frames frames = Frames::equal;
  reader.if_member(at, "frames", [&](const JsonCursor& member) {
    frames = static_cast<Frames>(reader.choice(member, frames_names));
  });
  // Obsolete setting of mode G2, ignored.
  reader.if_member(at, "round", [&](const JsonCursor& member) { (void)reader.boolean(member); });
  std::optional<Mirror> mirror;
  reader.if_member(at, "mirror", [&](const JsonCursor& member) { mirror = read_mirror(reader, member); });
  Preparation preparation;
  reader.if_member(at, "preparation",
                   [&](const JsonCursor& member) { preparation = read_preparation(reader, member); });
  const Vector3 origin = read_origin(reader, at);
  Lists lists;
  reader.member(at, "vertices", [&](const JsonCursor& member) { read_vertices(reader, member, lists); });
  reader.member(at, "faces", [&](const JsonCursor& member) { read_faces(reader, member, lists); });
  if (reader.failed()) return std::nullopt;
  Result<Polyhedron> polyhedron =
      Polyhedron::build(lists.mesh, std::move(lists.vertex_ids), std::move(lists.face_ids));
  if (!polyhedron) {
    Message message = polyhedron.error();
    message.text = at.path() + ": " + message.text;
    reader.fail(std::move(message));
    return std::nullopt;
  }
  Shaping shaping = ShapingReader(reader, *polyhedron).read(at);
  Attachments attachments;
  reader.if_member(at, "attached",
                   [&](const JsonCursor& list) { attachments = read_attachments(reader, list); });
  if (reader.failed()) return std::nullopt;
  return PolyhedronSource{origin,
                          *std::move(polyhedron),
                          std::move(shaping),
                          mode,
                          kept_members(at, polyhedron_members, text),
                          mirror,
                          preparation,
                          std::move(attachments),
                          frames};
}

std::optional<Source> read_patches(JsonReader& reader, const JsonCursor& at, std::string_view text) {
  const Vector3 origin = read_origin(reader, at);
  BicubicNet net;
  const auto count = [&](std::string_view name, Index& value) {
    reader.member(at, name, [&](const JsonCursor& member) {
      value = reader.integer(member, 1, PatchSource::max_patches);
    });
  };
  count("columns", net.columns);
  count("rows", net.rows);
  reader.member(at, "points", [&](const JsonCursor& list) {
    reader.for_each(list, [&](const JsonCursor& row) { net.points.push_back(reader.vector(row)); });
  });
  if (reader.failed()) return std::nullopt;
  Result<PatchSource> source = PatchSource::from_net(origin, net);
  if (!source) {
    reader.fail(at, source.error().text);
    return std::nullopt;
  }
  PatchSource out = std::move(source).value();
  out.kept = kept_members(at, patches_members, text);
  return out;
}

BezierPatch read_bezier_patch(JsonReader& reader, const JsonCursor& at) {
  BezierPatch patch;
  if (!reader.is_object(at)) return patch;
  refuse_unknown_members(reader, at, bezier_patch_members);
  reader.member(at, "degree", [&](const JsonCursor& pair) {
    if (reader.array_size(pair, 2, 2) != 2) return;
    patch.degree_s = int(reader.integer(JsonCursor(pair, 0), 1, max_bezier_degree));
    patch.degree_t = int(reader.integer(JsonCursor(pair, 1), 1, max_bezier_degree));
  });
  const auto count = std::size_t(patch.degree_s + 1) * std::size_t(patch.degree_t + 1);
  reader.member(at, "points", [&](const JsonCursor& list) {
    if (reader.array_size(list, count, count) != count) return;
    reader.for_each(list, [&](const JsonCursor& row) { patch.points.push_back(reader.vector(row)); });
  });
  reader.if_member(at, "weights", [&](const JsonCursor& list) {
    if (reader.array_size(list, count, count) != count) return;
    reader.for_each(list, [&](const JsonCursor& weight) { patch.weights.push_back(reader.number(weight)); });
  });
  return patch;
}

std::optional<Source> read_bezier(JsonReader& reader, const JsonCursor& at, std::string_view text) {
  const Vector3 origin = read_origin(reader, at);
  std::vector<BezierPatch> patches;
  reader.member(at, "patches", [&](const JsonCursor& list) {
    if (reader.array_size(list, 1, BezierSource::max_patches) == 0) return;
    reader.for_each(list,
                    [&](const JsonCursor& patch) { patches.push_back(read_bezier_patch(reader, patch)); });
  });
  if (reader.failed()) return std::nullopt;
  Result<BezierSource> source = BezierSource::from_patches(origin, std::move(patches));
  if (!source) {
    reader.fail(at, source.error().text);
    return std::nullopt;
  }
  BezierSource out = std::move(source).value();
  out.kept = kept_members(at, bezier_members, text);
  return out;
}

std::optional<Source> read_mesh(JsonReader& reader, const JsonCursor& at, std::string_view text) {
  const Vector3 origin = read_origin(reader, at);
  PolygonMesh mesh;
  reader.member(at, "vertices", [&](const JsonCursor& list) {
    reader.for_each(list, [&](const JsonCursor& row) { mesh.positions.push_back(reader.vector(row)); });
  });
  reader.member(at, "faces", [&](const JsonCursor& list) {
    if (reader.array_size(list, 1, std::size_t(-1)) == 0) return;
    std::vector<Index> corners;
    reader.for_each(list, [&](const JsonCursor& row) {
      const std::size_t size = reader.array_size(row, 3, std::size_t(-1));
      corners.clear();
      for (std::size_t i = 0; i < size && !reader.failed(); ++i) {
        const Index corner = reader.integer(JsonCursor(row, i), 0, max_id);
        if (corner >= mesh.positions.size())
          reader.fail(JsonCursor(row, i), "there are not so many vertices");
        corners.push_back(corner);
      }
      mesh.add_face(corners);
    });
  });
  if (reader.failed()) return std::nullopt;
  return MeshSource{origin, std::move(mesh), kept_members(at, mesh_members, text)};
}

}  // namespace

std::optional<Source> read_source(JsonReader& reader, const JsonCursor& at, std::string_view text) {
  if (!reader.is_object(at)) return std::nullopt;
  std::string kind;
  reader.member(at, "kind", [&](const JsonCursor& member) { kind = reader.string(member); });
  if (reader.failed()) return std::nullopt;
  if (kind == "polyhedron") return read_polyhedron(reader, at, text);
  if (kind == "mesh") return read_mesh(reader, at, text);
  if (kind == "patches") return read_patches(reader, at, text);
  if (kind == "bezier") return read_bezier(reader, at, text);
  if (kind == "solids") {
    EnvelopeInput input = read_solids(reader, at);
    if (reader.failed()) return std::nullopt;
    return SolidsSource{std::move(input), kept_members(at, solids_members, text)};
  }
  if (kind == "skin") {
    Skin skin = read_skin(reader, at);
    if (reader.failed()) return std::nullopt;
    return SkinSource{std::move(skin), kept_members(at, skin_members, text)};
  }
  if (kind == "outline") {
    Outline outline = read_loops(reader, at);
    const OutlineSettings settings = read_outline_settings(reader, at);
    if (reader.failed()) return std::nullopt;
    return OutlineSource{std::move(outline), settings, kept_members(at, outline_members, text)};
  }
  if (kind == "picture") {
    PictureSource picture = read_picture(reader, at);
    picture.kept = kept_members(at, picture_members, text);
    if (reader.failed()) return std::nullopt;
    return picture;
  }
  const JsonMember& whole = *at.member();
  return UnknownSource{kind, std::string(text.substr(whole.begin, whole.end - whole.begin))};
}

KeptMembers kept_members(const JsonCursor& at, Names known, std::string_view text) {
  KeptMembers kept;
  for (const JsonMember& member : *at.value().object())
    if (!is_known(member.name, known))
      kept.push_back({member.name, std::string(text.substr(member.begin, member.end - member.begin))});
  return kept;
}

void refuse_unknown_members(JsonReader& reader, const JsonCursor& at, Names known) {
  for (const JsonMember& member : *at.value().object())
    if (!is_known(member.name, known))
      reader.fail(at, "the member \"" + shortened(member.name, 120) + "\" is unknown");
}

}  // namespace hariko::detail

// Polyhedra in files.

#include <algorithm>

#include "core/document/edits/edge_set.hpp"
#include "core/document/edits/edit_elements.hpp"
#include "core/document/format/archive.hpp"
#include "core/document/format/described.hpp"
#include "core/document/words.hpp"

namespace hariko::detail {

/// Elements of a polyhedron, which its settings name.
class NamedElements {
 public:
  explicit NamedElements(const Polyhedron& polyhedron) : polyhedron_(polyhedron) {}
  bool has(VertexId id) const { return polyhedron_.find(id) != no_index; }
  bool has(FaceId id) const { return polyhedron_.find(id) != no_index; }
  bool has(EdgeId id) {
    if (!edges_) edges_.emplace(polyhedron_);
    return edges_->contains(id);
  }

 private:
  const Polyhedron& polyhedron_;
  std::optional<EdgeSet> edges_;  ///< made at the first lookup
};

static void read_value(JsonReader& reader, const JsonCursor& at, VertexId& id,
                       const NamedElements* elements) {
  read_value(reader, at, id.value);
  if (!reader.failed() && !elements->has(id)) reader.fail(at, "there is no vertex with this id");
}

template <class Archive>
void describe(Archive& archive, Described<Archive, KeptForm::Edge>& edge,
              const NamedElements* elements = nullptr) {
  const bool with_force = archive.before(6);
  archive.row(with_force ? 9 : 8);
  archive.entry(edge.to, elements);
  archive.entry(edge.turn);
  archive.entry(edge.stretch);
  for (Eigen::Index i = 0; i < 3; ++i) archive.entry(edge.offset[i]);
  if (with_force) return;
  archive.entry(edge.lean);
  archive.entry(edge.side);
}
static void read_value(JsonReader& reader, const JsonCursor& at, std::vector<KeptForm::Edge>& edges,
                       const NamedElements* elements) {
  reader.for_each(at, [&](const JsonCursor& row) {
    KeptForm::Edge edge;
    read_described(reader, row, edge, elements);
    if (!edges.empty() && !(edges.back().to < edge.to)) reader.fail(row, std::string(Ascending{}.text));
    edges.push_back(edge);
  });
}

template <class Archive>
void describe_shaping(Archive& archive, Described<Archive, Shaping>& shaping, const Polyhedron& polyhedron) {
  NamedElements elements(polyhedron);
  const NamedElements* known = &elements;
  const auto name_edge = [&](auto& row, auto& edge) {
    row.entry(edge.low);
    row.entry(edge.high);
    row.require([&] { return elements.has(edge); },
                "there is no edge between these vertices, the smaller id first");
  };
  archive.rows("alpha", shaping.alpha, [&](auto& row, auto& vertex, auto& tension) {
    row.row(2);
    row.entry(vertex, known);
    row.entry(tension);
    row.check([&] { return check_alpha(tension); });
  });
  archive.rows("beta", shaping.beta, [&](auto& row, auto& edge, auto& tension) {
    row.row(3);
    name_edge(row, edge);
    row.entry(tension);
    row.check([&] { return check_beta(tension); });
  });
  archive.rows("crease", shaping.crease, [&](auto& row, auto& edge, auto& sharp) {
    row.row(2);
    name_edge(row, edge);
    row.assume(sharp, true);
  });
  archive.rows("tag", shaping.tag, [&](auto& row, auto& vertex, auto& tag) {
    row.row(2);
    row.entry(vertex, known);
    row.entry(tag);
  });
  archive.rows("pin", shaping.pin, [&](auto& row, auto& vertex, auto& pin) {
    row.line();
    row.required("vertex", vertex, known);
    row.required("kind", pin.kind);
    row.required("vectors", pin.vectors);
    row.check([&] { return check_pin(pin); });
  });
  archive.rows("form", shaping.form, [&](auto& row, auto& vertex, auto& form) {
    row.line();
    row.required("vertex", vertex, known);
    row.required("edges", form.edges, known);
    row.check([&] { return check_form(form); });
  });
  archive.rows("kept_area", shaping.kept_area, [&](auto& row, auto& face, auto& factor) {
    row.row(2);
    row.entry(face);
    row.require([&] { return elements.has(face); }, "there is no face with this id");
    row.entry(factor);
    row.check([&] { return check_kept_area(factor); });
  });
}

template <class Archive>
void describe(Archive& archive, Described<Archive, FrozenSide>& frozen) {
  archive.line();
  archive.required("curve", frozen.curve);
  archive.required("row", frozen.row);
}

template <class Archive>
void describe(Archive& archive, Described<Archive, NetSide>& side) {
  archive.row(2);
  std::uint32_t number = side.side;
  archive.entry(number, Whole{0, 3});
  archive.assume(side.side, static_cast<std::uint8_t>(number));
  archive.entry(side.place, Whole{0, PatchSource::max_patches});
}

/// The objects and sides that attachments refer to need not exist; the surface reports that.
template <class Archive>
void describe_attachments(Archive& archive, Described<Archive, Attachments>& attachments) {
  archive.rows("attached", attachments, [](auto& row, auto& edge, auto& attachment) {
    row.line();
    row.required("edge", edge, std::string_view("the smaller id comes first"));
    row.member("frozen", attachment.frozen);
    if (attachment.frozen) {
      row.known({"patch", "side", "reversed"});
    } else {
      row.required("patch", attachment.patch);
      row.required("side", attachment.side);
      row.member("reversed", attachment.reversed);
    }
    row.member("continuity", attachment.continuity);
    row.member("adapts", attachment.adapts);
  });
}

template <class Archive>
void describe(Archive& archive, Described<Archive, Mirror>& mirror) {
  archive.line();
  archive.required("axis", mirror.axis);
  archive.required("weld_distance", mirror.weld_distance);
  archive.check([&] { return check_mirror(mirror); });
}

template <class Archive>
void describe(Archive& archive, Described<Archive, Preparation>& preparation) {
  archive.line();
  archive.member("split_concave", preparation.split_concave);
  archive.changed("merge_coplanar", preparation.merge_coplanar, false);
  archive.member("automatic_tension", preparation.automatic_tension);
  archive.check([&] { return check_preparation(preparation); });
}

/// Members before the vertices.
template <class Archive, class Settings>
void describe_settings(Archive& archive, Settings& settings) {
  archive.lines();
  archive.constant("kind", PolyhedronSource::kind);
  archive.member("mode", settings.mode);
  archive.changed("frames", settings.frames, Frames::equal);
  archive.member("mirror", settings.mirror);
  archive.changed("preparation", settings.preparation, {});
  archive.member("origin", settings.origin);
}

/// A polyhedron in a file, before it is built.
struct FilePolyhedron {
  Vector3 origin = Vector3::Zero();
  Mode mode = Mode::fair;
  std::optional<Mirror> mirror;
  Preparation preparation;
  Frames frames = Frames::equal;
  PolygonMesh mesh;
  std::vector<VertexId> vertex_ids;
  std::vector<FaceId> face_ids;
};

/// Reads rows [id, x, y, z].
static void read_vertices(JsonReader& reader, const JsonCursor& at, FilePolyhedron& out) {
  reader.for_each(at, [&](const JsonCursor& entry) {
    VertexId id;
    Vector3 position;
    ReadArchive row(reader, entry);
    row.row(4);
    row.entry(id);
    for (double& coordinate : position) row.entry(coordinate);
    row.require([&] { return out.vertex_ids.empty() || out.vertex_ids.back() < id; }, Ascending{}.text);
    out.vertex_ids.push_back(id);
    out.mesh.positions.push_back(position);
  });
}

/// Reads rows [id, vertex id, vertex id, ...].
static void read_faces(JsonReader& reader, const JsonCursor& at, FilePolyhedron& out) {
  std::vector<Index> corners;
  reader.for_each(at, [&](const JsonCursor& row) {
    const std::size_t size = reader.array_size(row, 1, std::size_t(-1));
    if (size == 0) return;
    const FaceId id{reader.integer(JsonCursor(row, 0), 0, max_id)};
    if (!out.face_ids.empty() && !(out.face_ids.back() < id))
      return reader.fail(row, std::string(Ascending{}.text));
    corners.clear();
    for (std::size_t i = 1; i < size && !reader.failed(); ++i) {
      const JsonCursor corner(row, i);
      const VertexId vertex{reader.integer(corner, 0, max_id)};
      const auto found = std::lower_bound(out.vertex_ids.begin(), out.vertex_ids.end(), vertex);
      if (found == out.vertex_ids.end() || *found != vertex)
        reader.fail(corner, "there is no vertex with this id");
      corners.push_back(static_cast<Index>(found - out.vertex_ids.begin()));
    }
    out.face_ids.push_back(id);
    out.mesh.add_face(corners);
  });
}

std::optional<PolyhedronSource> read_polyhedron(JsonReader& reader, const JsonCursor& at) {
  FilePolyhedron file;
  Shaping shaping;
  Attachments attachments;
  KeptMembers kept;
  ReadArchive archive(reader, at);
  describe_settings(archive, file);
  bool round = false;  // obsolete setting of mode G2
  archive.member("round", round);
  archive.with_required("vertices", [&](const JsonCursor& list) { read_vertices(reader, list, file); });
  archive.with_required("faces", [&](const JsonCursor& list) { read_faces(reader, list, file); });
  if (reader.failed()) return std::nullopt;
  Result<Polyhedron> polyhedron =
      Polyhedron::build(file.mesh, std::move(file.vertex_ids), std::move(file.face_ids));
  if (!polyhedron) {
    reader.fail(at, polyhedron.error());
    return std::nullopt;
  }
  describe_shaping(archive, shaping, *polyhedron);
  describe_attachments(archive, attachments);
  archive.kept(kept);
  if (reader.failed()) return std::nullopt;
  return PolyhedronSource{file.origin,      *std::move(polyhedron), std::move(shaping),
                          file.mode,        std::move(kept),        file.mirror,
                          file.preparation, std::move(attachments), file.frames};
}

void write_value(DocumentText& text, const PolyhedronSource& source) {
  const Polyhedron& polyhedron = source.polyhedron;
  WriteArchive archive(text);
  describe_settings(archive, source);
  archive.numbered_rows("vertices", polyhedron.vertex_count(), [&](WriteArchive& row, Index v) {
    row.entry(polyhedron.vertex_id(v));
    for (const double coordinate : polyhedron.position(v)) row.entry(coordinate);
  });
  archive.numbered_rows("faces", polyhedron.face_count(), [&](WriteArchive& row, Index f) {
    row.entry(polyhedron.face_id(f));
    for (const Index corner : polyhedron.topology().face_vertices(f)) row.entry(polyhedron.vertex_id(corner));
  });
  describe_shaping(archive, *source.shaping, polyhedron);
  describe_attachments(archive, *source.attachments);
  archive.kept(source.kept);
  archive.close();
}

}  // namespace hariko::detail

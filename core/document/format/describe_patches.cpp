// Patches and reference meshes in files.

#include "core/document/format/archive.hpp"
#include "core/document/format/described.hpp"

namespace hariko::detail {

static void write_positions(WriteArchive& archive, std::string_view name, const Polyhedron& net) {
  archive.numbered_rows(name, net.vertex_count(), [&](WriteArchive& row, Index v) {
    for (const double coordinate : net.position(v)) row.entry(coordinate);
  });
}

/// Members of a grid before its points.
template <class Archive, class Grid>
void describe_grid(Archive& archive, Described<Archive, Vector3>& origin, Grid& grid) {
  archive.lines();
  archive.constant("kind", PatchSource::kind);
  archive.member("origin", origin);
  archive.required("columns", grid.columns, Whole{1, PatchSource::max_patches});
  archive.required("rows", grid.rows, Whole{1, PatchSource::max_patches});
}

std::optional<PatchSource> read_patches(JsonReader& reader, const JsonCursor& at) {
  Vector3 origin = Vector3::Zero();
  BicubicNet net;
  KeptMembers kept;
  ReadArchive archive(reader, at);
  describe_grid(archive, origin, net);
  archive.required("points", net.points);
  archive.kept(kept);
  if (reader.failed()) return std::nullopt;
  Result<PatchSource> source = PatchSource::from_net(origin, net);
  if (!source) {
    reader.fail(at, source.error().text);
    return std::nullopt;
  }
  source.value().kept = std::move(kept);
  return std::move(source).value();
}
void write_value(DocumentText& text, const PatchSource& source) {
  WriteArchive archive(text);
  describe_grid(archive, source.origin, source);
  write_positions(archive, "points", source.net);
  archive.kept(source.kept);
  archive.close();
}

template <class Archive>
void describe(Archive& archive, Described<Archive, BezierPatch>& patch) {
  archive.lines();
  archive.required_row("degree", Whole{1, max_bezier_degree}, patch.degree_s, patch.degree_t);
  const auto points = std::size_t(patch.degree_s + 1) * std::size_t(patch.degree_t + 1);
  archive.required_list("points", patch.points, Count{points, points});
  archive.changed("weights", patch.weights, {}, Count{points, points});
}

template <class Archive>
void describe(Archive& archive, Described<Archive, BezierSource>& source) {
  archive.lines();
  archive.constant("kind", BezierSource::kind);
  archive.member("origin", source.origin);
  archive.shared(source.patches, [&](auto& patches) {
    archive.required_list("patches", patches, Count{1, BezierSource::max_patches});
  });
  archive.kept(source.kept);
}

void read_value(JsonReader& reader, const JsonCursor& at, BezierSource& source) {
  read_described(reader, at, source);
  for (std::size_t k = 0; k < source.patches->size() && !reader.failed(); ++k)
    if (const auto error = check_patch((*source.patches)[k], k)) reader.fail(at, error->text);
}
void write_value(DocumentText& text, const BezierSource& source) {
  write_described(text, source);
}

/// Faces of a reference mesh, whose positions are read before.
static void read_value(JsonReader& reader, const JsonCursor& at, PolygonMesh& mesh) {
  std::vector<Index> corners;
  reader.array_size(at, 1, std::size_t(-1));
  reader.for_each(at, [&](const JsonCursor& row) {
    corners.clear();
    read_value(reader, row, corners, Count{3});
    for (std::size_t i = 0; i < corners.size() && !reader.failed(); ++i)
      if (corners[i] >= mesh.positions.size())
        reader.fail(JsonCursor(row, i), "there are not so many vertices");
    mesh.add_face(corners);
  });
}
static void write_faces(WriteArchive& archive, const PolygonMesh& mesh) {
  archive.numbered_rows("faces", mesh.face_count(), [&](WriteArchive& row, Index f) {
    for (const Index corner : mesh.face(f)) row.entry(corner);
  });
}

template <class Archive>
void describe(Archive& archive, Described<Archive, MeshSource>& source) {
  archive.lines();
  archive.constant("kind", MeshSource::kind);
  archive.member("origin", source.origin);
  archive.shared(source.mesh, [&](auto& mesh) {
    archive.required_list("vertices", mesh.positions);
    if constexpr (Archive::reads)
      archive.required("faces", mesh);
    else
      write_faces(archive, mesh);
  });
  archive.kept(source.kept);
}

void read_value(JsonReader& reader, const JsonCursor& at, MeshSource& source) {
  read_described(reader, at, source);
}
void write_value(DocumentText& text, const MeshSource& source) {
  write_described(text, source);
}

}  // namespace hariko::detail

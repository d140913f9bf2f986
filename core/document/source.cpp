#include "core/document/source.hpp"

#include "core/polyhedron/validation.hpp"

namespace hariko {
namespace {

bool finite(const Vector3& v) {
  return v.allFinite();
}

/// Makes positions relative to a chosen origin; E_NONFINITE names the first bad vertex.
Result<Vector3> take_origin(std::vector<Vector3>& positions) {
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (!finite(positions[v]))
      return make_error(e_nonfinite, "The position of the vertex is not a finite number.",
                        "Give the vertex a finite position.", {Element::Kind::vertex, v});
  Vector3 origin = origin_for(positions);
  // A box wider than the largest number has no representable centre; such coordinates stay absolute.
  if (!finite(origin)) origin.setZero();
  for (Vector3& position : positions) position -= origin;
  return origin;
}

bool equal_meshes(const PolygonMesh& a, const PolygonMesh& b) {
  return a.positions == b.positions && a.face_offsets == b.face_offsets && a.face_vertices == b.face_vertices;
}

}  // namespace

Result<Done> check_preparation(const Preparation& preparation) {
  if (!(preparation.automatic_tension >= 0 && preparation.automatic_tension <= 1))
    return make_error(e_automatic_tension_range, "The automatic tension is out of range.",
                      "Use a number from 0 to 1.");
  return Done{};
}

Result<PolyhedronSource> PolyhedronSource::from_mesh(PolygonMesh mesh) {
  const Result<Vector3> origin = take_origin(mesh.positions);
  if (!origin) return origin.error();
  Result<Polyhedron> polyhedron = Polyhedron::build(mesh);
  if (!polyhedron) return polyhedron.error();
  return PolyhedronSource{*origin, *std::move(polyhedron), {}, Mode::fair, {}};
}

PolyhedronSource as_new(PolyhedronSource source) {
  source.frames = Frames::metric;
  source.preparation.split_concave = true;
  source.preparation.merge_coplanar = true;
  return source;
}

bool operator==(const PolyhedronSource& a, const PolyhedronSource& b) {
  return a.origin == b.origin && a.mode == b.mode && a.frames == b.frames && a.shaping == b.shaping &&
         a.kept == b.kept && a.mirror == b.mirror && a.preparation == b.preparation &&
         a.attachments == b.attachments && a.polyhedron == b.polyhedron;
}

Result<MeshSource> MeshSource::from_mesh(PolygonMesh mesh) {
  if (mesh.face_count() == 0)
    return make_error(e_no_faces, "The mesh has no faces.", "Import a file that has faces.");
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const Element element{Element::Kind::face, f};
    if (mesh.face(f).size() < 3)
      return make_error(e_face_too_small, "The face has fewer than three corners.", "Delete the face.",
                        element);
    for (const Index v : mesh.face(f))
      if (v >= mesh.positions.size())
        return make_error(e_index_range, "The face uses a vertex that does not exist.", "Delete the face.",
                          element);
  }
  const Result<Vector3> origin = take_origin(mesh.positions);
  if (!origin) return origin.error();
  return MeshSource{*origin, std::move(mesh), {}};
}

bool operator==(const MeshSource& a, const MeshSource& b) {
  return a.origin == b.origin && a.kept == b.kept &&
         (a.mesh.get() == b.mesh.get() || equal_meshes(*a.mesh, *b.mesh));
}

Result<PatchSource> PatchSource::from_net(const Vector3& origin, const BicubicNet& net) {
  const bool fits = net.columns > 0 && net.rows > 0 && net.columns <= max_patches / net.rows &&
                    net.points.size() == std::size_t(net.width()) * net.height();
  if (!fits)
    return make_error(e_patch_grid, "The points do not make a grid of bicubic patches.",
                      "A grid of m x n patches has (3 m + 1) x (3 n + 1) points.");
  PolygonMesh mesh;
  mesh.positions = net.points;
  for (Index j = 0; j + 1 < net.height(); ++j)
    for (Index i = 0; i + 1 < net.width(); ++i)
      mesh.add_face({net.index(i, j), net.index(i + 1, j), net.index(i + 1, j + 1), net.index(i, j + 1)});
  Result<Polyhedron> built = Polyhedron::build(mesh);
  if (!built) return built.error();
  return PatchSource{origin, net.columns, net.rows, *std::move(built), {}};
}

Result<PatchSource> PatchSource::from_net(const BicubicNet& net) {
  BicubicNet relative = net;
  const Result<Vector3> origin = take_origin(relative.points);
  if (!origin) return origin.error();
  return from_net(*origin, relative);
}

bool operator==(const PatchSource& a, const PatchSource& b) {
  return a.origin == b.origin && a.columns == b.columns && a.rows == b.rows && a.kept == b.kept &&
         a.net == b.net;
}

Result<BezierSource> BezierSource::from_patches(const Vector3& origin, std::vector<BezierPatch> patches) {
  if (patches.empty() || patches.size() > max_patches)
    return make_error(e_patch_points, "There are no Bezier patches, or too many.",
                      "An object has 1 to " + std::to_string(max_patches) + " patches.");
  for (std::size_t k = 0; k < patches.size(); ++k)
    if (auto error = check_patch(patches[k], k)) return *error;
  return BezierSource{origin, std::move(patches), {}};
}

Result<BezierSource> BezierSource::from_patches(std::vector<BezierPatch> patches) {
  // Checked before the origin is chosen, so that a message names the patch.
  for (std::size_t k = 0; k < patches.size(); ++k)
    if (auto error = check_patch(patches[k], k)) return *error;
  std::vector<Vector3> points;
  for (const BezierPatch& patch : patches)
    points.insert(points.end(), patch.points.begin(), patch.points.end());
  const Vector3 origin = origin_for(points);
  for (BezierPatch& patch : patches)
    for (Vector3& point : patch.points) point -= origin;
  return from_patches(origin, std::move(patches));
}

std::optional<Frames> stored_frames(const Source& source) {
  if (const auto* polyhedron = std::get_if<PolyhedronSource>(&source)) return polyhedron->frames;
  if (const auto* outline = std::get_if<OutlineSource>(&source)) return outline->settings.frames;
  return std::nullopt;
}

std::optional<Frames> surface_frames(const Source& source) {
  return stored_mode(source) == Mode::paper ? std::nullopt : stored_frames(source);
}

std::optional<Mode> stored_mode(const Source& source) {
  const auto* polyhedron = std::get_if<PolyhedronSource>(&source);
  return polyhedron ? std::optional(polyhedron->mode) : std::nullopt;
}

}  // namespace hariko

#include "core/document/source.hpp"

#include "core/polyhedron/validation.hpp"

namespace hariko {
namespace {

bool finite(const Vector3& v) {
  return v.allFinite();
}

/// Makes positions relative to their origin; E_NONFINITE names the first bad vertex.
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

Result<PolyhedronSource> PolyhedronSource::from_mesh(PolygonMesh mesh) {
  const Result<Vector3> origin = take_origin(mesh.positions);
  if (!origin) return origin.error();
  Result<Polyhedron> polyhedron = Polyhedron::build(mesh);
  if (!polyhedron) return polyhedron.error();
  return PolyhedronSource{*origin, *std::move(polyhedron), {}, Mode::fair, {}};
}

bool operator==(const PolyhedronSource& a, const PolyhedronSource& b) {
  return a.origin == b.origin && a.mode == b.mode && a.shaping == b.shaping && a.kept == b.kept &&
         a.mirror == b.mirror && a.polyhedron == b.polyhedron;
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

std::string_view kind_of(const Source& source) {
  if (std::holds_alternative<PolyhedronSource>(source)) return "polyhedron";
  if (std::holds_alternative<MeshSource>(source)) return "mesh";
  return std::get<UnknownSource>(source).kind;
}

}  // namespace hariko

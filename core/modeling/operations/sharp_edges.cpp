#include "core/modeling/operations/sharp_edges.hpp"

#include <cmath>
#include <numbers>

#include "core/document/edits/edits.hpp"
#include "core/geometry/angles.hpp"
#include "core/geometry/polygon.hpp"

namespace hariko {

std::vector<EdgeId> folded_edges(const Polyhedron& polyhedron, double degrees) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  // Rounding of coordinates in a file must not decide edge by edge about an angle that equals the limit, as
  // in a body of twelve sides at 30 degrees.
  constexpr double tolerance = 0.01;  // degrees
  const double radians = (degrees + tolerance) * std::numbers::pi / 180;
  std::vector<Vector3> normals(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) normals[f] = newell_normal(polyhedron.corners(f));
  std::vector<EdgeId> out;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.is_border_edge(e)) continue;
    const Index h = mesh.half_edge_of_edge(e);
    const Vector3 &a = normals[mesh.face(h)], &b = normals[mesh.face(mesh.twin(h))];
    if (!(a.stableNorm() > 0) || !(b.stableNorm() > 0)) continue;
    const Vector3 u = a.stableNormalized(), v = b.stableNormalized();
    if (angle_between(u, v) > radians) out.push_back(polyhedron.edge_id(e));
  }
  return out;
}

Result<Document> with_creases(const Document& document, double degrees) {
  Result<Document> result = document;
  for (const auto& object : document.objects) {
    const PolyhedronSource* source = object->polyhedron();
    if (!source || !result) continue;
    const auto edges = folded_edges(source->polyhedron, degrees);
    if (!edges.empty()) result = set_crease(*result, object->id, edges, true);
  }
  return result;
}

Result<Document> as_reference(const Document& document) {
  Result<Document> result = document;
  for (const auto& object : document.objects) {
    const PolyhedronSource* source = object->polyhedron();
    if (!source || !result) continue;
    MeshSource facets;
    facets.origin = source->origin;
    facets.mesh = source->polyhedron.to_mesh();
    result = set_source(*result, object->id, std::move(facets));
  }
  return result;
}

}  // namespace hariko

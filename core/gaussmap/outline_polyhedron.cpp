#include "core/gaussmap/outline_polyhedron.hpp"

#include "core/gaussmap/fitted_tangents.hpp"
#include "core/gaussmap/rim_tangents.hpp"

namespace hariko {

Result<OutlinePolyhedron> outline_polyhedron(const ControlPoints& points, Frames frames) {
  const Vector3 origin = origin_for(points.points);
  PolygonMesh mesh;
  for (const Vector3& point : points.points) mesh.positions.push_back(point - origin);
  for (const auto& triangle : points.triangles) mesh.add_face(triangle);
  auto built = Polyhedron::build(mesh);
  if (!built) return built.error();
  OutlinePolyhedron out{*std::move(built), {}, origin};
  for (Index i = 0; i < points.points.size(); ++i) {
    out.shaping.pin.set(VertexId{i}, {Pin::Kind::normal, {points.normals[i]}});
    // Without the tag a border vertex with two edges would be a corner.
    if (i < points.boundary_count) out.shaping.tag.set(VertexId{i}, VertexTag::smooth);
  }
  if (frames == Frames::metric) {
    auto forms = rim_forms(out.polyhedron, out.shaping);
    if (!forms) return forms.error();
    out.shaping.form = *std::move(forms);
    return out;
  }
  const auto rims = rim_tangents(out.polyhedron, out.shaping);
  if (!rims) return rims.error();
  for (const auto& [vertex, pin] : *rims) out.shaping.pin.set(vertex, pin);
  const auto fitted = fitted_tangents(out.polyhedron, out.shaping, points.normals);
  if (!fitted) return fitted.error();
  out.shaping.pin = *fitted;
  return out;
}

}  // namespace hariko

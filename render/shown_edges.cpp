#include "render/shown_edges.hpp"

#include <algorithm>

namespace hariko {

namespace {

Vector3 vertex_place(const SceneObject& object, Index vertex) {
  return object.to_world(object.polyhedron->origin, object.polyhedron->positions[vertex]);
}

}  // namespace

std::optional<bool> runs_forward(const SceneObject& object, Index edge, const EdgeCurves::Run& run) {
  const auto segments = object.edge_curves->segments(run);
  const Vector3 begin = object.mesh_vertex(segments.front().vertices[1]);
  const Vector3 end = object.mesh_vertex(segments.back().vertices[2]);
  const Vector3 first = vertex_place(object, object.polyhedron->edges[edge][0]);
  const Vector3 last = vertex_place(object, object.polyhedron->edges[edge][1]);
  const double close = 1e-3 * ((last - first).norm() + (end - begin).norm());
  if ((begin - first).norm() <= close && (end - last).norm() <= close) return true;
  if ((begin - last).norm() <= close && (end - first).norm() <= close) return false;
  return std::nullopt;
}

std::vector<Vector3> shown_curve(const SceneObject& object, Index edge) {
  std::vector<Vector3> out;
  if (!object.curves_pickable()) return out;
  for (const EdgeCurves::Run& run : object.edge_curves->of(edge)) {
    const auto forward = runs_forward(object, edge, run);
    if (!forward) continue;
    const auto segments = object.edge_curves->segments(run);
    out.push_back(object.mesh_vertex(segments.front().vertices[1]));
    for (const CurveSegment& segment : segments) out.push_back(object.mesh_vertex(segment.vertices[2]));
    if (!*forward) std::reverse(out.begin(), out.end());
    break;
  }
  return out;
}

}  // namespace hariko

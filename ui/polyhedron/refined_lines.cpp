#include "ui/polyhedron/refined_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/modeling/cuts/knife_path.hpp"
#include "render/scene.hpp"

namespace hariko {

namespace {

/// Faces of a polyhedron whose surface is made in a tenth of a second.
constexpr Index most_faces_of_quick_forms = 2000;

Vector3 bezier_place(const std::array<Vector3, 4>& b, double t) {
  const double s = 1 - t;
  return s * s * s * b[0] + 3 * s * s * t * b[1] + 3 * s * t * t * b[2] + t * t * t * b[3];
}

std::vector<Index> faces_at(const Polyhedron& polyhedron, const CutPoint& point) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::vector<Index> out;
  if (const auto* on = std::get_if<EdgePoint>(&point)) {
    const Index h = mesh.half_edge_of_edge(polyhedron.find(on->edge));
    out.push_back(mesh.face(h));
    if (mesh.twin(h) != no_index) out.push_back(mesh.face(mesh.twin(h)));
    return out;
  }
  const Index first = mesh.outgoing(polyhedron.find(std::get<VertexId>(point)));
  for (Index h = first; h != no_index;) {
    out.push_back(mesh.face(h));
    h = mesh.rotate(h);
    if (h == first) break;
  }
  return out;
}

/// A vertex of a face as the end of a side.
EdgePoint as_edge_point(const Polyhedron& polyhedron, Index face, const CutPoint& point) {
  if (const auto* on = std::get_if<EdgePoint>(&point)) return *on;
  const VertexId vertex = std::get<VertexId>(point);
  const HalfEdgeMesh& mesh = polyhedron.topology();
  Index h = mesh.face_begin(face);
  while (polyhedron.vertex_id(mesh.origin(h)) != vertex) ++h;
  const EdgeId edge = polyhedron.edge_id(mesh.edge(h));
  return {edge, edge.low == vertex ? 0.0 : 1.0};
}

Index common_face(const Polyhedron& polyhedron, const CutPoint& a, const CutPoint& b) {
  const std::vector<Index> of_b = faces_at(polyhedron, b);
  for (const Index f : faces_at(polyhedron, a))
    if (std::find(of_b.begin(), of_b.end(), f) != of_b.end()) return f;
  return no_index;
}

}  // namespace

const SurfaceForm* RefinedLines::form_of(const Editor& editor, const Object& object) {
  if (!on_surface || !object.polyhedron()) return nullptr;
  if (formed_ != &object) {
    form_ = form_for_refinement(editor, *object.polyhedron());
    formed_ = &object;
  }
  return form_.pointer();
}

const SurfaceForm* RefinedLines::quick_form_of(const Editor& editor, const Object& object) {
  const PolyhedronSource* source = object.polyhedron();
  if (!source || source->polyhedron.face_count() > most_faces_of_quick_forms) return nullptr;
  return form_of(editor, object);
}

Vector3 RefinedLines::point(const Editor& editor, const Object& object, const CutPoint& point) {
  const PolyhedronSource& source = *object.polyhedron();
  Vector3 place = position_of(source.polyhedron, point);
  if (const auto* on = std::get_if<EdgePoint>(&point))
    if (const SurfaceForm* form = quick_form_of(editor, object))
      if (const auto curve = form->curve(on->edge)) place = bezier_place(*curve, on->share);
  return object.transform.apply(source.origin + place);
}

std::vector<Vector3> RefinedLines::line(const Editor& editor, const Object& object, const CutPoint& from,
                                        const CutPoint& to) {
  const PolyhedronSource& source = *object.polyhedron();
  std::vector<Vector3> out;
  const SurfaceForm* form = quick_form_of(editor, object);
  const Index face = form ? common_face(source.polyhedron, from, to) : no_index;
  if (face != no_index)
    out =
        form->path(as_edge_point(source.polyhedron, face, from), as_edge_point(source.polyhedron, face, to));
  for (Vector3& place : out) place = object.transform.apply(source.origin + place);
  if (out.empty()) out = {point(editor, object, from), point(editor, object, to)};
  return out;
}

double share_seen_between(const ToolContext& context, ObjectId object, const EdgePoint& share,
                          const Vector3& from, const Vector3& to) {
  const Scene& scene = context.scene.scene();
  std::size_t number = 0;
  while (number < scene.objects.size() && context.scene.object_id(number) != object) ++number;
  if (number == scene.objects.size() || !scene.objects[number].polyhedron) return share.share;
  const DisplayPolyhedron& lines = *scene.objects[number].polyhedron;
  Index edge = 0;
  while (edge < lines.edges.size() && lines.edge_id(edge) != share.edge) ++edge;
  if (edge == lines.edges.size()) return share.share;
  std::vector<Vector3> curve = shown_curve(scene.objects[number], edge);
  if (curve.size() < 2) return share.share;
  if (lines.vertex_ids[lines.edges[edge][0]] != share.edge.low) std::reverse(curve.begin(), curve.end());
  // The plane that looks like a line.
  const Camera camera = context.editor.camera();
  const Vector3 normal = camera.orthographic ? camera.forward().cross(to - from)
                                             : (from - camera.eye()).cross(to - camera.eye());
  double best = share.share, least = 2;
  const double step = 1.0 / static_cast<double>(curve.size() - 1);
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const double a = normal.dot(curve[i] - from), b = normal.dot(curve[i + 1] - from);
    if ((a > 0) == (b > 0)) continue;
    const double at = step * (double(i) + a / (a - b));
    if (std::abs(at - share.share) >= least) continue;
    least = std::abs(at - share.share);
    best = at;
  }
  return best;
}

}  // namespace hariko

// Places that can be caught, of every kind of object.

#include <algorithm>
#include <span>
#include <variant>

#include "core/geometry/polygon.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/view/snapping.hpp"

namespace hariko {

namespace {

constexpr int samples_of_span = 16;  ///< samples of subdivision curves

/// The middle of a curve as the surface has it, of which the mesh is a picture; in the object's space.
/// `parameters`: of the mesh's pattern.
Vector3 middle_of_curve(const Surface& surface, std::span<const Vector2> parameters,
                        std::span<const CurveSegment> segments) {
  const CurveSegment& middle = segments[segments.size() / 2];
  const auto per_patch = static_cast<Index>(parameters.size());
  const Vector2& begin = parameters[middle.vertices[1] % per_patch];
  const Vector2& end = parameters[middle.vertices[2] % per_patch];
  const Vector2 at = segments.size() % 2 == 0 ? begin : Vector2((begin + end) / 2);
  return surface.origin() +
         surface.patches().evaluate(middle.vertices[1] / per_patch, at, Order::first).position;
}

/// Whether something is looked for along curves.
bool need_curves(const SnapSettings& kinds) {
  return kinds.crossings || kinds.perpendicular || kinds.tangent || kinds.curves;
}

std::vector<Vector3> samples_of(const SubdivisionCurve& curve, const Similarity& transform) {
  std::vector<Vector3> out;
  const int count = samples_of_span * curve.spans();
  for (int i = 0; i < count + (curve.closed ? 0 : 1) && count > 0; ++i)
    out.push_back(transform.apply(evaluate(curve, double(i) / count).position));
  return out;
}

/// The point of an open curve half way along its length, by its samples.
Vector3 middle_by_length(const std::vector<Vector3>& samples) {
  double whole = 0, way = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) whole += (samples[i] - samples[i - 1]).norm();
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double length = (samples[i] - samples[i - 1]).norm();
    if (length > 0 && way + length >= whole / 2)
      return point_of({samples, false}, i - 1, (whole / 2 - way) / length);
    way += length;
  }
  return samples.front();
}

}  // namespace

SnapPlaces::SnapPlaces(const ToolContext& context, const SnapSettings& kinds) {
  const Document& document = context.editor.history.current();
  const Scene& scene = context.scene.scene();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object* object = document.find(context.scene.object_id(i));
    if (!object || !object->visible || scene.objects[i].copy) continue;
    add_object(context, i, *object, kinds);
  }
}

void SnapPlaces::add_object(const ToolContext& context, std::size_t scene_object, const Object& object,
                            const SnapSettings& kinds) {
  struct Adding {
    SnapPlaces& places;
    const ToolContext& context;
    std::size_t scene_object;
    const Object& object;
    const SnapSettings& kinds;
    void operator()(const PolyhedronSource&) const { places.add_cage(context, scene_object, object, kinds); }
    void operator()(const PatchSource&) const { places.add_cage(context, scene_object, object, kinds); }
    void operator()(const SolidsSource&) const { places.add_solids(context, scene_object, object, kinds); }
    void operator()(const SkinSource&) const { places.add_skin(object, kinds); }
    void operator()(const OutlineSource&) const { places.add_outline(object, kinds); }
    // Caught on their surfaces alone, or not at all.
    void operator()(const MeshSource&) const {}
    void operator()(const BezierSource&) const {}
    void operator()(const PictureSource&) const {}
    void operator()(const UnknownSource&) const {}
  };
  std::visit(Adding{*this, context, scene_object, object, kinds}, object.source);
}

SnapPlaces::Held SnapPlaces::hold(ObjectId object, std::initializer_list<VertexId> vertices) {
  const Held held{object, vertices_of_.size(), vertices.size()};
  vertices_of_.insert(vertices_of_.end(), vertices);
  return held;
}

SnapPlaces::Held SnapPlaces::hold(ObjectId object, const std::vector<VertexId>& vertices) {
  const Held held{object, vertices_of_.size(), vertices.size()};
  vertices_of_.insert(vertices_of_.end(), vertices.begin(), vertices.end());
  return held;
}

void SnapPlaces::add_curve(const Held& held, std::vector<Vector3> points, bool closed) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
  if (points.size() < 2) return;
  curves_.push_back({held, {std::move(points), closed}});
}

void SnapPlaces::add_cage(const ToolContext& context, std::size_t scene_object, const Object& object,
                          const SnapSettings& kinds) {
  const Polyhedron& cage = *object.cage();
  const auto place = [&](Index v) { return object.transform.apply(object.cage_origin() + cage.position(v)); };
  if (kinds.vertices)
    for (Index v = 0; v < cage.vertex_count(); ++v)
      vertices_.push_back({hold(object.id, {cage.vertex_id(v)}), place(v)});
  if (kinds.centres)
    for (Index f = 0; f < cage.face_count(); ++f) {
      std::vector<VertexId> ids;
      std::vector<Vector3> corners;
      for (const Index v : cage.topology().face_vertices(f))
        ids.push_back(cage.vertex_id(v)), corners.push_back(place(v));
      centres_.push_back({hold(object.id, ids), polygon_centre(corners)});
    }
  if (context.scene.scene().objects[scene_object].polyhedron && (kinds.midpoints || need_curves(kinds)))
    add_edges(context, scene_object, object, kinds);
}

void SnapPlaces::add_edges(const ToolContext& context, std::size_t scene_object, const Object& object,
                           const SnapSettings& kinds) {
  const SceneObject& shown = context.scene.scene().objects[scene_object];
  const SurfaceView* view = context.editor.view_of(object.id);
  const bool curves = shown.curves_pickable() && view && view->mesh == shown.mesh;
  const std::vector<Vector2> parameters =
      curves ? shown.mesh->pattern().parameters() : std::vector<Vector2>();
  const Polyhedron& cage = *object.cage();
  for (Index e = 0; e < shown.polyhedron->edges.size(); ++e) {
    const EdgeId id = shown.polyhedron->edge_id(e);
    const Index low = cage.find(id.low), high = cage.find(id.high);
    if (low == no_index || high == no_index) continue;
    const Held held = hold(object.id, {id.low, id.high});
    if (shown.line_pickable(e)) {
      const Vector3 a = object.cage_origin() + cage.position(low),
                    b = object.cage_origin() + cage.position(high);
      if (kinds.midpoints) middles_.push_back({held, object.transform.apply((a + b) / 2)});
      if (need_curves(kinds)) add_curve(held, {object.transform.apply(a), object.transform.apply(b)}, false);
    }
    if (!curves) continue;
    for (const EdgeCurves::Run& run : shown.edge_curves->of(e)) {
      const auto segments = shown.edge_curves->segments(run);
      if (kinds.midpoints)
        middles_.push_back(
            {held, object.transform.apply(middle_of_curve(view->surface, parameters, segments))});
      if (!need_curves(kinds)) continue;
      std::vector<Vector3> points{shown.mesh_vertex(segments.front().vertices[1])};
      for (const CurveSegment& segment : segments) points.push_back(shown.mesh_vertex(segment.vertices[2]));
      add_curve(held, std::move(points), false);
    }
  }
}

/// Solids have centres, and the lines that are drawn of them.
void SnapPlaces::add_solids(const ToolContext& context, std::size_t scene_object, const Object& object,
                            const SnapSettings& kinds) {
  if (kinds.centres)
    for (const Solid& solid : object.solids()->input->solids)
      centres_.push_back(
          {hold(object.id, {VertexId{solid.id}}), object.transform.apply(Vector3(solid.position))});
  const SceneObject& shown = context.scene.scene().objects[scene_object];
  if (!need_curves(kinds) || !shown.polyhedron || !shown.show_polyhedron) return;
  const DisplayPolyhedron& lines = *shown.polyhedron;
  for (const auto& [a, b] : lines.edges)
    add_curve(
        hold(object.id, {lines.vertex_ids[a], lines.vertex_ids[b]}),
        {shown.to_world(lines.origin, lines.positions[a]), shown.to_world(lines.origin, lines.positions[b])},
        false);
}

/// `ids`: of the points of the curve.
void SnapPlaces::add_drawn_curve(const Object& object, const SubdivisionCurve& curve,
                                 const std::vector<VertexId>& ids, const SnapSettings& kinds) {
  if (kinds.vertices)
    for (int i = 0; i < curve.size(); ++i)
      vertices_.push_back(
          {hold(object.id, {ids[std::size_t(i)]}), object.transform.apply(curve.points[std::size_t(i)])});
  if (curve.size() < 2 || (!kinds.midpoints && !kinds.centres && !need_curves(kinds))) return;
  const Held held = hold(object.id, ids);
  std::vector<Vector3> samples = samples_of(curve, object.transform);
  if (kinds.midpoints && !curve.closed) middles_.push_back({held, middle_by_length(samples)});
  if (kinds.centres && curve.closed) centres_.push_back({held, polygon_centre(samples)});
  if (need_curves(kinds)) add_curve(held, std::move(samples), curve.closed);
}

void SnapPlaces::add_skin(const Object& object, const SnapSettings& kinds) {
  const Skin& skin = *object.skin()->skin;
  for (const SkinSection& section : skin.sections) {
    std::vector<VertexId> ids;
    for (const SectionPoint& point : section.points) ids.push_back(VertexId{point.id});
    add_drawn_curve(object, section.curve(), ids, kinds);
  }
  const auto add_path = [&](const SubdivisionCurve& path, std::uint32_t first_id) {
    std::vector<VertexId> ids;
    for (int i = 0; i < path.size(); ++i) ids.push_back(VertexId{first_id + std::uint32_t(i)});
    add_drawn_curve(object, path, ids, kinds);
  };
  add_path(skin.path, path_point_ids);
  if (skin.second_rail) add_path(*skin.second_rail, rail_point_ids);
}

void SnapPlaces::add_outline(const Object& object, const SnapSettings& kinds) {
  std::uint32_t number = 0;
  for (const OutlineLoop& loop : object.outline()->outline->loops) {
    std::vector<VertexId> ids;
    std::vector<Vector3> points;
    for (const Vector3& point : loop.points) {
      ids.push_back(VertexId{number++});
      points.push_back(object.transform.apply(point));
      if (kinds.vertices) vertices_.push_back({hold(object.id, {ids.back()}), points.back()});
    }
    if (points.size() < 3) continue;
    const Held held = hold(object.id, ids);
    if (kinds.centres) centres_.push_back({held, polygon_centre(points)});
    if (need_curves(kinds)) add_curve(held, std::move(points), true);
  }
}

}  // namespace hariko

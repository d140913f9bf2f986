#include "ui/measure/measure_snap.hpp"

#include <vector>

#include "core/modeling/measuring/measured_dimension.hpp"
#include "core/modeling/measuring/surface_spot.hpp"
#include "ui/editor/dimension_view.hpp"
#include "ui/editor/reference_pictures.hpp"

namespace hariko {

namespace {

constexpr double measured_vertex_radius = 11, measured_edge_radius = 9;  // design pixels
constexpr double least_measured_share = 1e-3;  ///< nearer to an end the end is meant

const Object* object_of_hit(const ToolContext& context, std::size_t scene_object) {
  return context.editor.document().find(context.scene.object_id(scene_object));
}

/// An anchor with its place; nothing where it has none.
std::optional<MeasurePlace> held_by(const ToolContext& context, MeasurePlace::Kind kind, Anchor anchor) {
  const auto point = anchor_place(context.editor.document(), anchor, ready_surfaces(context.editor));
  if (!point) return std::nullopt;
  return MeasurePlace{kind, std::move(anchor), *point};
}

/// A point of an object's own space.
MeasurePlace held_by_object(MeasurePlace::Kind kind, const Object& object, const Vector3& world) {
  return {kind, ObjectAnchor{object.id, object.transform.inverse().apply(world), {}}, world};
}

/// A point of a solid, unless it belongs to the image of the solid in a plane of symmetry.
MeasurePlace held_by_solid(MeasurePlace::Kind kind, const Object& object, std::uint32_t id,
                           const Vector3& world) {
  const Vector3 local = object.transform.inverse().apply(world);
  for (const Solid& solid : object.solids()->input->solids) {
    if (solid.id != id) continue;
    const Eigen::AlignedBox3d box = box_of(solid);
    if (box.exteriorDistance(local) > 1e-3 * box.diagonal().norm()) break;
    const Vector3 own =
        (solid_rotation(solid.rotation).transpose() * (local - solid.position)).cwiseQuotient(solid.scale);
    return {kind, ObjectAnchor{object.id, own, id}, world};
  }
  return held_by_object(kind, object, world);
}

/// Kinds of objects whose surfaces have other patches after every edit.
bool patches_come_and_go(const Object& object) {
  return object.solids() || object.skin() || object.outline();
}

std::optional<MeasurePlace> on_surface(const ToolContext& context, const Ray& ray) {
  const auto hit = pick_surface(context.scene.scene(), ray);
  const Object* object = hit ? object_of_hit(context, hit->object) : nullptr;
  if (!object) return std::nullopt;
  const SurfaceView* view = context.editor.view_of(object->id);
  // Triangles may stand in the place of the surface. A point of a live copy keeps its place in the object's
  // space: elements are those at the own place.
  const SceneObject& shown = context.scene.scene().objects[hit->object];
  if (shown.copy || !view || view->mesh != shown.mesh || hit->patch >= view->surface.patch_count())
    return held_by_object(MeasurePlace::Kind::surface, *object, hit->point);
  const Surface& surface = view->surface;
  const SurfaceSpot spot{hit->patch, hit->parameter};
  const Vector3 local =
      surface.origin() + surface.patches().evaluate(spot.patch, spot.parameter, Order::first).position;
  if (patches_come_and_go(*object))
    return MeasurePlace{MeasurePlace::Kind::surface, NearestAnchor{object->id, local},
                        object->transform.apply(local)};
  return MeasurePlace{MeasurePlace::Kind::surface, patch_anchor(surface, object->id, spot),
                      object->transform.apply(local)};
}

std::optional<MeasurePlace> at_vertex_hit(const ToolContext& context, const PickHit& hit) {
  const Object* object = object_of_hit(context, hit.object);
  if (!object) return std::nullopt;
  const auto id = static_cast<std::uint32_t>(hit.element.id);
  constexpr auto kind = MeasurePlace::Kind::vertex;
  if (object->solids()) return held_by_solid(kind, *object, id, hit.point);
  if (object->cage() || object->mesh() || object->outline())
    return held_by(context, kind, VertexAnchor{object->id, VertexId{id}});
  return held_by_object(kind, *object, hit.point);
}

/// The point of the edge that is on the screen nearest to the pointer.
std::optional<MeasurePlace> at_edge_hit(const ToolContext& context, const PickHit& hit, bool middle) {
  const Object* object = object_of_hit(context, hit.object);
  if (!object) return std::nullopt;
  const auto kind = middle ? MeasurePlace::Kind::middle : MeasurePlace::Kind::edge;
  const DisplayPolyhedron& lines = *context.scene.scene().objects[hit.object].polyhedron;
  const VertexId first = lines.vertex_ids[lines.edges[hit.index][0]];
  if (object->solids()) return held_by_solid(kind, *object, first.value, hit.point);
  if (!object->cage()) return held_by_object(kind, *object, hit.point);
  if (!hit.share) {  // the image of an edge in a live mirror
    const auto pixel = context.projector().project(hit.point);
    const auto found = pixel ? on_surface(context, context.projector().ray(pixel->head<2>())) : std::nullopt;
    return found ? found : held_by_object(kind, *object, hit.point);
  }
  const EdgeId edge = EdgeId::from_packed(hit.element.id);
  const double share = middle ? 0.5 : first == edge.low ? *hit.share : 1 - *hit.share;
  if (!(share > least_measured_share))
    return held_by(context, MeasurePlace::Kind::vertex, VertexAnchor{object->id, edge.low});
  if (share > 1 - least_measured_share)
    return held_by(context, MeasurePlace::Kind::vertex, VertexAnchor{object->id, edge.high});
  const auto found = held_by(context, kind, EdgeAnchor{object->id, edge, share, !hit.on_curve});
  return found ? found : held_by_object(kind, *object, hit.point);
}

struct OtherVertex {
  VertexAnchor anchor;
  Vector3 place;  ///< in the document's space
};

/// Vertices that nothing of the scene stands for: images in live mirrors, points of sections.
std::vector<OtherVertex> other_vertices(const Editor& editor) {
  std::vector<OtherVertex> out;
  for (const auto& object : editor.document().objects) {
    if (!object->visible) continue;
    const auto add = [&](VertexId id, bool image, const Vector3& local) {
      out.push_back({{object->id, id, image}, object->transform.apply(local)});
    };
    if (const PolyhedronSource* source = object->polyhedron(); source && source->mirror)
      for (Index v = 0; v < source->polyhedron.vertex_count(); ++v) {
        Vector3 local = source->origin + source->polyhedron.position(v);
        local[index_of(source->mirror->axis)] *= -1;
        add(source->polyhedron.vertex_id(v), true, local);
      }
    if (const SkinSource* skin = object->skin(); skin && object->display.polyhedron)
      for (const SkinSection& section : skin->skin->sections)
        for (const SectionPoint& point : section.points) add(VertexId{point.id}, false, point.position);
  }
  return out;
}

bool can_be_seen(const ToolContext& context, const Vector3& point) {
  const Editor& editor = context.editor;
  if (editor.view.x_ray || editor.selecting.through) return true;
  const Projector projector = context.projector();
  const auto at = projector.project(point);
  if (!at) return false;
  const Ray ray = projector.ray(at->head<2>());
  const auto before = pick_surface(context.scene.scene(), ray);
  const double slack = hiding_slack_pixels * editor.pixel_scale * projector.pixel_length_at(point);
  return !before || before->t >= (point - ray.origin).norm() - slack;
}

std::optional<MeasurePlace> at_other_vertex(const ToolContext& context, const Vector2& pixel) {
  const Projector projector = context.projector();
  std::optional<MeasurePlace> best;
  double least = measured_vertex_radius * context.editor.pixel_scale;
  for (const OtherVertex& vertex : other_vertices(context.editor)) {
    const auto at = projector.project(vertex.place);
    const double distance = at ? (at->head<2>() - pixel).norm() : least;
    if (distance >= least || !can_be_seen(context, vertex.place)) continue;
    least = distance;
    best = MeasurePlace{MeasurePlace::Kind::vertex, vertex.anchor, vertex.place};
  }
  return best;
}

/// Vertices and edges as they are shown; nothing while only surfaces are looked at.
std::optional<MeasurePlace> at_element(const ToolContext& context, const Vector2& pixel, bool middles) {
  const Editor& editor = context.editor;
  if (editor.view.surfaces_only) return std::nullopt;
  PickOptions options;
  options.vertex_radius = measured_vertex_radius;
  options.edge_radius = measured_edge_radius;
  options.vertices = !middles;
  options.edges = options.faces = options.use_surface = false;
  options.visible_only = !editor.view.x_ray && !editor.selecting.through;
  const Scene& scene = context.scene.scene();
  if (!middles) {
    for (const PickHit& hit : pick_all(scene, context.projector(), pixel, options))
      if (auto place = at_vertex_hit(context, hit)) return place;
    if (auto place = at_other_vertex(context, pixel)) return place;
  }
  options.vertices = false;
  options.edges = true;
  for (const PickHit& hit : pick_all(scene, context.projector(), pixel, options))
    if (auto place = at_edge_hit(context, hit, middles)) return place;
  return std::nullopt;
}

/// A surface, the faces of an object that shows none, or a reference picture.
std::optional<MeasurePlace> on_object(const ToolContext& context, const Vector2& pixel) {
  const Projector projector = context.projector();
  const Scene& scene = context.scene.scene();
  const Ray ray = projector.ray(pixel);
  PickOptions faces;
  faces.vertices = faces.edges = false;
  const auto hits = pick_all(scene, projector, pixel, faces);
  if (!hits.empty()) {
    if (scene.objects[hits.front().object].draws_surface()) return on_surface(context, ray);
    if (const Object* object = object_of_hit(context, hits.front().object))
      return held_by_object(MeasurePlace::Kind::surface, *object, hits.front().point);
  }
  for (const ObjectId id : pictures_under(context.editor, projector, pixel)) {
    const Object* object = context.editor.document().find(id);
    ScenePicture picture;
    picture.transform = matrix_of(object->transform);
    picture.half = {object->picture()->width / 2, object->picture()->height() / 2};
    if (const auto t = picture.hit(ray))
      return held_by_object(MeasurePlace::Kind::surface, *object, ray.at(*t));
  }
  return std::nullopt;
}

/// Centres, intersections, feet and tangents; what else can be caught is found by its element.
std::optional<MeasurePlace> at_caught(const ToolContext& context, const MeasureAim& aim) {
  if (!aim.snaps) return std::nullopt;
  SnapSettings kinds = context.editor.settings.snaps;
  kinds.vertices = kinds.midpoints = kinds.curves = kinds.surfaces = kinds.grid = false;
  const SnapGesture gesture{kinds, aim.last, context.editor.working_plane.frame.normal(), nullptr};
  const auto target = aim.snaps->nearest(context, gesture, aim.pixel);
  const Object* object = target && target->object ? context.editor.document().find(*target->object) : nullptr;
  if (!object) return std::nullopt;
  MeasurePlace place = held_by_object(MeasurePlace::Kind::caught, *object, target->point);
  place.as = target->kind;
  return place;
}

Vector3 point_of_space(const ToolContext& context, const MeasureAim& aim) {
  const Projector projector = context.projector();
  const PlaneFrame& plane = context.editor.working_plane.frame;
  if (const auto point = point_on_plane(context, plane, projector.ray(aim.pixel), aim.middles)) return *point;
  return projector.on_facing_plane(aim.pixel, aim.last.value_or(projector.camera().target));
}

}  // namespace

std::optional<SnapTarget> target_of(const MeasurePlace& place) {
  switch (place.kind) {
    case MeasurePlace::Kind::vertex:
      return SnapTarget{SnapTarget::Kind::vertex, place.point};
    case MeasurePlace::Kind::middle:
      return SnapTarget{SnapTarget::Kind::midpoint, place.point};
    case MeasurePlace::Kind::edge:
      return SnapTarget{SnapTarget::Kind::curve, place.point};
    case MeasurePlace::Kind::surface:
      return SnapTarget{SnapTarget::Kind::surface, place.point};
    case MeasurePlace::Kind::caught:
      return SnapTarget{place.as, place.point};
    case MeasurePlace::Kind::space:
      break;
  }
  return std::nullopt;
}

MeasurePlace place_to_measure(const ToolContext& context, const MeasureAim& aim) {
  if (auto place = at_caught(context, aim)) return *std::move(place);
  if (auto place = at_element(context, aim.pixel, aim.middles)) return *std::move(place);
  if (auto place = on_object(context, aim.pixel)) return *std::move(place);
  const Vector3 point = point_of_space(context, aim);
  return {MeasurePlace::Kind::space, SpaceAnchor{point}, point};
}

std::optional<MeasurePlace> surface_to_measure(const ToolContext& context, const Vector2& pixel) {
  auto place = on_surface(context, context.projector().ray(pixel));
  const bool bent = place && (std::holds_alternative<PatchAnchor>(place->anchor) ||
                              std::holds_alternative<NearestAnchor>(place->anchor));
  return bent ? place : std::nullopt;
}

}  // namespace hariko

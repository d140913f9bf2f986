#include "core/modeling/measuring/measured_dimension.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/curvature.hpp"
#include "core/document/edits/edit_attachments.hpp"
#include "core/gaussmap/outlines/outline.hpp"
#include "core/geometry/angles.hpp"
#include "core/modeling/measuring/surface_curves.hpp"
#include "core/modeling/measuring/surface_spot.hpp"

namespace hariko {

namespace {

constexpr double flat_patch_sizes = 1e6;

/// Place of a vertex in the object's own space.
std::optional<Vector3> vertex_place(const Document& document, const Object& object,
                                    const VertexAnchor& anchor) {
  const std::uint32_t number = anchor.vertex.value;
  if (const Polyhedron* cage = object.cage()) {
    const Index v = cage->find(anchor.vertex);
    if (v == no_index) return std::nullopt;
    const PolyhedronSource* source = object.polyhedron();
    const bool attached = source && !source->attachments->empty();
    Vector3 place = object.cage_origin() +
                    (attached ? attached_polyhedron(document, object).position(v) : cage->position(v));
    if (!anchor.image) return place;
    if (!source || !source->mirror) return std::nullopt;
    place[index_of(source->mirror->axis)] *= -1;
    return place;
  }
  if (const MeshSource* mesh = object.mesh()) {
    if (number >= mesh->mesh->positions.size()) return std::nullopt;
    return Vector3(mesh->origin + mesh->mesh->positions[number]);
  }
  if (const OutlineSource* outline = object.outline()) {
    if (number >= outline->outline->point_count()) return std::nullopt;
    const OutlinePoint at = outline_point(*outline->outline, number);
    return outline->outline->loops[at.loop].points[at.place];
  }
  if (const SkinSource* skin = object.skin())
    for (const SkinSection& section : skin->skin->sections)
      for (const SectionPoint& point : section.points)
        if (point.id == number) return point.position;
  if (const SolidsSource* solids = object.solids())
    for (const Solid& solid : solids->input->solids)
      if (solid.id == number) return solid.position;
  return std::nullopt;
}

std::optional<Vector3> object_point(const Object& object, const ObjectAnchor& anchor) {
  if (!anchor.solid) return anchor.point;
  if (const SolidsSource* solids = object.solids())
    for (const Solid& solid : solids->input->solids)
      if (solid.id == *anchor.solid)
        return Vector3(solid.position +
                       solid_rotation(solid.rotation) * solid.scale.cwiseProduct(anchor.point));
  return std::nullopt;
}

/// The curve over an edge with the fraction of it at a share: of several curves (a live mirror has that of
/// the image, too) the one that ends nearest to the vertices.
std::optional<SurfaceSpot> spot_on_curve(const Surface& surface, const EdgeAnchor& anchor, const Vector3& low,
                                         const Vector3& high) {
  std::optional<SurfaceSpot> best;
  double least = std::numeric_limits<double>::infinity();
  for (const SideCurve& curve : curves_over(surface, anchor.edge)) {
    const Vector3 begin = surface.origin() + curve_point(surface, curve, 0),
                  end = surface.origin() + curve_point(surface, curve, 1);
    const double forward = (begin - low).norm() + (end - high).norm(),
                 backward = (begin - high).norm() + (end - low).norm();
    if (!(std::min(forward, backward) < least)) continue;
    least = std::min(forward, backward);
    const double share = forward <= backward ? anchor.share : 1 - anchor.share;
    best = SurfaceSpot{curve.side.patch, curve_parameter(surface, curve, share)};
  }
  return best;
}

Vector3 place_on(const Surface& surface, const SurfaceSpot& spot) {
  return surface.origin() + surface.patches().evaluate(spot.patch, spot.parameter, Order::first).position;
}

std::optional<Vector3> edge_place(const Document& document, const Object& object, const EdgeAnchor& anchor,
                                  const SurfaceOf& surface_of) {
  const auto low = vertex_place(document, object, {object.id, anchor.edge.low}),
             high = vertex_place(document, object, {object.id, anchor.edge.high});
  if (!low || !high || object.cage()->find(anchor.edge) == no_index) return std::nullopt;
  if (anchor.straight) return Vector3(*low + anchor.share * (*high - *low));
  const Surface* surface = surface_of(object.id);
  if (!surface || surface->patch_count() == 0) return std::nullopt;
  const auto spot = spot_on_curve(*surface, anchor, *low, *high);
  return spot ? std::optional<Vector3>(place_on(*surface, *spot)) : std::nullopt;
}

/// Point of a surface that an anchor names.
std::optional<SurfaceSpot> surface_spot(const Anchor& anchor, const Surface* surface) {
  if (!surface || surface->patch_count() == 0) return std::nullopt;
  if (const auto* patch = std::get_if<PatchAnchor>(&anchor)) return spot_of(*surface, *patch);
  if (const auto* nearest = std::get_if<NearestAnchor>(&anchor))
    return nearest_spot(*surface, nearest->point - surface->origin());
  return std::nullopt;
}

/// Place of an anchor in the object's own space.
std::optional<Vector3> place_in_object(const Document& document, const Object& object, const Anchor& anchor,
                                       const SurfaceOf& surface_of) {
  if (const auto* point = std::get_if<ObjectAnchor>(&anchor)) return object_point(object, *point);
  if (const auto* vertex = std::get_if<VertexAnchor>(&anchor)) return vertex_place(document, object, *vertex);
  if (const auto* edge = std::get_if<EdgeAnchor>(&anchor))
    return object.cage() ? edge_place(document, object, *edge, surface_of) : std::nullopt;
  const Surface* surface = surface_of(object.id);
  const auto spot = surface_spot(anchor, surface);
  return spot ? std::optional<Vector3>(place_on(*surface, *spot)) : std::nullopt;
}

/// Principal radii at the anchor, in the document's unit.
bool add_radii(const Document& document, const Anchor& anchor, const SurfaceOf& surface_of,
               MeasuredDimension& out) {
  const Object* object = document.find(*object_of(anchor));
  const Surface* surface = object ? surface_of(object->id) : nullptr;
  const auto spot = surface_spot(anchor, surface);
  if (!spot) return false;
  const auto bent = curvature(surface->patches().evaluate(spot->patch, spot->parameter, Order::second));
  if (!bent) return false;
  const double flat = 1 / (flat_patch_sizes *
                           std::max(surface->patch_scale(spot->patch), std::numeric_limits<double>::min()));
  const auto radius = [&](double k) {
    return std::abs(k) <= flat ? std::numeric_limits<double>::infinity() : object->transform.scale / k;
  };
  out.first_radius = radius(bent->k1);
  out.second_radius = radius(bent->k2);
  if (std::abs(bent->k2) > std::abs(bent->k1)) std::swap(out.first_radius, out.second_radius);
  out.value = std::abs(out.first_radius);
  out.normal = object->transform.rotation * bent->normal;
  return true;
}

}  // namespace

std::optional<Vector3> anchor_place(const Document& document, const Anchor& anchor,
                                    const SurfaceOf& surface_of) {
  if (const auto* space = std::get_if<SpaceAnchor>(&anchor)) return space->point;
  const Object* object = document.find(*object_of(anchor));
  if (!object) return std::nullopt;
  const auto place = place_in_object(document, *object, anchor, surface_of);
  return place ? std::optional<Vector3>(object->transform.apply(*place)) : std::nullopt;
}

std::optional<MeasuredDimension> measured(const Document& document, const Dimension& dimension,
                                          const SurfaceOf& surface_of) {
  MeasuredDimension out;
  for (const Anchor& anchor : dimension.anchors) {
    const auto place = anchor_place(document, anchor, surface_of);
    if (!place) return std::nullopt;
    out.points.push_back(*place);
  }
  HARIKO_ASSERT(out.points.size() == anchor_count(dimension.kind), "a dimension has its number of anchors");
  switch (dimension.kind) {
    case DimensionKind::distance:
      out.value = (out.points[1] - out.points[0]).norm();
      break;
    case DimensionKind::angle: {
      const Vector3 a = out.points[0] - out.points[1], b = out.points[2] - out.points[1];
      if (a.isZero(0) || b.isZero(0)) return std::nullopt;
      out.value = angle_between(a, b);
      break;
    }
    case DimensionKind::radius:
      if (!add_radii(document, dimension.anchors.front(), surface_of, out)) return std::nullopt;
      break;
  }
  return out;
}

}  // namespace hariko

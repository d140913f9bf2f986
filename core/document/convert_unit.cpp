#include "core/document/convert_unit.hpp"

#include <algorithm>
#include <numeric>

#include "core/polyhedron/validation.hpp"

namespace hariko {

namespace {

Result<Done> scale_positions(Polyhedron& polyhedron, double factor) {
  std::vector<Vector3> positions = polyhedron.positions();
  std::vector<Index> indices(positions.size());
  std::iota(indices.begin(), indices.end(), Index{0});
  for (Vector3& position : positions) position *= factor;
  auto scaled = polyhedron.with_positions(indices, positions);
  if (!scaled.ok()) return scaled.error();
  polyhedron = std::move(scaled).value();
  return Done{};
}

/// Scales the frozen sides, which lie in the object's space.
void scale_attachments(PolyhedronSource& source, double factor) {
  Attachments scaled = *source.attachments;
  for (const auto& [edge, attachment] : *source.attachments) {
    if (!attachment.frozen) continue;
    Attachment changed = attachment;
    for (auto* rows : {&changed.frozen->curve, &changed.frozen->row})
      for (Vector3& point : *rows) point *= factor;
    scaled.set(edge, changed);
  }
  if (!(scaled == *source.attachments)) source.attachments = std::move(scaled);
}

Result<Done> scale_polyhedron(PolyhedronSource& source, double factor) {
  if (const auto scaled = scale_positions(source.polyhedron, factor); !scaled) return scaled.error();
  source.origin *= factor;
  scale_attachments(source, factor);
  if (source.mirror) source.mirror->weld_distance *= factor;
  if (source.shaping->pin.empty()) return Done{};
  Shaping shaping = *source.shaping;
  FlatMap<VertexId, Pin> pins;
  for (const auto& [id, pin] : shaping.pin) {
    Pin scaled_pin = pin;
    if (pin.kind == Pin::Kind::tangents)
      for (Vector3& vector : scaled_pin.vectors) vector *= factor;
    pins.set(id, std::move(scaled_pin));
  }
  shaping.pin = std::move(pins);
  source.shaping = std::move(shaping);
  return Done{};
}

void scale_mesh(MeshSource& source, double factor) {
  PolygonMesh mesh = *source.mesh;
  for (Vector3& position : mesh.positions) position *= factor;
  source.mesh = std::move(mesh);
  source.origin *= factor;
}

Result<Done> scale_patches(BezierSource& source, double factor) {
  std::vector<BezierPatch> patches = *source.patches;
  for (BezierPatch& patch : patches)
    for (Vector3& point : patch.points) point *= factor;
  auto scaled = BezierSource::from_patches(factor * source.origin, std::move(patches));
  if (!scaled.ok()) return scaled.error();
  BezierSource result = std::move(scaled).value();
  result.kept = source.kept;
  source = std::move(result);
  return Done{};
}

void scale_solids(SolidsSource& source, double factor) {
  EnvelopeInput input = *source.input;
  for (Solid& solid : input.solids) {
    for (double* length : {&solid.radius, &solid.height, &solid.length, &solid.tube}) *length *= factor;
    solid.size *= factor;
    solid.position *= factor;
    for (Vector3& point : solid.points) point *= factor;
    if (solid.bridge && solid.bridge->ball_radius) *solid.bridge->ball_radius *= factor;
  }
  input.settings.clearance *= factor;
  input.settings.rounding *= factor;
  if (input.settings.ball_radius) *input.settings.ball_radius *= factor;
  source.input = std::move(input);
}

void scale_skin(SkinSource& source, double factor) {
  Skin skin = *source.skin;
  change_positions(skin, [&](Vector3& position) { position *= factor; });
  if (skin.mirror) skin.mirror->position *= factor;
  source.skin = std::move(skin);
}

void scale_outline(OutlineSource& source, double factor) {
  Outline outline = *source.outline;
  for (OutlineLoop& loop : outline.loops) {
    for (Vector3& point : loop.points) point *= factor;
    for (double& curvature : loop.curvature) curvature /= factor * factor;
  }
  source.outline = std::move(outline);
  if (source.settings.gap) *source.settings.gap *= factor;
}

/// Scales the points that are numbers; what names an element follows it.
Dimensions scaled_dimensions(Dimensions dimensions, double factor) {
  for (Dimension& dimension : dimensions) {
    dimension.label *= factor;
    for (Anchor& anchor : dimension.anchors) {
      if (auto* space = std::get_if<SpaceAnchor>(&anchor)) space->point *= factor;
      if (auto* placed = std::get_if<ObjectAnchor>(&anchor)) placed->point *= factor;
      if (auto* nearest = std::get_if<NearestAnchor>(&anchor)) nearest->point *= factor;
    }
  }
  return dimensions;
}

}  // namespace

Result<Document> convert_unit(const Document& document, Unit unit) {
  if (unit == document.unit) return document;
  const double factor = millimetres_per(document.unit) / millimetres_per(unit);
  Document result = document;
  result.unit = unit;
  if (document.paper) {
    PaperModel paper = *document.paper;
    paper.distance *= factor;
    paper.settings.scale /= factor;
    result.paper = std::make_shared<const PaperModel>(std::move(paper));
  }
  if (!document.dimensions->empty()) {
    result.dimensions = scaled_dimensions(*document.dimensions, factor);
    if (!std::all_of(result.dimensions->begin(), result.dimensions->end(), is_sound))
      return make_error(e_nonfinite, "A dimension would lie infinitely far away.", "Choose another unit.");
  }
  for (auto& shared : result.objects) {
    Object object = *shared;
    object.transform.translation *= factor;
    if (auto* polyhedron = std::get_if<PolyhedronSource>(&object.source)) {
      if (const auto scaled = scale_polyhedron(*polyhedron, factor); !scaled.ok()) return scaled.error();
    } else if (auto* mesh = std::get_if<MeshSource>(&object.source)) {
      scale_mesh(*mesh, factor);
    } else if (auto* patches = std::get_if<PatchSource>(&object.source)) {
      if (const auto scaled = scale_positions(patches->net, factor); !scaled.ok()) return scaled.error();
      patches->origin *= factor;
    } else if (auto* bezier = std::get_if<BezierSource>(&object.source)) {
      if (const auto scaled = scale_patches(*bezier, factor); !scaled.ok()) return scaled.error();
    } else if (auto* solids = std::get_if<SolidsSource>(&object.source)) {
      scale_solids(*solids, factor);
      if (const auto checked = check_envelope(*solids->input); !checked.ok()) return checked.error();
    } else if (auto* skin = std::get_if<SkinSource>(&object.source)) {
      scale_skin(*skin, factor);
    } else if (auto* outline = std::get_if<OutlineSource>(&object.source)) {
      scale_outline(*outline, factor);
    } else if (auto* picture = std::get_if<PictureSource>(&object.source)) {
      picture->width *= factor;
      if (const auto checked = check_picture(*picture); !checked) return checked.error();
    }
    if (!object.transform.translation.allFinite())
      return make_error(e_nonfinite, "An object would lie infinitely far away.", "Choose another unit.");
    shared = std::make_shared<const Object>(std::move(object));
  }
  return result;
}

}  // namespace hariko

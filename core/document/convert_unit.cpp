#include "core/document/convert_unit.hpp"

#include <algorithm>
#include <variant>

#include "core/base/index_list.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

namespace {

/// Multiplication of all lengths of a source. Errors: those of the checks of the kind.
struct Scale {
  double factor;

  Result<Done> operator()(PolyhedronSource& source) const {
    if (const auto scaled = positions(source.polyhedron); !scaled) return scaled.error();
    source.origin *= factor;
    attachments(source);
    if (source.mirror) source.mirror->weld_distance *= factor;
    if (source.shaping->pin.empty()) return Done{};
    Shaping shaping = *source.shaping;
    FlatMap<VertexId, Pin> pins;
    for (const auto& [id, pin] : shaping.pin) {
      Pin scaled_pin = pin;
      if (pin.kind == Pin::Kind::tangents) points(scaled_pin.vectors);
      pins.set(id, std::move(scaled_pin));
    }
    shaping.pin = std::move(pins);
    source.shaping = std::move(shaping);
    return Done{};
  }
  Result<Done> operator()(MeshSource& source) const {
    PolygonMesh mesh = *source.mesh;
    points(mesh.positions);
    source.mesh = std::move(mesh);
    source.origin *= factor;
    return Done{};
  }
  Result<Done> operator()(PatchSource& source) const {
    source.origin *= factor;
    return positions(source.net);
  }
  Result<Done> operator()(BezierSource& source) const {
    std::vector<BezierPatch> patches = *source.patches;
    for (BezierPatch& patch : patches) points(patch.points);
    auto scaled = BezierSource::from_patches(factor * source.origin, std::move(patches));
    if (!scaled.ok()) return scaled.error();
    scaled.value().kept = source.kept;
    source = std::move(scaled).value();
    return Done{};
  }
  Result<Done> operator()(SolidsSource& source) const {
    EnvelopeInput input = *source.input;
    for (Solid& solid : input.solids) {
      for (double* length : {&solid.radius, &solid.height, &solid.length, &solid.tube}) *length *= factor;
      solid.size *= factor;
      solid.position *= factor;
      points(solid.points);
      for (Pull& pull : solid.pulls) pull.place *= factor, pull.radius *= factor;
      if (solid.bridge && solid.bridge->ball_radius) *solid.bridge->ball_radius *= factor;
    }
    input.settings.clearance *= factor;
    input.settings.rounding *= factor;
    if (input.settings.ball_radius) *input.settings.ball_radius *= factor;
    source.input = std::move(input);
    return check_envelope(*source.input);
  }
  Result<Done> operator()(SkinSource& source) const {
    Skin skin = *source.skin;
    change_positions(skin, [this](Vector3& position) { position *= factor; });
    if (skin.mirror) skin.mirror->position *= factor;
    source.skin = std::move(skin);
    return Done{};
  }
  Result<Done> operator()(OutlineSource& source) const {
    Outline outline = *source.outline;
    for (OutlineLoop& loop : outline.loops) {
      points(loop.points);
      for (double& curvature : loop.curvature) curvature /= factor * factor;
    }
    source.outline = std::move(outline);
    if (source.settings.gap) *source.settings.gap *= factor;
    return Done{};
  }
  Result<Done> operator()(PictureSource& source) const {
    source.width *= factor;
    return check_picture(source);
  }
  Result<Done> operator()(UnknownSource&) const { return Done{}; }

 private:
  template <class Points>
  void points(Points& all) const {
    for (Vector3& point : all) point *= factor;
  }
  Result<Done> positions(Polyhedron& polyhedron) const {
    std::vector<Vector3> all = polyhedron.positions();
    points(all);
    auto scaled = polyhedron.with_positions(ascending_indices(all.size()), all);
    if (!scaled.ok()) return scaled.error();
    polyhedron = std::move(scaled).value();
    return Done{};
  }
  /// Scales the frozen sides, which lie in the object's space.
  void attachments(PolyhedronSource& source) const {
    Attachments scaled = *source.attachments;
    for (const auto& [edge, attachment] : *source.attachments) {
      if (!attachment.frozen) continue;
      Attachment changed = attachment;
      points(changed.frozen->curve);
      points(changed.frozen->row);
      scaled.set(edge, changed);
    }
    if (!(scaled == *source.attachments)) source.attachments = std::move(scaled);
  }
};

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
  if (!document.saved_views->empty()) {
    SavedViews views = *document.saved_views;
    for (SavedView& view : views) {
      view.target *= factor;
      view.distance *= factor;
      if (const auto checked = check_view(view); !checked) return checked.error();
    }
    result.saved_views = std::move(views);
  }
  for (auto& shared : result.objects) {
    Object object = *shared;
    object.transform.translation *= factor;
    if (const auto scaled = std::visit(Scale{factor}, object.source); !scaled) return scaled.error();
    if (!object.copies->empty()) {
      object.copies = mapped(*object.copies, factor * Matrix3::Identity());
      if (const auto checked = check_copies(*object.copies); !checked) return checked.error();
    }
    if (!object.transform.translation.allFinite())
      return make_error(e_nonfinite, "An object would lie infinitely far away.", "Choose another unit.");
    shared = std::make_shared<const Object>(std::move(object));
  }
  return result;
}

}  // namespace hariko

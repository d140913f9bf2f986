#include "core/document/format/format_names.hpp"
#include "core/document/format/write_source.hpp"

namespace hariko::detail {

namespace {

void write_bridge(DocumentText& out, const Bridge& bridge) {
  out.raw(", \"bridge\": {\"between\": [");
  out.number(bridge.between[0]);
  out.raw(", ");
  out.number(bridge.between[1]);
  out.raw("]");
  if (bridge.ball_radius) {
    out.raw(", \"ball_radius\": ");
    out.number(*bridge.ball_radius);
  }
  out.raw("}");
}

void write_solid(DocumentText& out, const Solid& solid) {
  const auto number = [&](std::string_view name, double value) {
    out.raw(", \"");
    out.raw(name);
    out.raw("\": ");
    out.number(value);
  };
  const auto vector = [&](std::string_view name, const Vector3& value, const Vector3& usual) {
    if (value == usual) return;
    out.raw(", \"");
    out.raw(name);
    out.raw("\": ");
    out.vector(value);
  };
  // Sizes without meaning for the kind are left out unless they were changed.
  const Solid usual;
  const SolidKind kind = solid.kind;
  out.raw("{\"type\": ");
  out.string(name_of(kind));
  out.raw(", \"id\": ");
  out.number(solid.id);
  if (kind == SolidKind::box || solid.size != usual.size) {
    out.raw(", \"size\": ");
    out.vector(solid.size);
  }
  const auto tall = [](SolidKind k) {
    return k == SolidKind::cylinder || k == SolidKind::cone || k == SolidKind::prism ||
           k == SolidKind::pyramid;
  };
  if ((kind != SolidKind::box && kind != SolidKind::polyhedron) || solid.radius != usual.radius)
    number("radius", solid.radius);
  if (tall(kind) || solid.height != usual.height) number("height", solid.height);
  if (kind == SolidKind::capsule || solid.length != usual.length) number("length", solid.length);
  if (kind == SolidKind::torus || solid.tube != usual.tube) number("tube", solid.tube);
  if (kind == SolidKind::prism || kind == SolidKind::pyramid || solid.sides != usual.sides) {
    out.raw(", \"sides\": ");
    out.number(solid.sides);
  }
  vector("position", solid.position, usual.position);
  vector("rotation", solid.rotation, usual.rotation);
  vector("scale", solid.scale, usual.scale);
  if (solid.roundness) number("roundness", *solid.roundness);
  if (solid.bridge) write_bridge(out, *solid.bridge);
  if (!solid.points.empty()) {
    out.raw(", \"vertices\": ");
    out.vectors(solid.points);
  }
  out.raw("}");
}

}  // namespace

void write_source(DocumentText& out, const SolidsSource& source) {
  const EnvelopeSettings& settings = source.input->settings;
  out.open('{');
  out.key("kind");
  out.string("solids");
  out.list("primitives", source.input->solids, [&](const Solid& solid) { write_solid(out, solid); });
  const auto number = [&](std::string_view name, double value) {
    out.key(name);
    out.number(value);
  };
  number("roundness", settings.roundness);
  number("clearance", settings.clearance);
  number("rounding", settings.rounding);
  out.key("ball_radius");
  if (settings.ball_radius)
    out.number(*settings.ball_radius);
  else
    out.string("hull");
  out.key("method");
  out.string(settings.method == EnvelopeMethod::ball ? "ball" : "network");
  out.key("symmetry");
  out.string(symmetry_names[std::size_t(settings.symmetry)]);
  const auto chosen = [&](std::string_view name, bool value) {
    if (!value) return;
    out.key(name);
    out.boolean(value);
  };
  chosen("on_faces", settings.on_faces);
  chosen("finer_patches", settings.finer_patches);
  out.kept(*source.kept);
  out.close('}');
}

}  // namespace hariko::detail

#include "app/commands/evaluation.hpp"

#include "core/base/text/json_writer.hpp"
#include "core/envelope/envelope.hpp"
#include "core/envelope/scene_symmetry.hpp"

namespace hariko {

namespace {

/// Control point (w x, w y, w z, w) relative to the document's origin.
std::array<double, 4> about_origin(const Homogeneous& h, const Vector3& origin) {
  return {h.x() + h.w() * origin.x(), h.y() + h.w() * origin.y(), h.z() + h.w() * origin.z(), h.w()};
}

/// Number of a network's solid as in the file: capsules become two solids of one number, mirror images have
/// none.
auto owner(Index solid, const CurveNetwork& network, const EnvelopedScene& scene) {
  return solid == no_index ? std::nullopt : std::optional(scene.image_of[network.owners[solid]]);
}

void write_network(JsonWriter& json, const CurveNetwork& network, const EnvelopeSurface& made,
                   const EnvelopedScene& scene) {
  json.list("vertices", network.cage.vertices, [&](const CageVertex& v) {
    json.object([&] {
      json.member("position", Vector3(v.position + made.origin));
      json.member("normal", v.normal);
      json.member("owner", owner(v.solid, network, scene));
    });
  });
  json.list("edges", network.curves, [&](const NetworkCurve& curve) {
    json.object([&] {
      json.member("ends", {curve.low, curve.high});
      json.member("primitive", curve.primitive);
      json.list("control", curve.ribbon.curve,
                [&](const Homogeneous& h) { json.value(about_origin(h, made.origin)); });
    });
  });
  json.list("faces", network.cage.faces, [&](const CageFace& face) {
    json.object([&] {
      json.member("loop", face.loop);
      json.member("owner", owner(face.solid, network, scene));
    });
  });
  json.member("patches", network.patches.size());
}

}  // namespace

Result<std::string> solids_json(const SolidsSource& source) {
  const auto made = EnvelopeSurfacer().rebuild(*source.input);
  if (!made.ok()) return made.error();
  JsonWriter json(1);
  json.object([&] {
    if (made->network)
      write_network(json, *made->network, *made, enveloped_scene(*source.input));
    else
      json.member("patches", made->surface.patch_count());
    json.member("method", made->network ? "network" : "ball");
    if (source.input->settings.symmetry != SymmetryPlane::none) json.member("symmetric", made->symmetric);
    json.member("enclosed", made->enclosed);
    if (made->sticks_out) json.member("sticks_out", *made->sticks_out);
    if (made->check) json.member("worst_violation", made->check->worst / made->diagonal);
    json.member("folds", made->folds);
    if (made->check) json.member("crossing", made->check->covered);
  });
  return json.take() + "\n";
}

}  // namespace hariko

#include "app/commands/solids_evaluation.hpp"

#include <nlohmann/json.hpp>

#include "app/commands/vector_json.hpp"
#include "core/envelope/envelope.hpp"
#include "core/envelope/scene_symmetry.hpp"

namespace hariko {

namespace {

using Json = nlohmann::ordered_json;

/// (w x, w y, w z, w) of a control point, about the document's origin.
Json to_json(const Homogeneous& h, const Vector3& origin) {
  return Json::array(
      {h.x() + h.w() * origin.x(), h.y() + h.w() * origin.y(), h.z() + h.w() * origin.z(), h.w()});
}

/// The number of a placed solid, as the file has it: capsules make two of one, and images none.
Json owner(Index solid, const EnvelopedScene& scene) {
  return solid == no_index ? Json(nullptr) : Json(scene.image_of[scene.placed[solid].owner]);
}

void add_network(const CurveNetwork& network, const EnvelopeSurface& made, const EnvelopedScene& scene,
                 Json& out) {
  Json vertices = Json::array(), edges = Json::array(), faces = Json::array();
  for (const CageVertex& v : network.cage.vertices)
    vertices.push_back({{"position", vector_json(Vector3(v.position + made.origin))},
                        {"normal", vector_json(v.normal)},
                        {"owner", owner(v.solid, scene)}});
  for (const NetworkCurve& curve : network.curves) {
    Json control = Json::array();
    for (const Homogeneous& h : curve.ribbon.curve) control.push_back(to_json(h, made.origin));
    edges.push_back(
        {{"ends", {curve.low, curve.high}}, {"primitive", curve.primitive}, {"control", control}});
  }
  for (const CageFace& face : network.cage.faces)
    faces.push_back({{"loop", face.loop}, {"owner", owner(face.solid, scene)}});
  out["vertices"] = vertices;
  out["edges"] = edges;
  out["faces"] = faces;
  out["patches"] = network.patches.size();
}

}  // namespace

Result<std::string> solids_json(const SolidsSource& source) {
  const auto made = EnvelopeSurfacer().rebuild(*source.input);
  if (!made.ok()) return made.error();
  Json out = Json::object();
  if (made->network)
    add_network(*made->network, *made, enveloped_scene(*source.input), out);
  else
    out["patches"] = made->surface.patch_count();
  out["method"] = made->network ? "network" : "field";
  if (source.input->settings.symmetry != SymmetryPlane::none) out["symmetric"] = made->symmetric;
  out["level"] = made->level;
  out["enclosed"] = made->enclosed;
  out["worst_violation"] = made->check ? made->check->worst / made->diagonal : made->worst / made->diagonal;
  out["folds"] = made->folds;
  if (made->check) out["crossing"] = made->check->covered;
  out["builds"] = made->builds;
  return out.dump(1) + "\n";
}

}  // namespace hariko

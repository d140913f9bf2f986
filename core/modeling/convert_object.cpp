#include "core/modeling/convert_object.hpp"

#include <algorithm>
#include <cmath>

#include "core/document/edit_elements.hpp"
#include "core/document/edit_support.hpp"
#include "core/envelope/envelope.hpp"
#include "core/gaussmap/control_points.hpp"
#include "core/gaussmap/outline_polyhedron.hpp"

namespace hariko {
namespace {

Result<PolyhedronSource> converted(const OutlineSource& source, const CancelToken& cancel) {
  const auto points = control_points(*source.outline, gauss_options(source.settings), cancel);
  if (!points) return points.error();
  auto made = outline_polyhedron(*points);
  if (!made) return made.error();
  const Mode mode = source.settings.curvature_continuous ? Mode::g2 : Mode::fair;
  return PolyhedronSource{made->origin, made->polyhedron, made->shaping, mode, {}};
}

/// Tensions of edges by their lengths: short edges are tense, so that uneven cages do not fold.
Shaping length_tensions(const Polyhedron& cage) {
  constexpr double exponent = 0.7, least = 0.2, most = 5;
  const HalfEdgeMesh& mesh = cage.topology();
  std::vector<double> length;
  double mean = 0;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    length.push_back((cage.position(mesh.origin(h)) - cage.position(mesh.target(h))).norm());
    mean += length.back() / double(mesh.edge_count());
  }
  Shaping out;
  std::vector<std::pair<EdgeId, double>> betas;
  for (Index e = 0; e < mesh.edge_count(); ++e)
    betas.emplace_back(cage.edge_id(e),
                       std::clamp(std::pow(mean / std::max(length[e], 1e-9 * mean), exponent), least, most));
  std::ranges::sort(betas);
  for (const auto& [edge, beta] : betas) out.beta.set(edge, beta);
  return out;
}

Result<PolyhedronSource> converted(const SolidsSource& source, const CancelToken& cancel) {
  const auto made = EnvelopeSurfacer().rebuild(*source.input, Quality::final, cancel);
  if (!made) return made.error();
  PolygonMesh mesh;
  std::vector<Vector3> normals;
  if (made->network) {
    for (const CageVertex& vertex : made->network->cage.vertices) {
      mesh.positions.push_back(vertex.position);
      normals.push_back(vertex.normal);
    }
    for (const CageFace& face : made->network->cage.faces) mesh.add_face(face.loop);
  } else {
    mesh.positions = made->cage->positions;
    for (Index v = 0; v < mesh.positions.size(); ++v) normals.push_back(made->surface.node_normal(v));
    for (const auto& quad : made->cage->quads) mesh.add_face(quad);
  }
  auto built = Polyhedron::build(mesh);
  if (!built) return built.error();
  Shaping shaping = length_tensions(*built);
  for (Index v = 0; v < normals.size(); ++v) shaping.pin.set(VertexId{v}, {Pin::Kind::normal, {normals[v]}});
  return PolyhedronSource{made->origin, *std::move(built), std::move(shaping), Mode::fair, {}};
}

}  // namespace

Result<Document> convert_to_polyhedron(const Document& document, ObjectId id, const CancelToken& cancel) {
  return detail::change_object(document, id, true, [&](Object& object) -> Result<Done> {
    const OutlineSource* outline = object.outline();
    const SolidsSource* solids = object.solids();
    if (!outline && !solids)
      return make_error(e_wrong_kind, "The object \"" + object.name + "\" cannot become a polyhedron.",
                        "Select an outline or solids.", element_of(id));
    auto made = outline ? converted(*outline, cancel) : converted(*solids, cancel);
    if (!made) return made.error();
    object.source = std::move(made).value();
    object.display.polyhedron = true;
    return Done{};
  });
}

}  // namespace hariko

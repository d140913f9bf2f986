#include "core/modeling/convert_object.hpp"

#include "core/document/edit_elements.hpp"
#include "core/document/edit_support.hpp"
#include "core/envelope/cage_surface.hpp"
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

Result<PolyhedronSource> converted(const SolidsSource& source, const CancelToken& cancel) {
  const auto made = EnvelopeSurfacer().rebuild(*source.input, Quality::final, cancel);
  if (!made) return made.error();
  if (made->cage) return PolyhedronSource{made->origin, *made->cage, made->shaping, Mode::fair, {}};
  PolygonMesh mesh;
  for (const CageVertex& vertex : made->network->cage.vertices) mesh.positions.push_back(vertex.position);
  for (const CageFace& face : made->network->cage.faces) mesh.add_face(face.loop);
  auto built = Polyhedron::build(mesh);
  if (!built) return built.error();
  Shaping shaping = length_tensions(*built);
  for (Index v = 0; v < mesh.positions.size(); ++v)
    shaping.pin.set(VertexId{v}, {Pin::Kind::normal, {made->network->cage.vertices[v].normal}});
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

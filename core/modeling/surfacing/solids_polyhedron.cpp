#include "core/approximation/surface_projector.hpp"
#include "core/envelope/envelope.hpp"
#include "core/modeling/surfacing/convert_object.hpp"
#include "core/modeling/surfacing/surface_input.hpp"

namespace hariko {
namespace {

/// Corners and faces of the envelope's patches.
struct Corners {
  PolygonMesh mesh;
  std::vector<Vector3> normals;  ///< surface normal of each corner
};

Corners corners_of(const EnvelopeSurface& made) {
  Corners out;
  if (made.network) {
    for (const CageVertex& vertex : made.network->cage.vertices) {
      out.mesh.positions.push_back(vertex.position);
      out.normals.push_back(vertex.normal);
    }
    for (const CageFace& face : made.network->cage.faces) out.mesh.add_face(face.loop);
  } else {
    out.mesh.positions = made.cage->positions;
    for (Index v = 0; v < out.mesh.positions.size(); ++v) out.normals.push_back(made.surface.node_normal(v));
    for (const auto& quad : made.cage->quads) out.mesh.add_face(quad);
  }
  return out;
}

double farthest_outside(const Surface& surface, const EnvelopeInput& input, double diagonal,
                        const CancelToken& cancel) {
  // Tolerances relative to the diagonal, as in `EnvelopeSurfacer`.
  constexpr double tolerance = 1e-4, curve_spacing = 1e-3;
  std::vector<SolidShape> shapes;
  for (const Solid& solid : input.solids) shapes.emplace_back(solid, surface.origin());
  EnclosureEffort effort;
  effort.spacing = curve_spacing * diagonal;
  effort.covered = false;
  const EnclosureReport report = check_enclosure(surface, shapes, effort, tolerance * diagonal, cancel);
  return report.outside > 0 ? report.worst : 0;
}

}  // namespace

Result<SolidsPolyhedron> solids_polyhedron(const SolidsSource& source, const CancelToken& cancel,
                                           const Progress& progress) {
  const auto made = EnvelopeSurfacer().rebuild(*source.input, Quality::final, cancel);
  if (!made) return made.error();
  progress.report(0.3);
  const Corners corners = corners_of(*made);
  auto built = Polyhedron::build(corners.mesh);
  if (!built) return built.error();
  Shaping shaping;
  for (Index v = 0; v < corners.normals.size(); ++v)
    shaping.pin.set(VertexId{v}, {Pin::Kind::normal, {corners.normals[v]}});
  SolidsPolyhedron out{{made->origin, *std::move(built), std::move(shaping), Mode::fair, {}}};
  out.source.frames = Frames::metric;

  const auto input = surface_input(out.source);
  if (!input) return input.error();
  const auto surface = PolyhedronSurfacer().rebuild(*input, Quality::final, cancel);
  if (!surface) return surface.error();
  progress.report(0.5);
  out.distance = farthest_from(surface->surface, made->surface, cancel, progress.part(0.5, 0.8));
  out.outside = farthest_outside(surface->surface, *source.input, made->diagonal, cancel);
  if (cancel.cancelled()) return make_error(e_cancelled, "The conversion was cancelled.");
  return out;
}

}  // namespace hariko

#include "core/modeling/surfacing/skin_polyhedron.hpp"

#include <algorithm>

#include "core/approximation/surface_projector.hpp"
#include "core/modeling/surfacing/surface_input.hpp"
#include "core/skinning/evaluate_skin.hpp"
#include "core/skinning/local_skin.hpp"

namespace hariko {

namespace {

/// Shaping of a polyhedron whose vertices are those of the control mesh.
Shaping shaping_of(const Surface& skin) {
  const SubdivisionPatchSet& patches = *subdivision_patches(skin);
  const SubdivisionTopology& topology = patches.topology();
  Shaping out;
  for (const ControlMesh::Crease& crease : topology.mesh().creases)
    if (crease.sharpness >= infinitely_sharp)
      out.crease.set(EdgeId::of(VertexId{crease.a}, VertexId{crease.b}), true);
  for (const ControlMesh::Corner& corner : topology.mesh().corners)
    out.tag.set(VertexId{corner.vertex}, VertexTag::corner);
  for (Index v = 0; v < Index(topology.mesh().mesh.positions.size()); ++v) {
    const Index node = topology.vertex_node(v);
    if (node == no_index || out.tag.contains(VertexId{v})) continue;
    const Vector3& normal = skin.node_normal(node);
    if (!normal.isZero(0)) out.pin.set(VertexId{v}, Pin{Pin::Kind::normal, {normal}});
  }
  return out;
}

}  // namespace

Result<SkinPolyhedron> skin_polyhedron(const Skin& skin, const CancelToken& cancel,
                                       const Progress& progress) {
  const LocalSkin local = local_skin(skin);
  auto made =
      SkinSurfacer().surface(local.skin, local.origin, {.cancel = cancel, .progress = progress.part(0, 0.3)});
  if (!made) return made.error();
  const SubdivisionPatchSet& patches = *subdivision_patches(made->surface);
  PolygonMesh mesh = made->result.mesh.control.mesh;
  for (Index v = 0; v < Index(mesh.positions.size()); ++v)
    if (patches.topology().vertex_node(v) != no_index) mesh.positions[v] = patches.limit_position(v);
  auto source = PolyhedronSource::from_mesh(std::move(mesh));
  if (!source) return source.error();
  SkinPolyhedron out{*std::move(source), 0, made->result.warnings};
  out.source.origin += local.origin;
  out.source.shaping = shaping_of(made->surface);
  const auto input = surface_input(out.source);
  if (!input) return input.error();
  PolyhedronSurfacer surfacer;
  const auto built = surfacer.rebuild(*input, Quality::final, cancel);
  if (!built)
    out.warnings.push_back(built.error());
  else
    out.distance = farthest_from(built->surface, made->surface, cancel, progress.part(0.5, 1));
  if (cancel.cancelled()) return make_error(e_cancelled, "The conversion was cancelled.");
  return out;
}

}  // namespace hariko

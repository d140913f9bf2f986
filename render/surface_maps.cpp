#include "render/surface_maps.hpp"

#include <algorithm>
#include <cmath>

#include "core/analysis/making_maps.hpp"
#include "core/analysis/maps.hpp"
#include "core/base/assert.hpp"
#include "core/surface/surface_triangles.hpp"

namespace hariko {

namespace {

/// Density of the triangles that rays meet: about `budget` of them where the surface has so few patches. A
/// multiple of the density of the map, or else a divisor: the map's points then lie on them.
int ray_density(const Surface& surface, int density, double budget) {
  const double a_cell = surface.domain() == Domain::triangle ? 1 : 2;
  const double patches = std::max<double>(surface.patch_count(), 1);
  const int wanted = std::clamp(static_cast<int>(std::sqrt(budget / (a_cell * patches))), 1, 64);
  if (wanted >= density) return density * (wanted / density);
  int divisor = wanted;
  while (density % divisor != 0) --divisor;
  return divisor;
}

std::shared_ptr<const TriangleTree> ray_tree(const Surface& surface, int density, const MapPlace& place) {
  constexpr double usual = 200'000, rough = 30'000;  // triangles
  const double budget = place.rough ? rough : usual;
  const SurfaceTriangles parts =
      surface_triangles(surface, place.facets ? 1 : ray_density(surface, density, budget));
  return std::make_shared<const TriangleTree>(parts.positions, parts.triangles);
}

MapFunction draft_map(const Surface& surface, int density, const MapPlace& place) {
  const Vector3 pull = place.transform.rotation.conjugate() * place.pull;
  return [pull, hiding = ray_tree(surface, density, place)](
             const Surface& shown, std::span<const Index> patches, const GridPattern& pattern,
             std::span<float> values) { draft_values(shown, pull, hiding.get(), patches, pattern, values); };
}

MapFunction radius_map(const MapPlace& place) {
  return [scale = place.transform.scale](const Surface& shown, std::span<const Index> patches,
                                         const GridPattern& pattern, std::span<float> values) {
    radius_values(shown, scale, patches, pattern, values);
  };
}

MapFunction thickness_map(const Surface& surface, int density, const MapPlace& place) {
  return [scale = place.transform.scale, walls = ray_tree(surface, density, place)](
             const Surface& shown, std::span<const Index> patches, const GridPattern& pattern,
             std::span<float> values) { thickness_values(shown, *walls, scale, patches, pattern, values); };
}

MapFunction deviation_map(const Surface& surface, const MapPlace& place) {
  const Similarity back = place.reference_transform.inverse();
  ToReference to;
  to.turn =
      (back.scale * place.transform.scale) * (back.rotation * place.transform.rotation).toRotationMatrix();
  to.shift = back.apply(place.transform.apply(surface.origin())) - place.reference->surface().origin();
  return [to, scale = place.reference_transform.scale, reference = place.reference](
             const Surface& shown, std::span<const Index> patches, const GridPattern& pattern,
             std::span<float> values) {
    deviation_values(shown, *reference, to, scale, patches, pattern, values);
  };
}

}  // namespace

DisplayOptions map_options(SurfaceMap map, int density) {
  HARIKO_ASSERT(!is_of_making(map), "maps of making need a surface and its place");
  DisplayOptions options;
  options.density = density;
  const auto curvature_map = [](MapKind kind) -> MapFunction {
    return [kind](const Surface& surface, std::span<const Index> patches, const GridPattern& pattern,
                  std::span<float> values) { map_values(surface, kind, patches, pattern, values); };
  };
  switch (map) {
    case SurfaceMap::gaussian:
      options.map = curvature_map(MapKind::gauss);
      break;
    case SurfaceMap::mean:
      options.map = curvature_map(MapKind::mean);
      break;
    case SurfaceMap::principal_max:
      options.map = curvature_map(MapKind::k1);
      break;
    case SurfaceMap::principal_min:
      options.map = curvature_map(MapKind::k2);
      break;
    case SurfaceMap::continuity:
      options.edge_map = seam_curvature_jumps;
      break;
    case SurfaceMap::shaded:
    case SurfaceMap::patches:
    case SurfaceMap::zebra:
    case SurfaceMap::isophotes:
    case SurfaceMap::draft:
    case SurfaceMap::radius:
    case SurfaceMap::thickness:
    case SurfaceMap::deviation:
      break;
  }
  return options;
}

bool is_local(SurfaceMap map) {
  return map != SurfaceMap::draft && map != SurfaceMap::thickness;
}

int facet_density(SurfaceMap map, Index facets) {
  constexpr double budget = 200'000;  // triangles
  if (!is_of_making(map)) return 1;
  return std::clamp(static_cast<int>(std::sqrt(budget / std::max<double>(1, facets))), 1, 32);
}

Result<DisplayOptions> map_options(const Surface& surface, SurfaceMap map, int density,
                                   const MapPlace& place) {
  if (!is_of_making(map)) return map_options(map, density);
  DisplayOptions options;
  options.density = density;
  switch (map) {
    case SurfaceMap::draft:
      options.map = draft_map(surface, density, place);
      break;
    case SurfaceMap::radius:
      if (place.facets)
        return make_error(e_map_facets, "Facets are flat: they have no radius.",
                          "Choose an object with a smooth surface.");
      options.map = radius_map(place);
      break;
    case SurfaceMap::thickness:
      if (!is_closed(surface))
        return make_error(e_map_open, "The surface is open: its walls have no thickness.",
                          "Close its holes, or the ends of a skin.");
      options.map = thickness_map(surface, density, place);
      break;
    default:
      if (!place.reference) return place.no_reference;
      options.map = deviation_map(surface, place);
      break;
  }
  return options;
}

std::vector<float> values_of(const DisplayMesh& mesh, SurfaceMap map) {
  return map == SurfaceMap::continuity ? mesh.defined_seam_values() : mesh.defined_values();
}

}  // namespace hariko

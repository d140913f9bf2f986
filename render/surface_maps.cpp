#include "render/surface_maps.hpp"

#include "core/analysis/maps.hpp"

namespace hariko {

DisplayOptions map_options(SurfaceMap map, int density) {
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
      break;
  }
  return options;
}

std::vector<float> values_of(const DisplayMesh& mesh, SurfaceMap map) {
  return map == SurfaceMap::continuity ? mesh.defined_seam_values() : mesh.defined_values();
}

}  // namespace hariko

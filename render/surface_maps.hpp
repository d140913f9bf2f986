#pragma once

// Computation of the values of surface maps.

#include <memory>

#include "core/approximation/deviation.hpp"
#include "core/base/result.hpp"
#include "core/document/similarity.hpp"
#include "render/color_map.hpp"
#include "render/display_mesh.hpp"

namespace hariko {

inline constexpr Code e_map_open{"E_MAP_OPEN"};
inline constexpr Code e_map_facets{"E_MAP_FACETS"};
inline constexpr Code e_map_reference{"E_MAP_REFERENCE"};

/// Options for DisplayMesh::build that give a mesh the values of `map`: curvatures at the points, the
/// relative jump of the curvature tensor (0 .. 2) on the seams for `continuity`, nothing for maps without
/// values. Not for maps of making (asserted).
DisplayOptions map_options(SurfaceMap map, int density);

/// Whether a map's value at a point depends on the surface round it alone, so that a mesh of which some
/// patches changed can be refreshed.
bool is_local(SurfaceMap map);

/// Density at which flat facets show a map: 1, but for maps of making finer, since a large facet has many
/// thicknesses and distances. 1 .. 32.
int facet_density(SurfaceMap map, Index facets);

/// Surroundings that maps of making depend on beside a surface.
struct MapPlace {
  Similarity transform;             ///< from the surface's space to the world
  bool facets = false;              ///< the surface consists of flat facets
  bool rough = false;               ///< for a gesture: rays meet fewer triangles
  Vector3 pull = Vector3::UnitZ();  ///< in the world, of any length but 0
  /// For `deviation`; null where there is none, with the reason in `no_reference`.
  std::shared_ptr<const DeviationReference> reference;
  Similarity reference_transform;  ///< from the reference's space to the world
  Message no_reference;
};

/// Options as above, also for maps of making: their values are degrees, or lengths in the world. Prepares the
/// search that they need, O(n log n) in triangles. Errors: E_MAP_OPEN (a wall of a surface that is not
/// closed), E_MAP_FACETS (facets are not curved), `no_reference`.
Result<DisplayOptions> map_options(const Surface& surface, SurfaceMap map, int density,
                                   const MapPlace& place);

/// Values of the mesh for the map, as automatic_range and histograms need them. O(values).
std::vector<float> values_of(const DisplayMesh& mesh, SurfaceMap map);

}  // namespace hariko

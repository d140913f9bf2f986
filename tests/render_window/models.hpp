#pragma once

// Models that the picture tests draw.

#include <memory>
#include <string>

#include "core/patching/polyhedron_surface.hpp"
#include "render/picture.hpp"
#include "render/surface_maps.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/golden.hpp"

namespace hariko::test {

inline SceneObject object_of(const Surface& surface, SurfaceMap map, int density) {
  SceneObject object;
  object.mesh = DisplayMesh::build(surface, map_options(map, density));
  object.map = map;
  object.range = automatic_range(map, values_of(*object.mesh, map));
  return object;
}

/// A golden polyhedron with its surface.
inline SceneObject golden_object(const std::string& obj, SurfaceMap map, const std::string& tension = {},
                                 int density = 0) {
  const PolyhedronSurfaceInput input = golden_input(obj, Mode::fair, tension);
  const PolyhedronSurface result = PolyhedronSurfacer().rebuild(input).value();
  SceneObject object =
      object_of(result.surface, map, density > 0 ? density : display_density(result.surface.patch_count()));
  object.polyhedron = DisplayPolyhedron::build(input.polyhedron, input.shaping, input.origin);
  return object;
}

inline Scene scene_of(SceneObject object) {
  Scene scene;
  scene.objects.push_back(std::move(object));
  const Box3 box = scene.world_box();
  if (!box.isEmpty()) scene.grid.height = box.min().z();
  return scene;
}

/// Small, as software draws it.
inline constexpr PixelSize picture_size{320, 240};

inline Scene plain(SceneObject object) {
  Scene scene = scene_of(std::move(object));
  scene.grid.visible = false;
  return scene;
}

inline Camera looking(const Scene& scene, StandardView view) {
  return framed(Camera::standard(view), scene, picture_size);
}

}  // namespace hariko::test

#include "ui/editor/shown_surfaces.hpp"

#include "ui/editor/scene_builder.hpp"

namespace hariko {

std::vector<SceneObject> shown_surfaces(const Editor& editor) {
  std::vector<SceneObject> out;
  for (const auto& object : editor.document().objects) {
    const SurfaceView* shown = editor.view_of(object->id);
    // A surface that is not that of the present document must not keep it from being mended.
    if (!object->visible || !object->display.surface || !object->has_surface() || !shown || !shown->mesh ||
        shown->error)
      continue;
    for (const Similarity& place : places_of(*object)) {
      SceneObject& surface = out.emplace_back();
      surface.mesh = shown->mesh;
      surface.transform = matrix_of(place);
    }
  }
  return out;
}

}  // namespace hariko

#include "ui/view/handle_sight.hpp"

#include <algorithm>

#include "ui/editor/shown_surfaces.hpp"

namespace hariko {

void HandleSight::look(const Editor& editor) {
  if (editor.view.x_ray || editor.selecting.through) return view_.reset();
  std::vector<SceneObject> surfaces = shown_surfaces(editor);
  const auto section = section_plane(editor.view);
  const auto same = [](const SceneObject& a, const SceneObject& b) {
    return a.mesh == b.mesh && a.transform == b.transform;
  };
  if (view_ && view_->camera == editor.camera() && view_->viewport == editor.viewport &&
      view_->section == section && std::ranges::equal(view_->surfaces, surfaces, same))
    return;
  SurfaceOcclusion occlusion(surfaces, section, Projector(editor.camera(), editor.viewport),
                             4 * editor.pixel_scale);
  view_.emplace(View{editor.camera(), editor.viewport, section, std::move(surfaces), std::move(occlusion)});
}

}  // namespace hariko

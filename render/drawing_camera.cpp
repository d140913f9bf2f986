#include "render/drawing_camera.hpp"

#include <cmath>

namespace hariko {

DrawingView drawing_view(const Camera& camera, double width, double height, const Box3& shown,
                         const std::optional<SectionPlane>& section) {
  DrawingView view;
  view.eye = camera.eye();
  view.right = camera.right();
  view.up = camera.picture_up();
  view.forward = camera.picture_forward();
  view.orthographic = camera.orthographic;
  view.focal = camera.orthographic ? height / camera.view_height() : height / (2 * camera.half_slope());
  view.middle = camera.middle_slope();
  view.width = width;
  view.height = height;
  view.near_plane = camera.clip_range(shown).near_plane;
  if (section) view.section = Eigen::Hyperplane<double, 3>(section->normal, -section->offset);
  return view;
}

}  // namespace hariko

#include "ui/files/drawing_order.hpp"

#include "core/drawing/write_drawing_svg.hpp"
#include "render/drawing_camera.hpp"
#include "render/picture.hpp"
#include "ui/files/picture_order.hpp"

namespace hariko {

namespace {

/// Of what the scene shows; objects of which there is no surface yet are left out.
std::vector<DrawnSurface> surfaces_of(const Editor& editor, const SceneBuilder& builder) {
  std::vector<DrawnSurface> out;
  const Scene& scene = builder.scene();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    const SurfaceView* view = object.show_surface ? editor.view_of(builder.object_id(i)) : nullptr;
    if (view && view->surface.patch_count() > 0)
      out.push_back({view->surface, Eigen::Affine3d(object.transform)});
  }
  return out;
}

}  // namespace

Vector2 page_of(const DrawingSettings& settings, PixelSize view) {
  return {settings.width, settings.width / view.aspect()};
}

Result<DrawingOrder> order_drawing(const Editor& editor, const SceneBuilder& builder,
                                   const DrawingSettings& settings, const std::filesystem::path& file) {
  if (builder.paper())
    return make_error(e_drawing_of_paper, "Line drawings show surfaces, and the view shows the paper model.",
                      "Hide the paper, or export its pages as SVG.");
  if (!editor.stale_since.empty())
    return make_error(e_surface_pending, "A surface is still being computed.",
                      "Export the drawing when it is ready.");
  DrawingOrder out;
  out.surfaces = surfaces_of(editor, builder);
  if (out.surfaces.empty())
    return make_error(e_nothing_to_show, "No surface is visible: there is nothing to draw lines of.",
                      "Show the surface of an object, or add one.");
  const Scene& scene = builder.scene();
  const Vector2 page = pixels_per_millimetre * page_of(settings, editor.viewport);
  out.view = drawing_view(editor.camera(), page.x(), page.y(), scene.world_box(), scene.section);
  if (!settings.network) out.lines.kinds.erase(LineKind::network);
  out.lines.hidden = settings.hidden;
  out.file = file;
  return out;
}

}  // namespace hariko

#include "ui/files/picture_order.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/drawing/write_drawing_svg.hpp"
#include "render/drawing_camera.hpp"
#include "render/picture.hpp"
#include "ui/editor/legend_source.hpp"

namespace hariko {

namespace {

/// Widens the view where the picture is narrower than it, so that nothing is cut off at the sides.
Camera fitted(Camera camera, PixelSize view, PixelSize picture) {
  const double narrower = view.aspect() / picture.aspect();
  if (narrower > 1) camera.field_of_view = 2 * std::atan(std::tan(camera.field_of_view / 2) * narrower);
  return camera;
}

Camera turned(Camera camera, double angle, const Vector3& centre) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Vector3::UnitZ()));
  camera.target = centre + turn * (camera.target - centre);
  camera.orientation = (turn * camera.orientation).normalized();
  return camera;
}

/// The camera that shows the model wherever it turns to.
Camera framing_all_turns(const Camera& camera, const Scene& scene, const Vector3& centre, PixelSize size) {
  std::vector<Vector3> points, swept;
  for (const SceneObject& object : scene.objects) object.add_outline(points, 2000);
  constexpr int turns = 24;
  swept.reserve(points.size() * turns);
  for (int i = 0; i < turns; ++i) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(2 * std::numbers::pi * i / turns, Vector3::UnitZ()));
    for (const Vector3& point : points) swept.push_back(centre + turn * (point - centre));
  }
  return camera.frame(swept, size);
}

/// As the view shows it: of the active object's own map, else of the view's.
std::optional<Legend> legend_of(const Editor& editor, const SceneBuilder& scene) {
  const auto source = legend_source(editor, scene);
  if (!source) return {};
  Legend legend;
  legend.map = source->map;
  legend.range = source->range;
  legend.histogram = *source->histogram;
  legend.unit = unit_of(legend.map, to_string(editor.document().unit));
  legend.on_dark = editor.settings.theme != ThemeId::light;
  legend.colour_blind_safe = editor.settings.colour_blind_maps;
  return legend;
}

Result<PictureOrder> order(const Editor& editor, const SceneBuilder& builder,
                           const PictureSettings& settings) {
  PictureOrder out;
  out.scene = builder.scene();
  out.size = size_of(settings, editor.viewport);
  if (const auto checked = check_picture_size(out.size.width, out.size.height); !checked)
    return checked.error();
  if (out.scene.objects.empty())
    return make_error(e_nothing_to_show, "No object is visible: the picture would be empty.",
                      "Show an object or add one.");
  if (!editor.stale_since.empty())
    return make_error(e_surface_pending, "A surface is still being computed.",
                      "Export the picture when it is ready.");
  for (SceneObject& object : out.scene.objects) {
    object.hovered = {};
    object.hovered_patches.clear();
    object.outlined_as_hovered = false;
    if (settings.selection) continue;
    object.outlined = false;
    object.selected = {};
    object.selected_patches.clear();
  }
  out.scene.lines.clear();
  out.scene.grid.visible = out.scene.grid.visible && settings.grid;
  if (settings.transparent) out.scene.background = Background::transparent;
  const double scale = std::min(double(out.size.width) / editor.viewport.width,
                                double(out.size.height) / editor.viewport.height) *
                       editor.pixel_scale;
  out.scene.pixel_scale = scale;
  if (settings.legend) out.legend = legend_of(editor, builder);
  if (out.legend) out.legend->scale = scale;
  return out;
}

}  // namespace

PixelSize size_of(const PictureSettings& settings, PixelSize view) {
  switch (settings.size) {
    case PictureSettings::Size::full_hd:
      return {1920, 1080};
    case PictureSettings::Size::ultra_hd:
      return {3840, 2160};
    case PictureSettings::Size::custom:
      return settings.custom;
    case PictureSettings::Size::view:
      break;
  }
  return view;
}

Result<PictureOrder> order_picture(const Editor& editor, const SceneBuilder& scene,
                                   const PictureSettings& settings, const std::filesystem::path& file) {
  auto ordered = order(editor, scene, settings);
  if (!ordered) return ordered;
  PictureOrder out = std::move(ordered).value();
  out.cameras = {fitted(editor.camera(), editor.viewport, out.size)};
  out.files = {file};
  return out;
}

Result<PictureOrder> order_turntable(const Editor& editor, const SceneBuilder& scene,
                                     const PictureSettings& settings, const std::filesystem::path& file) {
  const int count = settings.turntable_pictures;
  if (count < 1 || count > most_turntable_pictures)
    return make_error(e_picture_count,
                      "A turntable of " + std::to_string(count) +
                          " pictures was asked for; it may have 1 to " +
                          std::to_string(most_turntable_pictures) + ".",
                      "Choose another number.");
  auto ordered = order(editor, scene, settings);
  if (!ordered) return ordered;
  PictureOrder out = std::move(ordered).value();
  const Box3 box = out.scene.world_box();
  const Vector3 centre = box.isEmpty() ? editor.camera().target : Vector3(box.center());
  Camera camera = fitted(editor.camera(), editor.viewport, out.size);
  if (settings.fit) camera = framing_all_turns(camera, out.scene, centre, out.size);
  for (int i = 0; i < count; ++i)
    out.cameras.push_back(turned(camera, -2 * std::numbers::pi * i / count, centre));
  out.files = series_files(file, count);
  return out;
}

std::vector<std::filesystem::path> series_files(const std::filesystem::path& file, int count) {
  std::vector<std::filesystem::path> files;
  for (int i = 1; i <= count; ++i) {
    std::string number = std::to_string(i);
    number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
    files.push_back(file.parent_path() / (file.stem().string() + "_" + number + ".png"));
  }
  return files;
}

namespace {

/// Surfaces of the scene; objects of which there is no surface yet are left out.
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

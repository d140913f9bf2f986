#include <algorithm>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/commands/shown_objects.hpp"
#include "render/picture.hpp"
#include "render/surface_maps.hpp"

namespace hariko {

namespace {

/// Sets one range for all objects, so that a colour means the same everywhere.
void set_ranges(Scene& scene, SurfaceMap map, const MapRange& wanted, Legend& legend) {
  std::vector<float> values;
  for (const SceneObject& object : scene.objects) {
    if (object.map != map) continue;  // reference facets
    const auto own = values_of(*object.mesh, map);
    values.insert(values.end(), own.begin(), own.end());
  }
  legend.map = map;
  legend.range = value_range(map, wanted, values);
  legend.histogram = histogram(values, legend.range, 64);
  for (SceneObject& object : scene.objects) object.range = legend.range;
}

}  // namespace

int run_render(const RenderArguments& arguments) {
  const std::string file = arguments.file.string();
  const auto document = read_document_or_report(arguments.file, arguments.construction);
  if (!document) return exit_failed;

  Scene scene;
  scene.grid.visible = false;
  scene.background = arguments.background;
  scene.section = arguments.section;
  scene.zebra.stripes = arguments.stripes;
  scene.colour_blind_safe = arguments.colour_blind_safe;
  auto objects = shown_objects_or_report(*document, arguments);
  if (!objects) return exit_failed;
  for (ShownObject& object : *objects) scene.objects.push_back(std::move(object.part));

  Legend legend;
  legend.colour_blind_safe = arguments.colour_blind_safe;
  legend.on_dark = arguments.background == Background::dark;
  if (has_values(arguments.map)) set_ranges(scene, arguments.map, arguments.range, legend);
  const PixelSize size{arguments.width, arguments.height};
  const Camera camera = Camera::standard(arguments.view).frame(scene.world_box(), size);
  auto picture = render_picture(scene, camera, size.width, size.height);
  if (!picture.ok()) {
    report(file, picture.error());
    return exit_failed;
  }
  Image image = std::move(picture).value();
  if (has_values(arguments.map)) {
    legend.unit = unit_of(arguments.map, to_string(document->unit));
    paint_legend(image, legend);
  }
  if (const auto written = write_png(arguments.out, image); !written.ok()) {
    report(arguments.out.string(), written.error());
    return exit_failed;
  }
  return exit_fine;
}

}  // namespace hariko

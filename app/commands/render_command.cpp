#include <algorithm>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "core/analysis/combs.hpp"
#include "core/analysis/continuity.hpp"
#include "core/modeling/attached.hpp"
#include "render/picture.hpp"
#include "render/surface_maps.hpp"
#include "ui/solids_display.hpp"

namespace hariko {

namespace {

/// The object as a part of the scene; its surface is drawn at the density that looks smooth.
Result<SceneObject> scene_object(const Document& document, const Object& object,
                                 const RenderArguments& arguments) {
  const auto built = object_surface(document, object);
  if (!built.ok()) return built.error();
  SceneObject out;
  // Lines of the display mesh are there to be told apart.
  const int density = arguments.wire == PatchWire::mesh
                          ? object.display.density
                          : display_density(built->surface.patch_count(), built->surface.domain(), 1'000'000);
  out.mesh = DisplayMesh::build(built->surface, map_options(arguments.map, density));
  out.polyhedron = object.solids() ? display_of(*object.solids()) : cage_of(object);
  out.transform = matrix_of(object.transform);
  out.map = arguments.map;
  const DisplaySettings display =
      with_material(object.display, arguments.material.value_or(object.display.material));
  out.material = display.material;
  out.color = color_of(arguments.colour.value_or(display.colour));
  out.show_polyhedron = arguments.polyhedron;
  if (object.solids()) {
    out.show_bodies = out.x_ray = arguments.polyhedron;
    out.show_points = false;
  }
  out.show_network = arguments.network;
  out.show_tensions = arguments.tensions;
  out.wire = arguments.wire;
  if (arguments.combs) {
    const CurvatureCombs combs = curvature_combs(built->surface, object.display.combs.density);
    out.combs = comb_lines(combs, built->surface.origin());
    out.comb_scale = object.display.combs.scale;
  }
  if (arguments.marks)
    out.marks = edge_marks(*out.mesh, classify(built->surface, continuity(built->surface), {}));
  return out;
}

/// One range for all objects, so that a colour means the same everywhere.
void set_ranges(Scene& scene, SurfaceMap map, const MapRange& wanted, Legend& legend) {
  std::vector<float> values;
  for (const SceneObject& object : scene.objects) {
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
  for (const auto& object : document->objects) {
    if (!object->visible || !object->has_surface()) continue;
    auto part = scene_object(*document, *object, arguments);
    if (!part.ok()) {
      report(file + ": " + object->name, part.error());
      return exit_failed;
    }
    scene.objects.push_back(std::move(part).value());
  }
  if (scene.objects.empty()) {
    report(file, make_error(e_nothing_to_show, "No visible object of the file has a surface.",
                            "Make an object visible, or add one."));
    return exit_failed;
  }

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

#include <cmath>
#include <iostream>
#include <span>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/commands/shown_objects.hpp"
#include "app/pictures/sample_pictures.hpp"
#include "core/base/files/file_io.hpp"
#include "core/document/edits/edit_making.hpp"
#include "render/drawing_camera.hpp"
#include "render/offscreen.hpp"
#include "render/picture.hpp"
#include "render/renderer.hpp"
#include "render/surface_maps.hpp"
#include "ui/editor/selected_items.hpp"

namespace hariko {

namespace {

/// Sets one range for all objects, so that a colour means the same everywhere.
void set_ranges(Scene& scene, SurfaceMap map, const MapRange& wanted, double limit, Legend& legend) {
  std::vector<float> values;
  for (const SceneObject& object : scene.objects) {
    if (object.map != map) continue;  // reference facets, and what has no values
    const auto own = values_of(*object.mesh, map);
    values.insert(values.end(), own.begin(), own.end());
  }
  legend.map = map;
  legend.range = value_range(map, wanted, values, limit);
  legend.histogram = histogram(values, legend.range, 64);
  for (SceneObject& object : scene.objects) object.range = legend.range;
}

/// The document with what the arguments say about making instead of its own. Errors: E_MAKING_INVALID,
/// E_NO_SUCH_OBJECT.
Result<Document> with_making(const Document& document, const RenderArguments& arguments) {
  MakingSettings making = document.making;
  if (arguments.pull) making.pull = *arguments.pull;
  if (arguments.limit) {
    const double unit = millimetres_per(document.unit);
    if (arguments.map == SurfaceMap::draft) making.draft = *arguments.limit;
    if (arguments.map == SurfaceMap::radius) making.radius = *arguments.limit * unit;
    if (arguments.map == SurfaceMap::thickness) making.thickness = *arguments.limit * unit;
  }
  if (!arguments.reference.empty()) {
    const auto named = objects_named(document, std::span(&arguments.reference, 1));
    if (!named) return named.error();
    making.reference = named->front();
  }
  return set_making(document, making);
}

/// The environment that the arguments name: by its word, else a file. Errors: of reading the file.
Result<Environment> environment_of(const RenderArguments& arguments) {
  Environment out;
  out.turn = arguments.environment_turn;
  out.exposure = arguments.exposure;
  if (arguments.environment.empty()) return out;
  Result<RadianceImage> picture = RadianceImage{};
  if (const auto kind = enum_value<EnvironmentKind>(arguments.environment);
      kind && *kind != EnvironmentKind::file) {
    picture = environment_picture(*kind);
  } else {
    const Result<std::string> bytes = read_file(arguments.environment, largest_environment_file);
    if (!bytes) return bytes.error();
    picture = read_environment(*bytes);
  }
  if (!picture) return picture.error();
  out.levels = std::make_shared<const EnvironmentLevels>(environment_levels(std::move(picture).value()));
  return out;
}

}  // namespace

int run_render(const RenderArguments& arguments) {
  const auto read = read_document_or_report(arguments.file, arguments.construction);
  if (!read) return exit_failed;
  const auto document = with_making(*read, arguments);
  if (!document) return failure(arguments.file, document.error());

  Scene scene;
  scene.grid.visible = false;
  scene.background = arguments.background;
  scene.section = arguments.section;
  scene.zebra.stripes = arguments.stripes;
  scene.colour_blind_safe = arguments.colour_blind_safe;
  auto environment = environment_of(arguments);
  if (!environment) return failure(arguments.environment, environment.error());
  scene.environment = std::move(environment).value();
  auto objects = shown_objects_or_report(*document, arguments);
  if (!objects) return exit_failed;
  for (ShownObject& object : *objects) scene.objects.push_back(std::move(object.part));

  Legend legend;
  legend.colour_blind_safe = arguments.colour_blind_safe;
  legend.on_dark = arguments.background == Background::dark;
  if (has_values(arguments.map))
    set_ranges(scene, arguments.map, arguments.range, limit_of(*document, arguments.map), legend);
  const PixelSize size{arguments.width, arguments.height};
  const auto camera = camera_for(*document, arguments.saved_view, arguments.view, scene.world_box(), size);
  if (!camera) return failure(arguments.file, camera.error());
  auto picture = render_picture(scene, *camera, size.width, size.height);
  if (!picture.ok()) return failure(arguments.file, picture.error());
  Image image = std::move(picture).value();
  if (has_values(arguments.map)) {
    legend.unit = unit_of(arguments.map, to_string(document->unit));
    paint_legend(image, legend);
  }
  if (const auto written = write_png(arguments.out, image); !written.ok())
    return failure(arguments.out, written.error());
  return exit_fine;
}

int run_drawing(const DrawingArguments& arguments) {
  const auto document = read_document_or_report(arguments.file, arguments.construction);
  if (!document) return exit_failed;
  RenderArguments picture;  // picture with the same camera
  picture.file = arguments.file;
  auto objects = shown_objects_or_report(*document, picture);
  if (!objects) return exit_failed;
  Scene scene;
  std::vector<DrawnSurface> surfaces;
  for (ShownObject& object : *objects) {
    surfaces.push_back({object.surface, Eigen::Affine3d(object.part.transform)});
    scene.objects.push_back(std::move(object.part));
  }
  // Cameras count in whole pixels; only the aspect ratio matters to them here.
  constexpr double fine = 100;
  const PixelSize shape{int(std::lround(fine * arguments.width)), int(std::lround(fine * arguments.height))};
  const Box3 box = scene.world_box();
  const auto seen = camera_for(*document, arguments.saved_view, arguments.view, box, shape);
  if (!seen) return failure(arguments.file, seen.error());
  const auto drawing =
      draw_lines(surfaces, drawing_view(*seen, arguments.width, arguments.height, box, arguments.section),
                 arguments.lines);
  if (!drawing.ok()) return failure(arguments.file, drawing.error());
  if (const auto written = write_file_atomic(arguments.out, write_drawing_svg(*drawing, arguments.unit));
      !written.ok())
    return failure(arguments.out, written.error());
  return exit_fine;
}

int run_sample_pictures(const std::filesystem::path& assets, const std::filesystem::path& out) {
  const auto made = make_sample_pictures(assets, out);
  if (made.ok()) return exit_fine;
  if (const Code code = made.error().code; code != e_no_egl && code != e_gl_version)
    return failure(out, made.error());
  std::cerr << "No pictures of the samples were drawn, so that the first start will take longer: "
            << made.error().text << " " << made.error().remedy << "\n";
  return exit_fine;
}

}  // namespace hariko

#include "app/commands/drawing_command.hpp"

#include <cmath>
#include <vector>

#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/commands/saved_view_camera.hpp"
#include "app/commands/shown_objects.hpp"
#include "core/base/files/file_io.hpp"
#include "render/drawing_camera.hpp"

namespace hariko {

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
  if (!seen) {
    report(arguments.file.string(), seen.error());
    return exit_failed;
  }
  const auto drawing =
      draw_lines(surfaces, drawing_view(*seen, arguments.width, arguments.height, box, arguments.section),
                 arguments.lines);
  if (!drawing.ok()) {
    report(arguments.file.string(), drawing.error());
    return exit_failed;
  }
  if (const auto written = write_file_atomic(arguments.out, write_drawing_svg(*drawing, arguments.unit));
      !written.ok()) {
    report(arguments.out.string(), written.error());
    return exit_failed;
  }
  return exit_fine;
}

}  // namespace hariko

#include "app/jobs/picture_export.hpp"

#include <system_error>

#include "core/base/files/file_ending.hpp"
#include "core/base/files/file_io.hpp"
#include "core/drawing/write_drawing_svg.hpp"
#include "core/drawing/write_section_set.hpp"
#include "render/picture.hpp"

namespace hariko {

namespace {

Message cancelled() {
  return make_error(e_cancelled, "The export was cancelled.");
}

Result<Done> write_one(PictureDrawer& drawer, const PictureOrder& order, std::size_t number,
                       const CancelToken& cancel) {
  if (cancel.cancelled()) return cancelled();
  auto drawn = drawer.draw(order.scene, order.cameras[number], order.size);
  if (!drawn) return drawn.error();
  Image image = std::move(drawn).value();
  if (order.legend) paint_legend(image, *order.legend);
  if (cancel.cancelled()) return cancelled();
  return write_png(order.files[number], image);
}

}  // namespace

Result<Done> write_pictures(const PictureOrder& order, const CancelToken& cancel, const Progress& progress) {
  progress.report(0);
  auto created = PictureDrawer::create();
  if (!created) return created.error();
  PictureDrawer drawer = std::move(created).value();
  const std::size_t count = order.files.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (const auto written = write_one(drawer, order, i, cancel); !written) {
      std::error_code unknown;
      for (std::size_t done = 0; done < i; ++done) std::filesystem::remove(order.files[done], unknown);
      return written.error();
    }
    progress.report(double(i + 1) / double(count));
  }
  return Done{};
}

Result<Done> write_drawing(const DrawingOrder& order, const CancelToken& cancel, const Progress& progress) {
  const auto drawing = draw_lines(order.surfaces, order.view, order.lines, cancel, progress);
  if (!drawing) return drawing.error();
  return write_file_atomic(order.file, write_drawing_svg(*drawing, PageUnit::millimetre));
}

Result<Done> write_sections(const SectionOrder& order, const CancelToken& cancel, const Progress& progress) {
  const auto set = section_set(order.surfaces, order.planes, cancel, progress);
  if (!set) return set.error();
  return write_file_atomic(order.file, lower_ending(order.file) == ".dxf"
                                           ? write_sections_dxf(*set, order.combs, order.millimetres)
                                           : write_sections_svg(*set, order.combs, order.millimetres));
}

}  // namespace hariko

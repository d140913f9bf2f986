#include "app/jobs/drawing_export.hpp"

#include "core/base/files/file_io.hpp"
#include "core/drawing/write_drawing_svg.hpp"

namespace hariko {

Result<Done> write_drawing(const DrawingOrder& order, const CancelToken& cancel, const Progress& progress) {
  const auto drawing = draw_lines(order.surfaces, order.view, order.lines, cancel, progress);
  if (!drawing) return drawing.error();
  return write_file_atomic(order.file, write_drawing_svg(*drawing, PageUnit::millimetre));
}

}  // namespace hariko

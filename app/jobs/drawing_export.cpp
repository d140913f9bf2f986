#include "app/jobs/drawing_export.hpp"

#include "core/base/files/file_ending.hpp"
#include "core/base/files/file_io.hpp"
#include "core/drawing/write_drawing_svg.hpp"
#include "core/drawing/write_section_set.hpp"

namespace hariko {

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

#include "app/files/sheet_file.hpp"

#include "core/base/file_ending.hpp"
#include "core/base/file_io.hpp"
#include "core/unfolding/write_sheets.hpp"
#include "render/sheet_picture.hpp"

namespace hariko {

std::optional<SheetFormat> sheet_format_of(const std::filesystem::path& path) {
  const std::string extension = lower_ending(path);
  if (extension == ".pdf") return SheetFormat::pdf;
  if (extension == ".svg") return SheetFormat::svg;
  if (extension == ".dxf") return SheetFormat::dxf;
  if (extension == ".png") return SheetFormat::png;
  if (extension == ".json") return SheetFormat::json;
  return {};
}

Result<Done> write_sheet_file(const std::filesystem::path& path, const SheetDrawing& drawing) {
  const auto format = sheet_format_of(path);
  HARIKO_ASSERT(format, "the name of a sheet file ends in its format");
  switch (*format) {
    case SheetFormat::pdf:
      return write_file_atomic(path, write_sheet_pdf(drawing));
    case SheetFormat::svg:
      return write_file_atomic(path, write_sheet_svg(drawing));
    case SheetFormat::dxf:
      return write_file_atomic(path, write_sheet_dxf(drawing));
    case SheetFormat::png:
      return write_png(path, sheet_picture(drawing, sheet_resolution(drawing)));
    case SheetFormat::json:
      break;
  }
  return write_file_atomic(path, write_layout_json(drawing));
}

}  // namespace hariko

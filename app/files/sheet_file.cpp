#include "app/files/sheet_file.hpp"

#include "core/base/files/file_ending.hpp"
#include "core/base/files/file_io.hpp"
#include "core/unfolding/pages/write_sheets.hpp"
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

std::vector<std::filesystem::path> sheet_files(const std::filesystem::path& path, Index page_count) {
  std::vector<std::filesystem::path> out{path};
  if (sheet_format_of(path) != SheetFormat::svg) return out;
  for (Index page = 1; page < page_count; ++page) {
    std::filesystem::path next = path;
    next.replace_filename(path.stem().string() + "-" + std::to_string(page + 1) + path.extension().string());
    out.push_back(std::move(next));
  }
  return out;
}

namespace {

Result<Done> write_svg_pages(const std::filesystem::path& path, const SheetDrawing& drawing) {
  Index page = 0;
  for (const std::filesystem::path& file : sheet_files(path, drawing.page_count))
    if (auto written = write_file_atomic(file, write_sheet_svg(drawing, page++)); !written.ok())
      return written;
  return Done{};
}

}  // namespace

Result<Done> write_sheet_file(const std::filesystem::path& path, const SheetDrawing& drawing) {
  const auto format = sheet_format_of(path);
  HARIKO_ASSERT(format, "the name of a sheet file ends in its format");
  switch (*format) {
    case SheetFormat::pdf:
      return write_file_atomic(path, write_sheet_pdf(drawing));
    case SheetFormat::svg:
      return write_svg_pages(path, drawing);
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

#pragma once

// Export of the pages of a paper model.

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/result.hpp"
#include "core/unfolding/pages/sheet_drawing.hpp"

namespace hariko {

/// File formats for pages.
enum class SheetFormat { pdf, svg, dxf, png, json };
/// Format by the ending of the name, in any case of letters; nothing for other endings.
std::optional<SheetFormat> sheet_format_of(const std::filesystem::path& path);

/// Names of the files for some pages: SVG has one page per file, "model.svg", "model-2.svg", ...; all other
/// formats use one file.
std::vector<std::filesystem::path> sheet_files(const std::filesystem::path& path, Index page_count);

/// Writes the pages; the ending must name a format (asserted). Each of `sheet_files` is either the old or the
/// whole new one. Errors: those of `write_file_atomic` and `write_png`.
Result<Done> write_sheet_file(const std::filesystem::path& path, const SheetDrawing& drawing);

}  // namespace hariko

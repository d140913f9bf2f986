#pragma once

// What the designer is told of a written file.

#include <filesystem>
#include <string>

#include "ui/export_settings.hpp"
#include "ui/language.hpp"

namespace hariko {

/// "9876 B", "120 kB", "12 MB"
std::string file_size_text(std::uintmax_t bytes);

/// "Exported a.stl: 1234 triangles, 80 mm × 60 mm × 40 mm, 61 kB." The size is in the unit of the file.
std::string export_text(const Language& tr, const std::filesystem::path& path, const ExportReport& report,
                        Unit document_unit, const FileChoices& choices);

}  // namespace hariko

#pragma once

// Texts about a file for the designer, before and after it is written.

#include <filesystem>
#include <string>

#include "core/cad/cad_totals.hpp"
#include "ui/base/language.hpp"
#include "ui/files/export_settings.hpp"

namespace hariko {

/// "9876 B", "120 kB", "12 MB"
std::string file_size_text(std::uintmax_t bytes);

/// "Exported a.stl: 1234 triangles, 80 mm × 60 mm × 40 mm, 61 kB." The size is in the unit of the file.
std::string export_text(const Language& tr, const std::filesystem::path& path, const ExportReport& report,
                        Unit document_unit, const FileChoices& choices);

/// Two lines: "faces: 54, 12 of them exact" and "off by 0.002 mm at the most, by samples · normals jump by
/// 0.03° at the most", in the document's unit.
std::string cad_count_text(const Language& tr, const CadTotals& count, Unit document_unit);

/// "Exported a.step: 54 faces, all of them exact; turned by 0.03° at the most; 61 kB."
std::string cad_export_text(const Language& tr, const std::filesystem::path& path, const CadTotals& written,
                            std::uintmax_t bytes, Unit document_unit);

}  // namespace hariko

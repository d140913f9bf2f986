#pragma once

// Exporting as the dialog says: by tolerance or by density. For a worker.

#include <filesystem>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/document.hpp"
#include "ui/files/export_settings.hpp"

namespace hariko {

/// Counts what `export_triangles` would write into a file of this name. Takes as long as making it. Errors:
/// those of `mesh_surfaces`, `density_meshes` and `check_mesh_file`; E_CANCELLED.
Result<ExportCount> count_triangles(const Document& document, const std::filesystem::path& path,
                                    const ExportSettings& settings, const CancelToken& cancel);

/// Writes what is visible in the format that the ending names. Errors: those of `mesh_surfaces`,
/// `export_surfaces` and writing; E_CANCELLED, and the file is as it was.
Result<ExportReport> export_triangles(const Document& document, const std::filesystem::path& path,
                                      const ExportSettings& settings, const CancelToken& cancel,
                                      const Progress& progress);

}  // namespace hariko

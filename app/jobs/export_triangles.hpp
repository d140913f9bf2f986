#pragma once

// Export of triangles with the dialog's settings, by tolerance or by density, on a worker.

#include <filesystem>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/document.hpp"
#include "ui/files/export_settings.hpp"

namespace hariko {

/// Counts the triangles that `export_triangles` would write to a file of this name. Takes as long as making
/// them. Errors: those of `mesh_surfaces`, `density_meshes` and `check_mesh_file`; E_CANCELLED.
Result<ExportCount> count_triangles(const Document& document, const std::filesystem::path& path,
                                    const ExportSettings& settings, const CancelToken& cancel);

/// Writes the visible objects in the format of the ending. Errors: those of `mesh_surfaces`,
/// `export_surfaces` and writing; E_CANCELLED. After an error the file is unchanged.
Result<ExportReport> export_triangles(const Document& document, const std::filesystem::path& path,
                                      const ExportSettings& settings, const CancelToken& cancel,
                                      const Progress& progress);

}  // namespace hariko

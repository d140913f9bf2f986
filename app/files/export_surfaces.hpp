#pragma once

// Writing the surfaces of a document as triangles.

#include <filesystem>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/document.hpp"
#include "core/exchange/mesh_file.hpp"

namespace hariko {

inline constexpr Code e_no_surface{"E_NO_SURFACE"};
inline constexpr Code e_too_many_triangles{"E_TOO_MANY_TRIANGLES"};

/// What formats with units and colours want to know.
WriteOptions write_options(const Document& document, const CancelToken& cancel = {});
MeshColour colour_of(const Object& object);

/// Writes the surfaces of all visible polyhedra, each patch side in `density` intervals, in the format that
/// the ending names. Computed at quality `final`. Errors: those of rebuilding (with the object's name) and of
/// writing; E_NO_SURFACE when there is nothing to write; E_TOO_MANY_TRIANGLES above 20 million, about 2 GB of
/// memory; E_CANCELLED, and the file is as it was.
Result<Done> export_surfaces(const Document& document, const std::filesystem::path& path, int density,
                             const CancelToken& cancel = {}, const Progress& progress = {});

}  // namespace hariko

#pragma once

// Files in and out, as functions that run on a worker.

#include <filesystem>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/document/document.hpp"

namespace hariko {

struct OpenedFile {
  Document document;
  std::vector<Message> warnings;
  bool native = false;  ///< a *.hariko document, so that saving may go back to the same file
};

/// A document, or a mesh as a document with one polyhedron: the ending of the name decides. Errors: those of
/// `load_document`, `read_mesh_file` and `document_from_mesh`.
Result<OpenedFile> open_file(const std::filesystem::path& path);

/// Writes the surfaces of all visible polyhedra as triangles, each patch side in `density` intervals, in the
/// format that the ending names. Computed at quality `final`. Errors: those of rebuilding (with the object's
/// name) and of writing; E_NO_SURFACE when there is nothing to write.
Result<Done> export_surfaces(const Document& document, const std::filesystem::path& path, int density,
                             const CancelToken& cancel);
inline constexpr Code e_no_surface{"E_NO_SURFACE"};

}  // namespace hariko

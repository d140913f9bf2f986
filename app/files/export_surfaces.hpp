#pragma once

// Writing the surfaces of a document as triangles.

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/document.hpp"
#include "core/document/file_choices.hpp"
#include "core/exchange/mesh_file.hpp"

namespace hariko {

inline constexpr Code e_no_surface{"E_NO_SURFACE"};
inline constexpr Code e_too_many_triangles{"E_TOO_MANY_TRIANGLES"};

/// How the document's numbers stand in a file of these choices.
WriteOptions write_options(const Document& document, const FileChoices& choices = {},
                           const CancelToken& cancel = {});
MeshColour colour_of(const Object& object);

/// A mesh from object space to the document's.
void place(TriangleMesh& mesh, const Similarity& transform);

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;  ///< in the document's space
  MeshColour colour;
};

/// All visible objects: surfaces at quality `final`, each patch side in `density` intervals, and reference
/// facets as they are. Errors: those of rebuilding (with the object's name); E_NO_SURFACE when there is none;
/// E_TOO_MANY_TRIANGLES above 20 million, about 2 GB of memory; E_CANCELLED.
Result<std::vector<NamedMesh>> density_meshes(const Document& document, int density,
                                              const CancelToken& cancel = {}, const Progress& progress = {});

/// Writes them in the format that the ending names. Errors: those of `density_meshes` and of writing;
/// E_CANCELLED, and the file is as it was. Warnings: also those of `left_out_of_triangles`.
Result<WrittenMeshes> export_surfaces(const Document& document, const std::filesystem::path& path,
                                      int density, const FileChoices& choices = {},
                                      const CancelToken& cancel = {}, const Progress& progress = {});

}  // namespace hariko

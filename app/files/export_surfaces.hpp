#pragma once

// Export of a document's surfaces as triangles, and of the control meshes of skins, for programs that
// subdivide themselves.

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/document.hpp"
#include "core/document/format/file_choices.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/offset/offset_surface.hpp"

namespace hariko {

inline constexpr Code e_no_surface{"E_NO_SURFACE"};
inline constexpr Code e_too_many_triangles{"E_TOO_MANY_TRIANGLES"};

/// Options for writing a document with these choices.
WriteOptions write_options(const Document& document, const FileChoices& choices = {},
                           const CancelToken& cancel = {});
/// Colour of an object in files.
MeshColour colour_of(const Object& object);

/// Moves a mesh from object space to the document's. Mirror images stay oriented outward.
void place(TriangleMesh& mesh, const Similarity& transform);

/// Mesh of one object.
struct NamedMesh {
  std::string name;
  TriangleMesh mesh;  ///< in the document's space
  MeshColour colour;
  std::vector<Message> warnings = {};  ///< messages of the wall
};

/// Triangles of all visible objects: surfaces at quality `final`, with `density` intervals along each patch
/// side, and reference facets unchanged. `wall`: in the document's space. Errors: those of rebuilding and of
/// `wall_surface` (with the object's name); E_OFFSET_FACETS; E_NO_SURFACE where there is none;
/// E_TOO_MANY_TRIANGLES above 20 million, about 2 GB of memory; E_CANCELLED.
Result<std::vector<NamedMesh>> density_meshes(const Document& document, int density,
                                              const CancelToken& cancel = {}, const Progress& progress = {},
                                              const Wall& wall = {});

/// Writes the triangles in the format of the ending. Errors: those of `density_meshes` and of writing;
/// E_CANCELLED. After an error the file is unchanged. Warnings include those of `left_out_of_triangles`
/// and of the wall.
Result<WrittenMeshes> export_surfaces(const Document& document, const std::filesystem::path& path,
                                      int density, const FileChoices& choices = {},
                                      const CancelToken& cancel = {}, const Progress& progress = {},
                                      const Wall& wall = {});

inline constexpr Code e_no_skin{"E_NO_SKIN"};

/// Writes the control meshes of all visible skins to one OBJ file, with creases and corners (see
/// `write_control_obj`), in the document's space. Errors: those of skinning (with the object's name) and of
/// writing; E_NO_SKIN where there is nothing to write.
Result<Done> export_control_meshes(const Document& document, const std::filesystem::path& path);

}  // namespace hariko

#pragma once

// Designer's choices for an opened mesh file.

#include "app/files/open_file.hpp"
#include "core/exchange/repair/mesh_import.hpp"

namespace hariko {

/// Applies the choices to the documents of a mesh file: adds creases, and replaces meshes by reference facets
/// where chosen. Sets `dense_faces` to the number of faces of the densest mesh where the user is to be asked;
/// `reference` then exists, too. Sets `inside_out`. Dense meshes are shown without points and edges. Adds
/// W_NOT_SAVABLE where a document has no room for the mesh. Other files stay unchanged.
void prepare_meshes(OpenedFile& opened, const MeshImport& choice);

}  // namespace hariko

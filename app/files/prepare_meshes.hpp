#pragma once

// Choices of the designer for an opened mesh file.

#include "app/files/open_file.hpp"
#include "core/exchange/mesh_import.hpp"

namespace hariko {

/// Gives the documents of a mesh file their creases, and reference facets in their place where they are
/// chosen. `dense_faces` of the file tells how many faces the densest mesh has, where that is to be asked
/// about: then `reference` is there, too. Dense meshes show without points and edges. Other files stay as
/// they are.
void prepare_meshes(OpenedFile& opened, const MeshImport& choice);

}  // namespace hariko

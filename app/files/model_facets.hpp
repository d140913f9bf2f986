#pragma once

// The facets of a file, for paper models: a mesh as it is, or the surfaces of a document cut into triangles.

#include <filesystem>
#include <string>

#include "core/base/cancellation.hpp"
#include "core/document/document.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

struct ModelFacets {
  PolygonMesh mesh;  ///< absolute positions; for documents in the document's space, all visible objects
  double millimetres_per_unit = 1;
  std::vector<Message> warnings;
};

/// Facets of the visible objects of a document: surfaces with each patch side in `density` intervals,
/// reference meshes as they are. Errors: those of rebuilding (with the object's name), E_NO_SURFACE,
/// E_TOO_MANY_TRIANGLES above a million, E_CANCELLED.
Result<ModelFacets> document_facets(const Document& document, int density, const CancelToken& cancel = {});

/// The ending of the name decides: .obj .off .ply .stl are meshes whose polygons are the facets, all else is
/// opened as a document. Errors: also those of reading.
Result<ModelFacets> model_facets(const std::filesystem::path& file, int density,
                                 const CancelToken& cancel = {});

}  // namespace hariko

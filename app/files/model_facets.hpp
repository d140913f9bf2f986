#pragma once

// The facets of a file or a document, for paper models: meshes as they are, surfaces as triangles under
// tolerances.

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "app/files/reading.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/document.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// What becomes facets, and how.
struct FacetOptions {
  bool of_polyhedra = false;            ///< the faces of polyhedra as they are, not their surfaces
  std::optional<double> distance = {};  ///< between surface and facets, the document's unit; none: proposed
  double normal_angle = 0;              ///< between their normals, radians; 0: any
  bool optimise = false;                ///< as few facets as can be found, which takes long
};

struct ModelFacets {
  PolygonMesh mesh;                ///< absolute positions; for documents in the document's space
  std::vector<PaperVertex> names;  ///< of each vertex
  double millimetres_per_unit = 1;
  std::vector<Message> warnings;
};

/// Facets of these objects of a document: surfaces at quality `final`, meshed under the options, and
/// reference meshes as they are. Objects that do not exist are left out. Errors: those of rebuilding and
/// meshing (with the object's name), E_NO_SURFACE, E_TOO_MANY_TRIANGLES above a million, E_CANCELLED.
Result<ModelFacets> document_facets(const Document& document, std::span<const ObjectId> objects,
                                    const FacetOptions& options, const CancelToken& cancel = {},
                                    const Progress& progress = {});

/// The ending of the name decides: mesh files (`open_file`) give their polygons as facets, cleaned as
/// wherever they open, and repaired where that is asked for and they cannot be unfolded otherwise; Bezier
/// patches among them are meshed. All else is opened as a document (patch files become one), of which the
/// visible objects count. Warnings: those of opening; W_REPAIRED; W_CAN_BE_OPENED where a repair would help.
/// Errors: also those of reading.
Result<ModelFacets> model_facets(const std::filesystem::path& file, const FacetOptions& options,
                                 const Reading& reading = {}, const CancelToken& cancel = {});

}  // namespace hariko

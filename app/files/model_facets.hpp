#pragma once

// Facets of a file or a document, for paper models: meshes unchanged, surfaces as triangles under tolerances.

#include <filesystem>
#include <optional>
#include <span>

#include "app/files/reading.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/document.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Choice of facets.
struct FacetOptions {
  bool of_polyhedra = false;  ///< faces of polyhedra themselves instead of their surfaces
  /// Largest distance between surface and facets, in the document's unit; nothing: a proposed one.
  std::optional<double> distance = {};
  double normal_angle = 0;  ///< largest angle between their normals, radians; 0: any
  bool optimise = false;    ///< minimises the number of facets, which takes long
};

/// Facets with names that persist through changes of the document.
struct ModelFacets {
  PolygonMesh mesh;                ///< absolute positions, in the document's space for documents
  std::vector<PaperVertex> names;  ///< by vertex
  double millimetres_per_unit = 1;
  std::vector<Message> warnings;
};

/// Facets of some objects of a document: surfaces at quality `final`, meshed under the options, and reference
/// meshes unchanged. Objects that do not exist are ignored. Errors: those of rebuilding and meshing (with the
/// object's name), E_NO_SURFACE, E_TOO_MANY_TRIANGLES above a million, E_CANCELLED.
Result<ModelFacets> document_facets(const Document& document, std::span<const ObjectId> objects,
                                    const FacetOptions& options, const CancelToken& cancel = {},
                                    const Progress& progress = {});

/// Facets of a file, by the ending of its name. Mesh files (`open_file`) give their polygons as facets,
/// cleaned as usual, and repaired where `reading` says so and they cannot be unfolded otherwise; Bezier
/// patches among them are meshed. All other files are opened as documents (patch files become one), of which
/// the visible objects are used. Warnings: those of opening; W_REPAIRED; W_CAN_BE_OPENED where a repair would
/// help. Errors: as `document_facets`, and those of reading.
Result<ModelFacets> model_facets(const std::filesystem::path& file, const FacetOptions& options,
                                 const Reading& reading = {}, const CancelToken& cancel = {},
                                 const Progress& progress = {});

}  // namespace hariko

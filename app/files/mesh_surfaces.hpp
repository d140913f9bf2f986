#pragma once

// Tessellation of a document's visible objects under tolerances.

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/approximation/approximate.hpp"
#include "core/approximation/error_map.hpp"
#include "core/document/document.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/exchange/write_mesh.hpp"
#include "core/offset/offset_surface.hpp"

namespace hariko {

/// Largest displacement of points in a box of the document by a file's rounding; empty where there is none.
using FileDigits = std::function<double(const Eigen::AlignedBox3d&)>;

/// Rounding of a file of this name and these options that gets all visible objects.
FileDigits file_digits(const Document& document, const std::filesystem::path& path,
                       const WriteOptions& options);

/// Mesh of one object, in the document's space, with its errors in the document's unit.
struct MeshedObject {
  std::string name;
  MeshApproximation result;
  std::optional<MeshErrorMap> errors;  ///< errors where requested; positions are relative to `surface_origin`
  Vector3 surface_origin = Vector3::Zero();
  MeshColour colour = usual_mesh_colour;
  std::vector<Message> warnings = {};  ///< messages of the wall
  /// Part of the tolerance that is left for the file's rounding; nothing where no distance was promised.
  std::optional<double> most_rounding = {};
  /// Part of promised angles that is left for the file's rounding, radians; nothing where none is promised,
  /// or the mesh itself does not keep them.
  std::optional<double> most_turn = {};

  /// Mesh for writing, with the rounding that it allows; borrows from this object.
  NamedTriangles named() const { return {name, &result.mesh, colour, most_rounding, most_turn}; }
  /// Adds the effect of the file's rounding to the errors of the mesh.
  void add(const FileRounding& rounding);
};

/// Tolerances and choices for meshing a document.
struct MeshRequest {
  MeshOptions options;
  bool errors = false;    ///< makes error maps, too
  bool decimate = false;  ///< reduces reference facets under the tolerances; else they stay unchanged
  /// Rounding of the target file: distances hold for the rounded numbers (at least half is left for the
  /// mesh), and so do angles (99 % are left).
  FileDigits digits = {};
  Wall wall = {};  ///< distance and thickness of surfaces, in the document's space
};

/// Meshes of all visible objects: surfaces at quality `final`, and reference facets. Errors: those of
/// rebuilding, `wall_surface`, `approximate` and `decimate`, with the object's name; E_NO_SURFACE where there
/// is nothing to mesh; E_OFFSET_FACETS; E_CANCELLED.
Result<std::vector<MeshedObject>> mesh_surfaces(const Document& document, const MeshRequest& request,
                                                const CancelToken& cancel = {},
                                                const Progress& progress = {});

}  // namespace hariko

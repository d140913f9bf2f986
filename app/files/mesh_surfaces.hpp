#pragma once

// The visible objects of a document as triangles under tolerances.

#include <optional>
#include <string>
#include <vector>

#include "app/files/file_digits.hpp"
#include "core/approximation/approximate.hpp"
#include "core/approximation/error_map.hpp"
#include "core/document/document.hpp"
#include "core/exchange/write_mesh.hpp"

namespace hariko {

/// One object's mesh, placed in the document's space, with its errors in the document's unit.
struct MeshedObject {
  std::string name;
  MeshApproximation result;
  std::optional<MeshErrorMap> errors;  ///< where asked for; places are relative to `surface_origin`
  Vector3 surface_origin = Vector3::Zero();
  MeshColour colour = usual_mesh_colour;
  /// The part of the tolerance that was left for the file's digits; nothing where no distance was promised.
  std::optional<double> most_rounding = {};
  /// The part of promised angles that is left for them, radians; nothing where none is promised, or where the
  /// mesh itself does not keep them.
  std::optional<double> most_turn = {};

  NamedTriangles named() const { return {name, &result.mesh, colour, most_rounding, most_turn}; }
  /// Adds what the digits of the file did to what is known of the mesh.
  void add(const FileRounding& rounding);
};

struct MeshRequest {
  MeshOptions options;
  bool errors = false;    ///< maps the errors too
  bool decimate = false;  ///< reference facets get fewer under the tolerances, else they stay as they are
  /// The digits of the file that the meshes are for: the distance holds for its numbers (at least half is
  /// left for the mesh), and so do angles (99 % are left).
  FileDigits digits = {};
};

/// All that is visible in a document: surfaces at quality `final`, and reference facets. Errors: those of
/// rebuilding, `approximate` and `decimate`, with the object's name; E_NO_SURFACE when there is nothing to
/// mesh; E_CANCELLED.
Result<std::vector<MeshedObject>> mesh_surfaces(const Document& document, const MeshRequest& request,
                                                const CancelToken& cancel = {},
                                                const Progress& progress = {});

}  // namespace hariko

#pragma once

// The surfaces of a document as triangles under tolerances.

#include <optional>
#include <string>
#include <vector>

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
};

struct MeshRequest {
  MeshOptions options;
  bool errors = false;  ///< maps the errors too
  bool meshes = false;  ///< reference meshes are decimated, else left out
};

/// The visible surfaces of a document, each at quality `final`. Errors: those of rebuilding, `approximate`
/// and `decimate`, with the object's name; E_NO_SURFACE when there is nothing to mesh; E_CANCELLED.
Result<std::vector<MeshedObject>> mesh_surfaces(const Document& document, const MeshRequest& request,
                                                const CancelToken& cancel = {},
                                                const Progress& progress = {});

}  // namespace hariko

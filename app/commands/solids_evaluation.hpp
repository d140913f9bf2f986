#pragma once

// Network round solids as JSON, for `hariko evaluate`.

#include <string>

#include "core/base/result.hpp"
#include "core/document/source.hpp"

namespace hariko {

/// JSON with vertices, edges with homogeneous control points, faces with owners, the number of patches, the
/// level of tightness, and whether the solids are enclosed. Surfaces made from a distance field have no edges
/// and faces. Errors: those of `EnvelopeSurfacer::rebuild`.
Result<std::string> solids_json(const SolidsSource& source);

}  // namespace hariko

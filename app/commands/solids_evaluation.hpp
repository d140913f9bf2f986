#pragma once

// `hariko evaluate` of solids: the network round them, as JSON.

#include <string>

#include "core/base/result.hpp"
#include "core/document/source.hpp"

namespace hariko {

/// Vertices, edges with homogeneous control points, faces with owners, the number of patches, level of
/// tightness, and whether the solids are enclosed. On a field's cage there are no edges and faces. Errors:
/// those of `EnvelopeSurfacer::rebuild`.
Result<std::string> solids_json(const SolidsSource& source);

}  // namespace hariko

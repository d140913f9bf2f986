#pragma once

// Numbers of a polyhedron's surface as JSON, for checks against other implementations.

#include <string>

#include "core/document/source.hpp"

namespace hariko {

/// JSON with network tangents, split points, control points, sampled points and normals, and metrics, in
/// absolute coordinates of the object; docs/cli.md describes the members. Errors: those of
/// `PolyhedronSurfacer::rebuild`.
Result<std::string> evaluation_json(const PolyhedronSource& source);

}  // namespace hariko

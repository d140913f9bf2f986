#pragma once

// The numbers of a polyhedron's surface as JSON: for checking against other implementations.

#include <string>

#include "core/document/source.hpp"

namespace hariko {

/// Network tangents, split points, control points, sampled points and normals, and metrics, in absolute
/// coordinates of the object. docs/cli.md describes the members. Errors: those of
/// `PolyhedronSurfacer::rebuild`.
Result<std::string> evaluation_json(const PolyhedronSource& source);

}  // namespace hariko

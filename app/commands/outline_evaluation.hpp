#pragma once

// Control points of an outline as JSON, for checks against other implementations.

#include <string>

#include "core/document/source.hpp"

namespace hariko {

/// JSON with points, normals, support values, curvature, triangles, boundary flags and messages, in absolute
/// coordinates of the object; docs/cli.md describes the members. Errors: those of `control_points`.
Result<std::string> outline_json(const OutlineSource& source);

}  // namespace hariko

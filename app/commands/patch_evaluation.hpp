#pragma once

// Numbers of an object of Bezier patches as JSON, for checks against other implementations.

#include <string>

#include "core/base/result.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// JSON with points, normals and curvatures of each patch at a few parameters, counted as in the file, and
/// with the continuity between patches, in coordinates of the object; docs/cli.md describes the members. The
/// object must consist of patches (asserted). Errors: those of `object_surface`.
Result<std::string> patch_evaluation_json(const Document& document, const Object& object);

}  // namespace hariko

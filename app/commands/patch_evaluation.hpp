#pragma once

// The numbers of an object of Bezier patches as JSON: for checking against other implementations.

#include <string>

#include "core/base/result.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// Points, normals and curvatures of each patch at a few parameters, as the file counts them, and how the
/// patches meet, in coordinates of the object. docs/cli.md describes the members. The object is one of
/// patches (asserted). Errors: those of `object_surface`.
Result<std::string> patch_evaluation_json(const Document& document, const Object& object);

}  // namespace hariko

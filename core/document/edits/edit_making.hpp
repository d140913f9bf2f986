#pragma once

// Edits of how a part is going to be made.

#include "core/document/document.hpp"

namespace hariko {

/// Returns the document with these settings. Errors: E_MAKING_INVALID.
Result<Document> set_making(const Document& document, const MakingSettings& making);

/// Limit of a map in the document's unit, or in degrees; 0 for maps without one.
double limit_of(const Document& document, SurfaceMap map);

}  // namespace hariko

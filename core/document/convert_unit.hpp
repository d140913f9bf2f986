#pragma once

// Conversion of a document to another unit with its real size unchanged.

#include "core/document/document.hpp"

namespace hariko {

/// Multiplies every length by the ratio of the units: positions, origins, translations, basis vectors of
/// pins. Includes locked objects, whose real size and place do not change. To reinterpret the numbers
/// instead, see `set_unit`. Errors: E_NONFINITE where a number leaves the range of doubles,
/// E_VIEW_INVALID where the distance of a saved view leaves its own.
Result<Document> convert_unit(const Document& document, Unit unit);

}  // namespace hariko

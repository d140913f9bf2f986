#pragma once

// Changing the unit of a document so that everything keeps its size.

#include "core/document/document.hpp"

namespace hariko {

/// Multiplies every length by the ratio of the units: positions, origins, translations, basis vectors of
/// pins. Locked objects too: nothing of them changes in the world. To change what the numbers mean instead,
/// see `set_unit`. Errors: E_NONFINITE where a number leaves the range of doubles.
Result<Document> convert_unit(const Document& document, Unit unit);

}  // namespace hariko

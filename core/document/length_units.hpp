#pragma once

// Units of typed lengths.

#include <array>

#include "core/base/text/expression.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// Factors of mm, cm, m, in and the inch sign relative to the given unit.
std::array<UnitFactor, 5> length_units(Unit unit);

}  // namespace hariko

#pragma once

// Units of lengths for what is typed.

#include <array>

#include "core/base/expression.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// mm, cm, m, in and the inch sign, in the given unit.
std::array<UnitFactor, 5> length_units(Unit unit);

}  // namespace hariko

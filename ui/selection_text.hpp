#pragma once

// What is selected, in words that fit the object.

#include <string>

#include "ui/language.hpp"
#include "ui/selection.hpp"

namespace hariko {

/// Of an object with solids "1 solid" or "3 solids", else as `describe` has it. `object` may be null.
std::string describe_in(const Object* object, const ElementSelection& selection, const Language& tr);

}  // namespace hariko

#pragma once

// The job that stands for a skin's search for columns, which is a part of the rebuilding of its surface.

#include "ui/base/language.hpp"

namespace hariko {

inline constexpr const char* placing_columns_job = translatable("Placing columns");

}  // namespace hariko

#pragma once

// Natural order: names as people sort them, "Box 2" before "Box 10".

#include <string_view>

namespace hariko {

/// Natural order of two names, true where `a` comes before `b`: runs of digits by their values, ASCII letters
/// ignoring case, other bytes by their values; ties by all bytes. A strict weak order.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace hariko

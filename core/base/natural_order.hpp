#pragma once

// Natural order: names as people sort them, "Box 2" before "Box 10".

#include <string_view>

namespace hariko {

/// Whether `a` stands before `b`: runs of digits by their values, ASCII letters without regard to case, other
/// bytes by their values; equal ones by their bytes. A strict weak order.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace hariko

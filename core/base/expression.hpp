#pragma once

// Expressions: the numbers that a designer types, with arithmetic and units.

#include <span>
#include <string_view>

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_expression{"E_EXPRESSION"};

/// A unit that may follow a number, and what one of it is in the unit of the result.
struct UnitFactor {
  std::string_view name;  ///< ASCII letters, "°" or a quotation mark
  double factor = 1;
};

inline constexpr std::size_t max_expression_length = 200;

/// The value of an expression: + - * / ^, parentheses, pi, e, sqrt, abs, min, max, round, floor, ceil, and
/// sin, cos, tan of degrees. A unit multiplies all of the term on its left: "1/4in" is a quarter of an inch,
/// "12mm+3" adds three of the result's unit. The decimal sign is the point, whatever the locale. The result
/// is finite. Errors: E_EXPRESSION.
Result<double> evaluate(std::string_view text, std::span<const UnitFactor> units = {});

/// Degrees are the unit of the result.
inline constexpr UnitFactor angle_units[] = {{"deg", 1}, {"°", 1}, {"rad", 57.29577951308232}};

}  // namespace hariko

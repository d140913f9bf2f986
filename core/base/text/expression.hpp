#pragma once

// Expressions: numbers as a designer types them, with arithmetic and units.

#include <span>
#include <string_view>

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_expression{"E_EXPRESSION"};

/// Unit that may follow a number, and its size in the unit of the result.
struct UnitFactor {
  std::string_view name;  ///< ASCII letters, "°" or a quotation mark
  double factor = 1;
};

inline constexpr std::size_t max_expression_length = 200;

/// Value of an expression: + - * / ^, parentheses, pi, e, sqrt, abs, min, max, round, floor, ceil, and sin,
/// cos, tan of degrees. A unit multiplies the whole term on its left: "1/4in" is a quarter of an inch,
/// "12mm+3" adds three of the result's unit. The decimal separator is the point, whatever the locale. The
/// result is finite. Errors: E_EXPRESSION.
Result<double> evaluate(std::string_view text, std::span<const UnitFactor> units = {});

/// Units of angles; the result is in degrees.
inline constexpr UnitFactor angle_units[] = {{"deg", 1}, {"°", 1}, {"rad", 57.29577951308232}};

}  // namespace hariko

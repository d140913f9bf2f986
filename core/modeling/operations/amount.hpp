#pragma once

// Checks of the numbers passed to modeling operations.

#include <cmath>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko::detail {

/// Returns E_BAD_AMOUNT unless the number is finite.
inline Result<Done> check_finite(double amount) {
  if (std::isfinite(amount)) return Done{};
  return make_error(e_bad_amount, "The amount is not a finite number.", "Type an ordinary number.");
}

/// Returns E_BAD_AMOUNT unless the number is finite and greater than zero.
inline Result<Done> check_positive(double amount) {
  if (const auto finite = check_finite(amount); !finite) return finite;
  if (amount > 0) return Done{};
  return make_error(e_bad_amount, "The amount must be greater than zero.", "Use a positive number.");
}

}  // namespace hariko::detail

#pragma once

// Quantities: what the numbers of the panels mean: their unit, how they are written and read, and how fast
// they change. Pure values, no ImGui.

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text/expression.hpp"
#include "core/document/document.hpp"

namespace hariko {

struct Quantity {
  std::string unit;                 ///< shown behind the number; empty for none
  std::vector<UnitFactor> factors;  ///< units that may be typed
  int decimals = 3;                 ///< at the most; zeros at the end are not written
  double step = 0.1;                ///< for one press of an arrow key, or eight pixels of a drag
  bool multiplies = false;          ///< steps are factors: for values that live on a logarithmic scale
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool whole = false;                   ///< whole numbers only
  std::optional<double> standard = {};  ///< value that "Reset to default" sets
};

/// A length in a unit: three decimals after the leading digit of `size`, the size of the model.
Quantity length_quantity(Unit unit, double size);
/// Degrees with one decimal.
Quantity angle_quantity();
/// A number without a unit.
Quantity plain_quantity(int decimals, double step);
/// Whole numbers.
Quantity whole_quantity(int low, int high, int standard);

/// A length that was measured: five digits after its own leading one, so "100 mm", "12.3457 mm".
Quantity measured_length(Unit unit, double length);
/// The same for an area: "12.5 mm²".
Quantity measured_area(Unit unit, double area);

/// "12.5 mm". Never "-0".
std::string format_quantity(const Quantity& quantity, double value);
/// All digits, for copying: reading it back gives the same bits. With the unit.
std::string exact_text(const Quantity& quantity, double value);

/// Change that a number field asks of each value that it stands for.
struct ValueChange {
  enum class Kind { set, add, multiply };
  Kind kind = Kind::set;
  double amount = 0;

  /// The new value, within the bounds of the quantity.
  double apply(const Quantity& quantity, double value) const;
  friend bool operator==(const ValueChange&, const ValueChange&) = default;
};

/// Reads what was typed: an expression sets; "+3" and "+=3" add, "-=3" takes away, "*2", "×2" and "/2"
/// multiply and divide ("-3" alone is a negative number). Errors: E_EXPRESSION.
Result<ValueChange> parse_change(std::string_view text, const Quantity& quantity);

/// A drag or arrow keys by so many steps; Shift makes them ten times finer, Ctrl ten times coarser.
ValueChange stepped(const Quantity& quantity, double steps, bool shift, bool control);

}  // namespace hariko

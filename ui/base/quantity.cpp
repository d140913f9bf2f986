#include "ui/base/quantity.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/document/length_units.hpp"

namespace hariko {

namespace {

std::string fixed(double value, int decimals) {
  char buffer[400];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals).ptr;
  std::string text(buffer, end);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

bool take(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

std::string with_unit(const Quantity& quantity, std::string number) {
  if (quantity.unit.empty()) return number;
  return number + (quantity.unit == "\u00b0" ? "" : " ") + quantity.unit;
}

}  // namespace

Quantity length_quantity(Unit unit, double size) {
  Quantity quantity;
  quantity.unit = to_string(unit);
  const auto factors = length_units(unit);
  quantity.factors.assign(factors.begin(), factors.end());
  const double magnitude = size > 0 && std::isfinite(size) ? std::floor(std::log10(size)) : 0;
  quantity.decimals = static_cast<int>(std::clamp(3 - magnitude, 0.0, 12.0));
  quantity.step = std::pow(10, magnitude - 2);
  return quantity;
}

Quantity measured_length(Unit unit, double length) {
  constexpr double two_more_digits = 0.01;
  return length_quantity(unit, two_more_digits * std::abs(length));
}

Quantity measured_area(Unit unit, double area) {
  Quantity quantity = measured_length(unit, area);
  quantity.unit += "\u00b2";
  quantity.factors.clear();
  return quantity;
}

Quantity angle_quantity() {
  Quantity quantity;
  quantity.unit = "\u00b0";
  quantity.factors.assign(std::begin(angle_units), std::end(angle_units));
  quantity.decimals = 1;
  quantity.step = 1;
  quantity.standard = 0;
  return quantity;
}

Quantity plain_quantity(int decimals, double step) {
  Quantity quantity;
  quantity.decimals = decimals;
  quantity.step = step;
  return quantity;
}

Quantity whole_quantity(int low, int high, int standard) {
  Quantity quantity = plain_quantity(0, 1);
  quantity.whole = true;
  quantity.low = low;
  quantity.high = high;
  quantity.standard = standard;
  return quantity;
}

std::string format_quantity(const Quantity& quantity, double value) {
  return with_unit(quantity, fixed(value, quantity.whole ? 0 : quantity.decimals));
}

std::string exact_text(const Quantity& quantity, double value) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return with_unit(quantity, std::string(buffer, end));
}

double ValueChange::apply(const Quantity& quantity, double value) const {
  double result = kind == Kind::set ? amount : kind == Kind::add ? value + amount : value * amount;
  if (quantity.whole) result = std::round(result);
  return std::clamp(result, quantity.low, quantity.high);
}

Result<ValueChange> parse_change(std::string_view text, const Quantity& quantity) {
  using Kind = ValueChange::Kind;
  while (take(text, " ")) {
  }
  Kind kind = Kind::set;
  double sign = 1;
  bool divides = false;
  if (take(text, "+=") || take(text, "+")) {
    kind = Kind::add;
  } else if (take(text, "-=")) {
    kind = Kind::add;
    sign = -1;
  } else if (take(text, "*=") || take(text, "*") || take(text, "\u00d7")) {
    kind = Kind::multiply;
  } else if (take(text, "/=") || take(text, "/")) {
    kind = Kind::multiply;
    divides = true;
  }
  // A factor has no unit.
  const auto value =
      evaluate(text, kind == Kind::multiply ? std::span<const UnitFactor>() : std::span(quantity.factors));
  if (!value.ok()) return value.error();
  if (divides && *value == 0)
    return make_error(e_expression, "A value cannot be divided by zero.", "Type another number.");
  return ValueChange{kind, divides ? 1 / *value : sign * *value};
}

ValueChange stepped(const Quantity& quantity, double steps, bool shift, bool control) {
  const double speed = (shift ? 0.1 : 1.0) * (control ? 10.0 : 1.0);
  if (quantity.multiplies) return {ValueChange::Kind::multiply, std::pow(1.1, steps * speed)};
  if (quantity.whole) return {ValueChange::Kind::add, std::round(steps * std::max(speed, 1.0))};
  return {ValueChange::Kind::add, steps * speed * quantity.step};
}

}  // namespace hariko

#include "ui/measure/dimension_text.hpp"

#include <cmath>
#include <numbers>

#include "ui/base/quantity.hpp"

namespace hariko {

namespace {

double degrees_of(double radians) {
  return radians * 180 / std::numbers::pi;
}

std::string radii_text(const MeasuredDimension& value, Unit unit, const Language& language) {
  constexpr double alike = 1e-4;
  const double a = value.first_radius, b = value.second_radius;
  if (std::isinf(a)) return language("flat");
  const Quantity length = measured_length(unit, a);
  if (std::isinf(b)) return "R " + format_quantity(length, a) + " / " + language("flat");
  if (std::abs(a - b) <= alike * std::abs(a)) return "R " + format_quantity(length, a);
  Quantity number = length;
  number.unit.clear();
  return "R " + format_quantity(number, a) + " / " + format_quantity(measured_length(unit, b), b);
}

}  // namespace

std::string dimension_text(DimensionKind kind, const MeasuredDimension& value, Unit unit,
                           const Language& language) {
  switch (kind) {
    case DimensionKind::distance:
      return format_quantity(measured_length(unit, value.value), value.value);
    case DimensionKind::angle: {
      Quantity angle = angle_quantity();
      angle.decimals = 2;
      return format_quantity(angle, degrees_of(value.value));
    }
    case DimensionKind::radius:
      break;
  }
  return radii_text(value, unit, language);
}

std::string exact_dimension_text(DimensionKind kind, const MeasuredDimension& value, Unit unit) {
  if (kind == DimensionKind::angle) return exact_text(angle_quantity(), degrees_of(value.value));
  return exact_text(measured_length(unit, value.value), value.value);
}

const char* dimension_name(DimensionKind kind) {
  switch (kind) {
    case DimensionKind::distance:
      return translatable("Distance");
    case DimensionKind::angle:
      return translatable("Angle");
    case DimensionKind::radius:
      break;
  }
  return translatable("Radius");
}

}  // namespace hariko

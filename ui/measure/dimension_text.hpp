#pragma once

// Values of dimensions as they are read: in the document's unit, angles in degrees.

#include <string>

#include "core/modeling/measuring/measured_dimension.hpp"
#include "ui/base/language.hpp"

namespace hariko {

/// "100 mm", "90°", "R 50 mm", "R 50 / -120 mm", "R 50 mm / flat": principal radii, the smaller one first,
/// with a minus where the surface bends the other way; one alone where both are alike.
std::string dimension_text(DimensionKind kind, const MeasuredDimension& value, Unit unit,
                           const Language& language);

/// The same number with all digits and without words, for copying: "100 mm", "90°", "50 mm".
std::string exact_dimension_text(DimensionKind kind, const MeasuredDimension& value, Unit unit);

/// Name of a kind, English: "Distance".
const char* dimension_name(DimensionKind kind);

}  // namespace hariko

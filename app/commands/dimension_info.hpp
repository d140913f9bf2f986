#pragma once

// Report of `hariko info` on the dimensions of a document.

#include <optional>
#include <string>
#include <vector>

#include "core/document/document.hpp"

namespace hariko {

/// A dimension with its value, in the document's unit.
struct DimensionInfo {
  std::string kind;  ///< "distance", "angle", "radius"
  std::optional<double>
      value;  ///< angle: degrees; radius: the smaller one; nothing where it cannot be measured
  /// Radius: both principal radii, negative where the surface bends towards its outside, nothing where it is
  /// flat.
  std::vector<std::optional<double>> radii;
  std::vector<Vector3> points;       ///< places of the anchors; none where there is no value
  std::vector<std::string> anchors;  ///< "vertex 4 of Cube", "(1, 2, 3)"
};

/// Line of a report as text: a label, and the text in a column behind it.
std::string info_line(std::string label, const std::string& text);

/// Measures all dimensions; makes the surfaces that they lie on. Cost: that of these surfaces.
std::vector<DimensionInfo> inspect_dimensions(const Document& document);

/// Report as text: their number, then a line for each. Empty where there are none.
std::string dimensions_text(const std::vector<DimensionInfo>& dimensions, Unit unit);

}  // namespace hariko

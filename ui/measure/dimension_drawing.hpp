#pragma once

// Drawing of dimensions over the picture: thin lines, their ends, and a label with the value.

#include <string>
#include <utility>
#include <vector>

#include "core/modeling/measuring/measured_dimension.hpp"
#include "ui/base/language.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

/// A dimension on the screen; positions are framebuffer pixels.
struct DimensionShape {
  using Line = std::pair<Vector2, Vector2>;
  std::vector<Line> lines;          ///< lines of the value itself
  std::vector<Line> helpers;        ///< from the measured points to these, and to a label that was moved
  std::vector<Line> arrows;         ///< tip of an arrow head, and a point it points away from
  std::vector<Vector2> dots;        ///< measured points
  Vector2 label = Vector2::Zero();  ///< middle of the label
  /// Place of the label unless it was moved, in the document's space: `Dimension::label` counts from here.
  Vector3 natural = Vector3::Zero();
  bool seen = false;  ///< false: partly behind the eye, and not drawn
};

/// `pixel_scale`: framebuffer pixels per design pixel.
DimensionShape shape_of(DimensionKind kind, const MeasuredDimension& value, const Vector3& label,
                        const Projector& projector, double pixel_scale);

/// Corners of the plate of a label round its middle, framebuffer pixels.
std::pair<Vector2, Vector2> label_box(const DimensionShape& shape, const std::string& text,
                                      double pixel_scale);

enum class DimensionLook { plain, hovered, chosen };

/// Draws the lines of a dimension.
void draw_dimension_lines(const ToolOverlay& overlay, const DimensionShape& shape, DimensionLook look);
/// Draws a label; nothing without a text. Labels go over the lines of all dimensions.
void draw_dimension_label(const ToolOverlay& overlay, const DimensionShape& shape, const std::string& text,
                          DimensionLook look);

/// "100 mm", "90°", "R 50 mm", "R 50 / -120 mm", "R 50 mm / flat": principal radii, the smaller one first,
/// with a minus where the surface bends the other way; one alone where both are alike.
std::string dimension_text(DimensionKind kind, const MeasuredDimension& value, Unit unit,
                           const Language& language);

/// The same number with all digits and without words, for copying: "100 mm", "90°", "50 mm".
std::string exact_dimension_text(DimensionKind kind, const MeasuredDimension& value, Unit unit);

/// Name of a kind, English: "Distance".
const char* dimension_name(DimensionKind kind);

}  // namespace hariko

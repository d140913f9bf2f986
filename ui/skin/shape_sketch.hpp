#pragma once

// ShapeSketch: a circle, an ellipse or a rectangle round the middle of a drawing plane, by pointer or
// numbers.

#include <optional>
#include <string>

#include "ui/base/section_shape.hpp"
#include "ui/editor/numeric_input.hpp"
#include "ui/skin/curve_sketch.hpp"

namespace hariko {

class ShapeSketch {
 public:
  bool active() const { return shape_.has_value(); }
  void begin(SectionShape shape, Unit unit);
  void end() { shape_.reset(); }
  /// O a circle, E an ellipse, R a rectangle; then digits, its width and, after Tab, its height. False for
  /// other keys.
  bool key(const KeyPress& press, Unit unit);
  /// The pointer is at its edge or corner, on the grid with `snaps`.
  void follow(const ToolContext& context, const CurveSketch& sketch, const Vector2& pixel, bool snaps);
  /// Makes the shape what was drawn; false while it has no size.
  bool fill(CurveSketch& sketch) const;
  void draw(const ToolContext& context, const ToolOverlay& overlay, const CurveSketch& sketch) const;
  /// "Ellipse 40 × 20 mm", with what is being typed.
  std::string text(const Editor& editor) const;

 private:
  /// Half the width and height that count now.
  Vector2 half() const;

  std::optional<SectionShape> shape_;
  NumericInput input_;
  Vector2 pointed_ = Vector2::Zero();  ///< half the size that the pointer gives
};

}  // namespace hariko

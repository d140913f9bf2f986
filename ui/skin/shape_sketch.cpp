#include "ui/skin/shape_sketch.hpp"

#include <GLFW/glfw3.h>

#include "core/document/length_units.hpp"
#include "ui/view/overlay_drawing.hpp"

namespace hariko {

void ShapeSketch::begin(SectionShape shape, Unit unit) {
  shape_ = shape;
  const auto units = length_units(unit);
  input_ = NumericInput(shape == SectionShape::circle ? 1 : 2, {units.begin(), units.end()});
}

bool ShapeSketch::key(const KeyPress& press, Unit unit) {
  if (active() && input_.key(press)) return true;
  if (press.chord.control || press.chord.alt) return false;
  switch (press.chord.key) {
    case GLFW_KEY_O:
      begin(SectionShape::circle, unit);
      return true;
    case GLFW_KEY_E:
      begin(SectionShape::ellipse, unit);
      return true;
    case GLFW_KEY_R:
      begin(SectionShape::rectangle, unit);
      return true;
    case GLFW_KEY_BACKSPACE:
      if (!active()) return false;
      end();
      return true;
    default:
      return false;
  }
}

void ShapeSketch::follow(const ToolContext& context, const CurveSketch& sketch, const Vector2& pixel,
                         bool snaps) {
  const auto at = sketch.place(context, pixel, snaps);
  if (!at) return;
  const Vector3 local = sketch.axes().transpose() * (*at - sketch.plane().point);
  pointed_ = shape_ == SectionShape::circle ? Vector2::Constant(local.head<2>().norm())
                                            : Vector2(local.head<2>().cwiseAbs());
}

Vector2 ShapeSketch::half() const {
  if (!input_.active()) return pointed_;
  const double width = input_.value(0).value_or(2 * pointed_.x());
  // A width alone is a square or a circle.
  const double height = input_.size() > 1 ? input_.value(1).value_or(width) : width;
  return Vector2(width, height) / 2;
}

bool ShapeSketch::fill(CurveSketch& sketch) const {
  const Vector2 size = half();
  if (!active() || !(size.minCoeff() > 0) || !size.allFinite()) return false;
  ShapePoints shape = shape_points(*shape_, sketch.plane().point, sketch.axes(), size);
  sketch.fill(std::move(shape.points), std::move(shape.sharp), true, true);
  return true;
}

void ShapeSketch::draw(const ToolContext& context, const ToolOverlay& overlay,
                       const CurveSketch& sketch) const {
  CurveSketch shown = sketch;
  if (fill(shown)) draw_curve(context.projector(), overlay, shown.curve(), palette().hot, 2);
}

std::string ShapeSketch::text(const Editor& editor) const {
  if (!active()) return {};
  const Language& tr = editor.language;
  const char* name = *shape_ == SectionShape::circle    ? "Circle"
                     : *shape_ == SectionShape::ellipse ? "Ellipse"
                                                        : "Rectangle";
  const Vector2 size = 2 * half();
  const auto number = [&](std::size_t i) {
    const bool typed =
        input_.active() && i < input_.size() && (!input_.text(i).empty() || i == input_.current());
    return typed ? input_.text(i) + (i == input_.current() ? "|" : "") : length_text(editor, size[int(i)]);
  };
  std::string text = std::string(tr(name)) + "  " + number(0);
  if (*shape_ != SectionShape::circle) text += " \u00d7 " + number(1);
  return text;
}

}  // namespace hariko

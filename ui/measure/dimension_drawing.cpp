#include "ui/measure/dimension_drawing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/base/quantity.hpp"
#include "ui/view/overlay_drawing.hpp"

namespace hariko {

namespace {

// Design pixels.
constexpr double label_beside_line = 16, label_beside_arc = 24, arrow_head_length = 9, least_for_arrows = 34;
constexpr double radius_label_right = 34, radius_label_up = 28;
constexpr double label_margin_x = 6, label_margin_y = 2;
constexpr double arc_share = 0.4;  ///< share of the shorter arm: radius of an angle's arc
constexpr int arc_parts = 24;

/// Adds lines between world points to a shape.
class ShapeMaker {
 public:
  ShapeMaker(const Projector& projector, double pixel_scale) : projector_(projector), scale_(pixel_scale) {
    shape_.seen = true;
  }

  Vector2 pixel(const Vector3& world) {
    const auto at = projector_.project(world);
    if (!at) shape_.seen = false;
    return at ? Vector2(at->head<2>()) : Vector2(Vector2::Zero());
  }
  void line(const Vector3& a, const Vector3& b) { shape_.lines.emplace_back(pixel(a), pixel(b)); }
  void helper(const Vector3& a, const Vector3& b) { shape_.helpers.emplace_back(pixel(a), pixel(b)); }
  void dot(const Vector3& point) { shape_.dots.push_back(pixel(point)); }

  void distance(const Vector3& a, const Vector3& b, const Vector3& label) {
    const Vector3 along = b - a;
    const double square = along.squaredNorm();
    const Vector3 aside = square > 0 ? Vector3(label - along * (label.dot(along) / square)) : label;
    shape_.natural = (a + b) / 2;
    line(a + aside, b + aside);
    if (!aside.isZero(0)) {
      helper(a, a + aside);
      helper(b, b + aside);
    }
    dot(a);
    dot(b);
    const auto [from, to] = shape_.lines.front();
    const double length = (to - from).norm();
    if (length > least_for_arrows * scale_) {
      shape_.arrows.emplace_back(from, to);
      shape_.arrows.emplace_back(to, from);
    }
    Vector2 across = length > 0 ? Vector2(Vector2(to.y() - from.y(), from.x() - to.x()) / length)
                                : Vector2(Vector2(0, -1));
    if (across.y() > 0) across = -across;
    place_label(label, (from + to) / 2 + label_beside_line * scale_ * across);
  }

  void angle(const Vector3& first, const Vector3& corner, const Vector3& second, double radians,
             const Vector3& label) {
    const Vector3 u = first - corner, v = second - corner;
    const double radius = arc_share * std::min(u.norm(), v.norm());
    const Vector3 e1 = u.normalized();
    Vector3 e2 = v - e1 * v.dot(e1);
    e2 = e2.norm() > 1e-9 * v.norm() ? Vector3(e2.normalized()) : Vector3(e1.unitOrthogonal());
    const auto at = [&](double turn) -> Vector3 {
      return corner + radius * (std::cos(turn) * e1 + std::sin(turn) * e2);
    };
    for (int i = 0; i < arc_parts; ++i) line(at(radians * i / arc_parts), at(radians * (i + 1) / arc_parts));
    helper(corner, first);
    helper(corner, second);
    for (const Vector3& point : {first, corner, second}) dot(point);
    shape_.natural = at(radians / 2);
    const Vector2 middle = pixel(shape_.natural), outward = middle - pixel(corner);
    const double length = outward.norm();
    place_label(label, length > 0 ? Vector2(middle + label_beside_arc * scale_ / length * outward) : middle);
  }

  void radius(const Vector3& point, const Vector3& label) {
    shape_.natural = point;
    dot(point);
    const Vector2 at = pixel(point);
    place_label(label, at + scale_ * Vector2(radius_label_right, -radius_label_up));
    shape_.lines.emplace_back(at, shape_.label);
  }

  DimensionShape take() { return std::move(shape_); }

 private:
  void place_label(const Vector3& label, const Vector2& by_itself) {
    shape_.label = label.isZero(0) ? by_itself : pixel(shape_.natural + label);
  }

  const Projector& projector_;
  double scale_;
  DimensionShape shape_;
};

/// Framebuffer pixels per design pixel.
double pixel_scale_of(const ToolOverlay& overlay) {
  return double(overlay.metrics.scale) * double(ImGui::GetIO().DisplayFramebufferScale.x);
}

ImU32 colour_of_look(DimensionLook look) {
  switch (look) {
    case DimensionLook::hovered:
      return palette().hot;
    case DimensionLook::chosen:
      return palette().accent;
    case DimensionLook::plain:
      break;
  }
  return palette().text;
}

/// Draws a line with a seam of the window's colour, so that it shows on light and on dark surfaces.
void draw_seamed_line(const ToolOverlay& overlay, const DimensionShape::Line& line, ImU32 colour,
                      float width) {
  const ImVec2 from = on_screen(overlay, line.first), to = on_screen(overlay, line.second);
  overlay.list.AddLine(from, to, with_alpha(palette().window, 0.6F), width + overlay.metrics.px(1.8F));
  overlay.list.AddLine(from, to, colour, width);
}

void draw_arrow_head(const ToolOverlay& overlay, const DimensionShape::Line& arrow, ImU32 colour) {
  const Vector2 back =
      (arrow.second - arrow.first).normalized() * arrow_head_length * pixel_scale_of(overlay);
  const Vector2 across(-0.3 * back.y(), 0.3 * back.x());
  overlay.list.AddTriangleFilled(on_screen(overlay, arrow.first),
                                 on_screen(overlay, arrow.first + back + across),
                                 on_screen(overlay, arrow.first + back - across), colour);
}

}  // namespace

DimensionShape shape_of(DimensionKind kind, const MeasuredDimension& value, const Vector3& label,
                        const Projector& projector, double pixel_scale) {
  ShapeMaker maker(projector, pixel_scale);
  const auto& points = value.points;
  switch (kind) {
    case DimensionKind::distance:
      maker.distance(points[0], points[1], label);
      break;
    case DimensionKind::angle:
      maker.angle(points[0], points[1], points[2], value.value, label);
      break;
    case DimensionKind::radius:
      maker.radius(points[0], label);
      break;
  }
  return maker.take();
}

std::pair<Vector2, Vector2> label_box(const DimensionShape& shape, const std::string& text,
                                      double pixel_scale) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str()), scale = ImGui::GetIO().DisplayFramebufferScale;
  const Vector2 half = Vector2(double(size.x) * double(scale.x), double(size.y) * double(scale.y)) / 2 +
                       pixel_scale * Vector2(label_margin_x, label_margin_y);
  return {shape.label - half, shape.label + half};
}

void draw_dimension_lines(const ToolOverlay& overlay, const DimensionShape& shape, DimensionLook look) {
  if (!shape.seen) return;
  const Metrics& m = overlay.metrics;
  const ImU32 colour = colour_of_look(look);
  const float width = m.px(look == DimensionLook::plain ? 1.2F : 2);
  for (const auto& line : shape.helpers)
    draw_seamed_line(overlay, line, with_alpha(colour, 0.6F), m.px(0.8F));
  for (const auto& line : shape.lines) draw_seamed_line(overlay, line, colour, width);
  for (const auto& arrow : shape.arrows) draw_arrow_head(overlay, arrow, colour);
  for (const Vector2& dot : shape.dots) {
    const ImVec2 at = on_screen(overlay, dot);
    overlay.list.AddCircleFilled(at, m.px(3.4F), with_alpha(palette().window, 0.6F));
    overlay.list.AddCircleFilled(at, m.px(2.4F), colour);
  }
}

void draw_dimension_label(const ToolOverlay& overlay, const DimensionShape& shape, const std::string& text,
                          DimensionLook look) {
  if (!shape.seen || text.empty()) return;
  const Metrics& m = overlay.metrics;
  const ImU32 colour = colour_of_look(look);
  const auto [from, to] = label_box(shape, text, pixel_scale_of(overlay));
  const ImVec2 low = on_screen(overlay, from), high = on_screen(overlay, to);
  overlay.list.AddRectFilled(low, high, with_alpha(palette().popup, 0.92F), m.px(4));
  if (look != DimensionLook::plain) overlay.list.AddRect(low, high, colour, m.px(4), 0, m.px(1));
  overlay.list.AddText({low.x + m.px(float(label_margin_x)), low.y + m.px(float(label_margin_y))}, colour,
                       text.c_str());
}

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
  return name_among(kind, {"Distance", "Angle", "Radius"});
}

}  // namespace hariko

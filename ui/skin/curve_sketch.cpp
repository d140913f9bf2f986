#include "ui/skin/curve_sketch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/document/length_units.hpp"
#include "core/skinning/edit/freehand_curve.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/snapping.hpp"

namespace hariko {

namespace {

constexpr double axis_radius = 6;           ///< design pixels within which an axis attracts
constexpr double close_radius = 12;         ///< design pixels round the first point
constexpr double stroke_length = 16;        ///< design pixels from which on a press is a stroke
constexpr double stroke_tolerance = 2.5;    ///< design pixels
constexpr double least_plane_slope = 0.05;  ///< slope of a ray against the plane
constexpr int per_span = 12;

constexpr Code e_off_plane{"E_OFF_PLANE"};

Message off_plane() {
  return make_error(e_off_plane, "The plane is seen from its edge here.", "Turn the view.");
}

}  // namespace

void draw_curve(const Projector& projector, const ToolOverlay& overlay, const SubdivisionCurve& curve,
                ImU32 colour, float width) {
  const int count = per_span * curve.spans();
  std::vector<Vector3> points;
  for (int i = 0; i <= count && count > 0; ++i) points.push_back(evaluate(curve, double(i) / count).position);
  draw_polyline(overlay, projector, points, colour, width);
}

std::optional<Message> CurveSketch::feed(const ToolContext& context, const PointerEvent& event) {
  pointer_ = event.pixel;
  snaps_ = snaps_now(context.editor, event.control);
  if (event.kind == PointerEvent::Kind::press) {
    stroke_ = {event.pixel};
    return {};
  }
  if (stroke_.empty()) return {};
  if (event.kind == PointerEvent::Kind::move) {
    if (event.pixel != stroke_.back()) stroke_.push_back(event.pixel);
    return {};
  }
  double length = 0;
  for (std::size_t i = 1; i < stroke_.size(); ++i) length += (stroke_[i] - stroke_[i - 1]).norm();
  const Vector2 first = stroke_.front();
  const bool stroke = length > stroke_length * context.editor.pixel_scale && !closed_;
  auto error = stroke ? add_stroke(context) : add_point(context, first, snaps_);
  stroke_.clear();
  return error;
}

void CurveSketch::fill(std::vector<Vector3> points, std::vector<char> sharp, bool closed, bool through) {
  points_ = std::move(points);
  sharp_ = std::move(sharp);
  sharp_.resize(points_.size(), 0);
  closed_ = closed;
  through_ = through;
  stroke_.clear();
}

std::optional<Message> CurveSketch::add_point(const ToolContext& context, const Vector2& pixel, bool snaps) {
  if (closed_) return {};
  if (size() >= 3 && at_first(context, pixel)) {
    closed_ = true;
    return {};
  }
  const auto at = place(context, pixel, snaps);
  if (!at) return off_plane();
  if (!points_.empty() && (*at - points_.back()).norm() == 0) return {};
  points_.push_back(*at);
  sharp_.push_back(0);
  return {};
}

std::optional<Message> CurveSketch::add_stroke(const ToolContext& context) {
  const Projector projector = context.projector();
  const double scale = context.editor.pixel_scale;
  const bool closes = points_.empty() && (stroke_.front() - stroke_.back()).norm() < close_radius * scale;
  std::vector<Vector3> line;
  for (const Vector2& pixel : stroke_) {
    const auto at = on_plane(projector, pixel);
    if (!at) return off_plane();
    line.push_back(*at);
  }
  const double tolerance = stroke_tolerance * scale * projector.pixel_length_at(line[line.size() / 2]);
  const auto curve = freehand_curve(line, closes, tolerance);
  if (!curve) return curve.error();
  const std::vector<Vector3> limits = limit_points(*curve);
  for (int i = 0; i < curve->size(); ++i) {
    points_.push_back(through_ ? limits[std::size_t(i)] : curve->points[std::size_t(i)]);
    sharp_.push_back(curve->is_sharp(i));
  }
  closed_ = closes;
  return {};
}

bool CurveSketch::key(const KeyPress& press) {
  if (press.chord.control || press.chord.alt) return false;
  switch (press.chord.key) {
    case Key::backspace:
      if (closed_)
        closed_ = false;
      else if (!points_.empty())
        points_.pop_back(), sharp_.pop_back();
      return true;
    case Key::c:
      closed_ = !closed_ && size() >= 3;
      return true;
    case Key::p:
      through_ = !through_;
      return true;
    default:
      return false;
  }
}

SubdivisionCurve CurveSketch::curve_of(const std::vector<Vector3>& points, std::vector<char> sharp,
                                       bool closed) const {
  if (std::ranges::none_of(sharp, [](char s) { return s != 0; })) sharp.clear();
  if (through_ && points.size() >= (closed ? 3U : 2U)) return curve_through(points, closed, std::move(sharp));
  return {points, closed, std::move(sharp)};
}

std::optional<Vector3> CurveSketch::on_plane(const Projector& projector, const Vector2& pixel) const {
  const Ray ray = projector.ray(pixel);
  const double slope = plane_.normal.dot(ray.direction);
  if (std::abs(slope) < least_plane_slope) return {};
  const double t = plane_.normal.dot(plane_.point - ray.origin) / slope;
  if (!(t > 0)) return {};
  return ray.at(t);
}

std::optional<SnapTarget> CurveSketch::caught(const ToolContext& context, const Vector2& pixel) const {
  const auto from = points_.empty() || closed_ ? std::nullopt : std::optional(points_.back());
  return catcher_.find(context, pixel, from, plane_.normal);
}

std::optional<Vector3> CurveSketch::place(const ToolContext& context, const Vector2& pixel,
                                          bool snaps) const {
  const Projector projector = context.projector();
  const auto target = snaps ? caught(context, pixel) : std::nullopt;
  const auto at = target ? std::optional(target->point) : on_plane(projector, pixel);
  if (!at) return at;
  const Matrix3 axes = this->axes();
  Vector3 local = axes.transpose() * (*at - plane_.point);
  if (target) {
    // Its foot in the plane.
  } else if (snaps && context.editor.settings.snaps.grid) {
    const DecimalStep step = grid_step(context, plane_.point);
    for (int i = 0; i < 2; ++i) local[i] = step.nearest(local[i]);
  } else {
    const double reach = axis_radius * context.editor.pixel_scale * projector.pixel_length_at(*at);
    for (int i = 0; i < 2; ++i)
      if (std::abs(local[i]) < reach) local[i] = 0;
  }
  local.z() = 0;
  return plane_.point + axes * local;
}

bool CurveSketch::at_first(const ToolContext& context, const Vector2& pixel) const {
  if (points_.empty()) return false;
  const auto first = context.projector().project(points_.front());
  return first && (first->head<2>() - pixel).norm() < close_radius * context.editor.pixel_scale;
}

void CurveSketch::draw(const ToolContext& context, const ToolOverlay& overlay) const {
  const Projector projector = context.projector();
  std::vector<Vector3> points = points_;
  std::vector<char> sharp = sharp_;
  bool closed = closed_;
  const bool ends = !closed && size() >= 3 && at_first(context, pointer_);
  if (ends) {
    closed = true;
  } else if (!closed && stroke_.empty()) {
    const auto next = place(context, pointer_, snaps_);
    if (next && (points.empty() || *next != points.back())) points.push_back(*next), sharp.push_back(0);
  }
  if (points.size() >= 2) draw_curve(projector, overlay, curve_of(points, sharp, closed), palette().hot, 2);
  for (std::size_t i = 0; i + 1 < stroke_.size(); ++i)
    overlay.list.AddLine(on_screen(overlay, stroke_[i]), on_screen(overlay, stroke_[i + 1]), palette().hot,
                         overlay.metrics.px(2));
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto at = projector.project(points_[i]);
    if (!at) continue;
    const bool first = i == 0 && ends;
    const ImVec2 p = on_screen(overlay, at->head<2>());
    overlay.list.AddCircleFilled(p, overlay.metrics.px(first ? 7 : 5), palette().window);
    overlay.list.AddCircleFilled(p, overlay.metrics.px(first ? 5.5F : 3.5F), palette().hot);
  }
}

void ShapeSketch::begin(SectionShape shape, Unit unit) {
  shape_ = shape;
  const auto units = length_units(unit);
  input_ = NumericInput(shape == SectionShape::circle ? 1 : 2, {units.begin(), units.end()});
}

bool ShapeSketch::key(const KeyPress& press, Unit unit) {
  if (active() && input_.key(press)) return true;
  if (press.chord.control || press.chord.alt) return false;
  switch (press.chord.key) {
    case Key::o:
      begin(SectionShape::circle, unit);
      return true;
    case Key::e:
      begin(SectionShape::ellipse, unit);
      return true;
    case Key::r:
      begin(SectionShape::rectangle, unit);
      return true;
    case Key::backspace:
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

ShapePoints shape_points(SectionShape shape, const Vector3& middle, const Matrix3& axes,
                         const Vector2& half) {
  ShapePoints out;
  const auto add = [&](double x, double y, bool sharp) {
    out.points.push_back(middle + x * axes.col(0) + y * axes.col(1));
    out.sharp.push_back(sharp ? 1 : 0);
  };
  if (shape == SectionShape::rectangle) {
    constexpr std::array<std::array<double, 2>, 4> corners{{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
    for (const auto& corner : corners) add(corner[0] * half.x(), corner[1] * half.y(), true);
    return out;
  }
  // Through so many points a cubic curve is round to a ten thousandth.
  constexpr int count = 8;
  const double height = shape == SectionShape::circle ? half.x() : half.y();
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    add(half.x() * std::cos(angle), height * std::sin(angle), false);
  }
  return out;
}

}  // namespace hariko

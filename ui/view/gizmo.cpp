#include "ui/view/gizmo.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/polygon.hpp"
#include "core/skinning/edit/stroke.hpp"
#include "ui/view/overlay_drawing.hpp"

namespace hariko {

namespace {

// Design pixels from the pivot.
constexpr double arrow_begin = 20, arrow_end = 92, arrow_head = 13, scale_box = 112, ring_radius = 76;
constexpr double square_begin = 24, square_end = 38;
/// An axis whose 100 pixels look shorter than this points at the viewer.
constexpr double least_length = 22;

std::string name_of(const GizmoHandle& handle) {
  const char* kind = handle.kind == TransformKind::move     ? "move."
                     : handle.kind == TransformKind::rotate ? "rotate."
                                                            : "scale.";
  std::string axes;
  for (int i = 0; i < 3; ++i)
    if ((i == handle.lock.axis) == (handle.lock.kind == AxisLock::Kind::axis)) axes += "xyz"[i];
  return std::string("gizmo.") + kind + axes;
}

}  // namespace

void Gizmo::update(const Editor& editor, bool busy) {
  shapes_.clear();
  plane_.clear();
  plane_axes_.clear();
  if (busy || editor.view.surfaces_only || !editor.transform.gizmo || !editor.has_document ||
      editor.history.in_gesture())
    return;
  const Document& document = editor.document();
  const bool same = known_ && document == document_ && editor.selection == selection_ &&
                    editor.mode == mode_ && editor.transform.pivot == pivot_mode_ &&
                    editor.transform.local_edit == local_edit_;
  if (!same) {
    const TransformTarget target = TransformTarget::of(editor);
    pivot_ = target.empty() ? std::nullopt : std::optional<Vector3>(target.pivot());
    object_frame_ = target.local_frame();
    tangents_ = target.tangents();
    in_planes_ = target.in_planes();
    local_edit_ = editor.transform.local_edit;
    document_ = document;
    selection_ = editor.selection;
    mode_ = editor.mode;
    pivot_mode_ = editor.transform.pivot;
    known_ = true;
  }
  if (pivot_) place(editor);
}

void Gizmo::place(const Editor& editor) {
  const Projector projector(editor.camera(), editor.viewport);
  const auto centre = projector.project(*pivot_);
  if (!centre) return;
  scale_ = editor.pixel_scale;
  const bool local = editor.transform.local_axes || tangents_ || in_planes_;
  if (tangents_) place_plane(projector);
  const Matrix3 frame = local ? object_frame_ : Matrix3(Matrix3::Identity());
  const double pixel = scale_ * projector.pixel_length_at(*pivot_);
  const auto at = [&](const Vector3& design_pixels) -> Vector2 {
    const auto p = projector.project(*pivot_ + pixel * (frame * design_pixels));
    return p ? Vector2(p->head<2>()) : Vector2(centre->head<2>());
  };
  std::array<bool, 3> shown{};
  for (int i = 0; i < 3; ++i) {
    const Vector3 axis = Vector3::Unit(i);
    shown[static_cast<std::size_t>(i)] = (at(100 * axis) - centre->head<2>()).norm() > least_length * scale_;
    if (!shown[static_cast<std::size_t>(i)] || (in_planes_ && i == 2)) continue;
    const AxisLock lock{AxisLock::Kind::axis, i, local};
    shapes_.push_back({{TransformKind::move, lock},
                       {at(arrow_begin * axis), at(arrow_end * axis)},
                       false,
                       at(0.75 * arrow_end * axis)});
    shapes_.push_back({{TransformKind::scale, lock},
                       {at((scale_box - 1) * axis), at((scale_box + 1) * axis)},
                       false,
                       at(scale_box * axis)});
  }
  for (int i = in_planes_ ? 2 : 0; i < 3; ++i) {
    const Vector3 u = Vector3::Unit((i + 1) % 3), v = Vector3::Unit((i + 2) % 3);
    const Vector3 normal = frame.col(i);
    const double slope = std::abs(normal.dot((*pivot_ - editor.camera().eye()).normalized()));
    if (slope > 0.2)
      shapes_.push_back({{TransformKind::move, {AxisLock::Kind::plane, i, local}},
                         {at(square_begin * (u + v)), at(square_end * u + square_begin * v),
                          at(square_end * (u + v)), at(square_begin * u + square_end * v)},
                         true,
                         at(0.5 * (square_begin + square_end) * (u + v))});
    if (slope < 0.1) continue;
    Shape arc{{TransformKind::rotate, {AxisLock::Kind::axis, i, local}}, {}, false, {}};
    constexpr int parts = 20;
    constexpr double first = 12, last = 78;  // degrees: the axes stay free
    for (int k = 0; k <= parts; ++k) {
      const double angle = (first + (last - first) * k / parts) * std::numbers::pi / 180;
      arc.line.push_back(at(ring_radius * (std::cos(angle) * u + std::sin(angle) * v)));
    }
    arc.mark = arc.line[parts / 2];
    shapes_.push_back(std::move(arc));
  }
  leave_out_covered();
}

/// Seen at a slant handles lie over each other: of those whose middle another one has, arrows and boxes stay.
/// Arcs are long: they stay, named at their freest place, where no more than half of them lies over others.
void Gizmo::leave_out_covered() {
  const auto arcs_last = [](const Shape& shape) {
    return shape.handle.lock.kind == AxisLock::Kind::axis && shape.handle.kind != TransformKind::rotate ? 0
           : shape.closed                                                                               ? 1
                                                                                                        : 2;
  };
  std::stable_sort(shapes_.begin(), shapes_.end(),
                   [&](const Shape& a, const Shape& b) { return arcs_last(a) < arcs_last(b); });
  std::vector<Shape> left;
  const double reach = hit_radius * scale_;
  for (Shape& shape : shapes_) {
    const bool arc = shape.handle.kind == TransformKind::rotate;
    const bool free =
        arc ? go_to_freest(shape, left, reach) : std::ranges::none_of(left, [&](const Shape& other) {
          return other.reaches(shape.mark, reach) || shape.reaches(other.mark, reach);
        });
    if (free) left.push_back(std::move(shape));
  }
  shapes_ = std::move(left);
}

bool Gizmo::go_to_freest(Shape& arc, const std::vector<Shape>& others, double reach) {
  const auto room = [&](const Vector2& pixel) {
    double least = 2 * reach;  // more is no better
    for (const Shape& other : others) least = std::min(least, other.distance(pixel));
    return least;
  };
  const std::size_t middle = arc.line.size() / 2;
  std::size_t free = 0;
  double most = 0;
  // From the middle to both ends: of places that are as free the middle one counts.
  for (std::size_t step = 0; step < arc.line.size(); ++step) {
    const std::size_t half = (step + 1) / 2, k = step % 2 == 1 ? middle - half : middle + half;
    const double here = room(arc.line[k]);
    free += here >= reach ? 1 : 0;
    if (here > most) most = here, arc.mark = arc.line[k];
  }
  return 2 * free >= arc.line.size();
}

double Gizmo::Shape::distance(const Vector2& pixel) const {
  if (closed && inside_polygon(line, pixel)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    least = std::min(least, foot_on_segment(line[i], line[i + 1], pixel).distance);
  return least;
}

bool Gizmo::Shape::reaches(const Vector2& pixel, double radius) const {
  return distance(pixel) < radius;
}

void Gizmo::place_plane(const Projector& projector) {
  const auto& [first, second] = *tangents_;
  constexpr int parts = 48;
  for (int k = 0; k < parts; ++k) {
    const double angle = 2 * std::numbers::pi * k / parts;
    const auto p = projector.project(*pivot_ + std::cos(angle) * first + std::sin(angle) * second);
    if (!p) return plane_.clear();
    plane_.push_back(p->head<2>());
  }
  for (const Vector3& to : {Vector3(*pivot_), Vector3(*pivot_ + first), Vector3(*pivot_ + second)})
    if (const auto p = projector.project(to)) plane_axes_.push_back(p->head<2>());
}

std::optional<GizmoHandle> Gizmo::hit(const Vector2& pixel) const {
  // Arcs are long: they give way to the small handles that lie over them.
  const auto small = nearest(pixel, false);
  return small ? small : nearest(pixel, true);
}

std::optional<GizmoHandle> Gizmo::nearest(const Vector2& pixel, bool arcs) const {
  std::optional<GizmoHandle> best;
  double least = hit_radius * scale_;
  for (const Shape& shape : shapes_) {
    if ((shape.handle.kind == TransformKind::rotate) != arcs) continue;
    // Seen at a slant squares reach under arrows: the line itself wins there.
    if (const double within = hit_radius / 2 * scale_;
        shape.closed && within < least && inside_polygon(shape.line, pixel)) {
      least = within;
      best = shape.handle;
    }
    for (std::size_t i = 0; i + 1 < shape.line.size(); ++i) {
      const double distance = foot_on_segment(shape.line[i], shape.line[i + 1], pixel).distance;
      if (distance >= least) continue;
      least = distance;
      best = shape.handle;
    }
  }
  return best;
}

bool Gizmo::hover(const ToolContext&, const Vector2& pixel) {
  hot_ = hit(pixel);
  return hot_.has_value();
}

std::optional<std::unique_ptr<Tool>> Gizmo::press(const ToolContext&, const PointerEvent& press) {
  const auto handle = press.plain_left() ? hit(press.pixel) : std::nullopt;
  if (!handle) return {};
  return make_transform_tool(handle->kind, DrivenBy::handle, handle->lock);
}

const char* Gizmo::hint() const {
  return hot_ ? translatable("Drag the handle   click to type a number") : nullptr;
}

void Gizmo::draw(const ToolContext&, const LayerPane& pane) {
  if (!pane.active) return;
  draw_plane(pane.overlay);
  for (const Shape& shape : shapes_) draw_shape(pane.overlay, shape);
  mark(pane.marks, pane.overlay);
}

/// The tangent plane of a local edit with its two tangents.
void Gizmo::draw_plane(const ToolOverlay& overlay) const {
  if (plane_.empty()) return;
  ImDrawList& list = overlay.list;
  const Metrics& m = overlay.metrics;
  std::vector<ImVec2> disc;
  for (const Vector2& point : plane_) disc.push_back(on_screen(overlay, point));
  const int count = static_cast<int>(disc.size());
  list.AddConvexPolyFilled(disc.data(), count, with_alpha(palette().hot, 0.18F));
  list.AddPolyline(disc.data(), count, palette().hot, ImDrawFlags_Closed, m.px(1.5F));
  for (std::size_t i = 1; i < plane_axes_.size(); ++i)
    list.AddLine(on_screen(overlay, plane_axes_[0]), on_screen(overlay, plane_axes_[i]), palette().hot,
                 m.px(2));
}

void Gizmo::draw_shape(const ToolOverlay& overlay, const Shape& shape) const {
  ImDrawList& list = overlay.list;
  const Metrics& m = overlay.metrics;
  const bool lit = hot_ == shape.handle;
  const ImU32 colour = lit ? palette().hot : axis_colour(shape.handle.lock.axis);
  const float width = m.px(lit ? 3.5F : 2.5F);
  std::vector<ImVec2> line;
  for (const Vector2& point : shape.line) line.push_back(on_screen(overlay, point));
  const int count = static_cast<int>(line.size());
  if (shape.closed) {
    list.AddConvexPolyFilled(line.data(), count, (colour & 0x00ffffff) | (0x70U << IM_COL32_A_SHIFT));
    list.AddPolyline(line.data(), count, colour, ImDrawFlags_Closed, m.px(1.2F));
  } else if (shape.handle.kind == TransformKind::rotate) {
    list.AddPolyline(line.data(), count, colour, 0, width);
  } else if (shape.handle.kind == TransformKind::scale) {
    const ImVec2 c = on_screen(overlay, shape.mark);
    const float r = m.px(lit ? 6 : 5);
    list.AddRectFilled({c.x - r, c.y - r}, {c.x + r, c.y + r}, colour, m.px(1));
  } else {
    const Vector2 tip = shape.line[1], way = (tip - shape.line[0]).normalized() * arrow_head * scale_;
    const Vector2 across(-way.y() * 0.42, way.x() * 0.42);
    list.AddLine(line[0], line[1], colour, width);
    list.AddTriangleFilled(on_screen(overlay, tip + way * 0.35),
                           on_screen(overlay, tip - way * 0.65 + across),
                           on_screen(overlay, tip - way * 0.65 - across), colour);
  }
}

void Gizmo::mark(Marks& marks, const ToolOverlay& overlay) const {
  for (const Shape& shape : shapes_) {
    const ImVec2 c = on_screen(overlay, shape.mark);
    marks.rect(name_of(shape.handle), {c.x - 2, c.y - 2}, {c.x + 2, c.y + 2});
  }
}

}  // namespace hariko

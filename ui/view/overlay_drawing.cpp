#include "ui/view/overlay_drawing.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "ui/view/snapping.hpp"

namespace hariko {

ImVec2 on_screen(const ToolOverlay& overlay, const Vector2& pixel) {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  return {overlay.corner.x + static_cast<float>(pixel.x()) / scale.x,
          overlay.corner.y + static_cast<float>(pixel.y()) / scale.y};
}

void draw_value_label(const ToolOverlay& overlay, const Vector2& beside, const std::string& text,
                      bool warning) {
  if (text.empty()) return;
  const Metrics& m = overlay.metrics;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 low = overlay.list.GetClipRectMin(), high = overlay.list.GetClipRectMax();
  const ImVec2 padding(m.px(8), m.px(4));
  ImVec2 at = on_screen(overlay, beside);
  at.x = std::clamp(at.x + m.px(18), low.x + m.px(4),
                    std::max(low.x, high.x - size.x - 2 * padding.x - m.px(4)));
  at.y = std::clamp(at.y + m.px(16), low.y + m.px(4),
                    std::max(low.y, high.y - size.y - 2 * padding.y - m.px(4)));
  overlay.list.AddRectFilled(at, {at.x + size.x + 2 * padding.x, at.y + size.y + 2 * padding.y},
                             with_alpha(palette().popup, 0.9F), m.px(4));
  overlay.list.AddText({at.x + padding.x, at.y + padding.y}, warning ? palette().warning : palette().text,
                       text.c_str());
}

void draw_axis_line(const ToolOverlay& overlay, const Projector& projector, const Vector3& through,
                    const Vector3& direction, ImU32 colour) {
  const auto middle = projector.project(through);
  if (!middle) return;
  for (const double sign : {-1.0, 1.0}) {
    // The farthest point in front of the eye.
    double reach = 20 * projector.camera().distance;
    std::optional<Vector3> end;
    for (int i = 0; i < 24 && !end; ++i, reach /= 2)
      end = projector.project(through + sign * reach * direction);
    if (!end) continue;
    // Far beyond the window ImGui's single precision would make the line tremble.
    Vector2 way = end->head<2>() - middle->head<2>();
    const double length = way.norm(), most = 4000;
    if (length > most) way *= most / length;
    overlay.list.AddLine(on_screen(overlay, middle->head<2>()), on_screen(overlay, middle->head<2>() + way),
                         colour, overlay.metrics.px(1.5F));
  }
}

void draw_polyline(const ToolOverlay& overlay, const Projector& projector, std::span<const Vector3> points,
                   ImU32 colour, float width) {
  std::optional<ImVec2> last;
  for (const Vector3& point : points) {
    const auto pixel = projector.project(point);
    const auto at = pixel ? std::optional(on_screen(overlay, pixel->head<2>())) : std::nullopt;
    if (at && last) overlay.list.AddLine(*last, *at, colour, overlay.metrics.px(width));
    last = at;
  }
}

void draw_dashed_line(const ToolOverlay& overlay, const Vector2& from, const Vector2& to, ImU32 colour) {
  const double length = (to - from).norm(), dash = overlay.metrics.px(6);
  if (!(length > 1) || length > 1e5) return;
  const Vector2 unit = (to - from) / length;
  for (double at = 0; at < length; at += 2 * dash)
    overlay.list.AddLine(on_screen(overlay, from + at * unit),
                         on_screen(overlay, from + std::min(at + dash, length) * unit), colour,
                         overlay.metrics.px(1.2F));
}

std::string fixed_text(double value, int decimals) {
  if (!(std::abs(value) < 1e9)) return format_number(value, 6);
  std::array<char, 64> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  std::string text(buffer.data(), end.ptr);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string length_text(const Editor& editor, double length) {
  const double size = std::max(1e-12, editor.camera().view_height());
  const int decimals = std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 9);
  return fixed_text(length, decimals) + " " + std::string(to_string(editor.document().unit));
}

namespace {

constexpr int lines_each_way = 60;

/// A step whose lines are far enough from each other to be read, and how many make a stronger line.
double line_step(const ToolContext& context, const Vector3& point) {
  return grid_step(context, point).size();
}

void draw_line(const ToolOverlay& overlay, const Projector& projector, const Vector3& from, const Vector3& to,
               ImU32 colour, float width) {
  const auto a = projector.project(from), b = projector.project(to);
  if (!a || !b) return;
  overlay.list.AddLine(on_screen(overlay, a->head<2>()), on_screen(overlay, b->head<2>()), colour, width);
}

}  // namespace

void draw_plane_grid(const ToolContext& context, const ToolOverlay& overlay, const Vector3& point,
                     const Matrix3& axes) {
  const Projector projector = context.projector();
  const double step = line_step(context, point);
  const double reach = lines_each_way * step;
  const float thin = overlay.metrics.px(1);
  for (int axis = 0; axis < 2; ++axis) {
    const Vector3 along = reach * axes.col(axis), across = step * axes.col(1 - axis);
    for (int i = -lines_each_way; i <= lines_each_way; ++i) {
      if (i == 0) continue;
      const Vector3 middle = point + i * across;
      draw_line(overlay, projector, middle - along, middle + along,
                with_alpha(palette().dim_text, i % 10 == 0 ? 0.45F : 0.16F), thin);
    }
  }
  for (int axis = 0; axis < 2; ++axis)
    draw_axis_line(overlay, projector, point, axes.col(axis), axis_colour(axis, 190));
  // Lengths at the stronger lines.
  for (int axis = 0; axis < 2; ++axis)
    for (int i = -lines_each_way; i <= lines_each_way; i += 10) {
      if (i == 0) continue;
      const auto at = projector.project(point + i * step * axes.col(axis));
      if (!at) continue;
      ImVec2 place = on_screen(overlay, at->head<2>());
      place.x += overlay.metrics.px(3), place.y += overlay.metrics.px(2);
      overlay.list.AddText(place, palette().dim_text, length_text(context.editor, i * step).c_str());
    }
}

}  // namespace hariko

#include "ui/view/overlay_drawing.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace hariko {

ImU32 axis_colour(int axis, unsigned alpha) {
  switch (axis) {
    case 0:
      return IM_COL32(0xe5, 0x48, 0x4d, alpha);
    case 1:
      return IM_COL32(0x46, 0xa7, 0x58, alpha);
    default:
      return IM_COL32(0x3e, 0x82, 0xf7, alpha);
  }
}

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

}  // namespace hariko

#include "ui/widgets/beside.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ui/widgets/items.hpp"

namespace hariko {

namespace {

constexpr float view_border = 5, least_width = 260;  // design pixels

}  // namespace

PanelRect draw_beside(PanelContext& context, const PanelRect& view, const char* mark, float& split,
                      const std::function<void(const PanelRect&)>& draw) {
  const float least = std::min(context.metrics.px(least_width), view.width() / 2);
  const float x =
      std::clamp(std::round(view.min.x + split * view.width()), view.min.x + least, view.max.x - least);
  draw({{x, view.min.y}, view.max});
  const float left = x - context.metrics.px(view_border);
  if (begin_panel((std::string("##") + mark).c_str(), {{left, view.min.y}, {x, view.max.y}}, 0, {0, 0},
                  ImGuiWindowFlags_NoBackground)) {
    if (border_area(context.marks, mark, {x - left, view.height()}, ImGuiMouseCursor_ResizeEW))
      split = std::clamp((ImGui::GetIO().MousePos.x - view.min.x) / view.width(), 0.15F, 0.85F);
  }
  ImGui::End();
  return {view.min, {left, view.max.y}};
}

}  // namespace hariko

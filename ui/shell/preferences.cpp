#include "ui/shell/preferences.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "ui/shell/preference_rows.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"

namespace hariko {

namespace {

constexpr float pages_width = 150;

/// Round the cross of the window, which Dear ImGui leaves without the ring of the keyboard.
void ring_of_cross() {
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  const ImGuiID cross = window->GetID("#CLOSE");
  if (GImGui->NavId == cross)
    ImGui::RenderNavHighlight(ImGui::WindowRectRelToAbs(window, window->NavRectRel[GImGui->NavLayer]), cross);
}

}  // namespace

void Preferences::close() {
  open_ = false;
  keys_.stop();
}

void Preferences::draw(PanelContext& context, float top) {
  if (!open_) return;
  const Metrics& m = context.metrics;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size(std::min(m.px(760), screen.x - m.px(32)), std::min(m.px(520), screen.y - top - m.px(32)));
  const ImVec2 most(screen.x - size.x, screen.y - size.y);
  ImGui::SetNextWindowSize(size);
  const std::string name = std::string(context.tr("Preferences")) + "###preferences";
  // The place where it was put, as far as that is inside of the window, which may have become smaller, or the
  // interface larger.
  const ImGuiWindow* window = ImGui::FindWindowByName(name.c_str());
  if (window && window->WasActive)
    ImGui::SetNextWindowPos({std::clamp(window->Pos.x, 0.0F, std::max(0.0F, most.x)),
                             std::clamp(window->Pos.y, top, std::max(top, most.y))});
  else
    ImGui::SetNextWindowPos({most.x / 2, (most.y + top) / 2});
  if (focus_) ImGui::SetNextWindowFocus();
  focus_ = false;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, m.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, m.px(1));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().popup);
  bool stays = true;
  const bool drawn = ImGui::Begin(name.c_str(), &stays,
                                  ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollbar |
                                      ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  context.marks.window("preferences");
  ring_of_cross();
  if (drawn) {
    constexpr float share_of_pages = 0.38F;
    if (ImGui::BeginChild("pages", {std::min(m.px(pages_width), share_of_pages * size.x), 0}, false,
                          ImGuiWindowFlags_NavFlattened))
      draw_pages(context);
    ImGui::EndChild();
    ImGui::SameLine(0, m.px(16));
    if (ImGui::BeginChild("page", {0, 0}, false, ImGuiWindowFlags_NavFlattened)) draw_page(context);
    ImGui::EndChild();
  }
  ImGui::End();
  if (!stays) close();
}

void Preferences::draw_pages(PanelContext& context) {
  const std::array<std::tuple<Page, const char*, const char*>, 6> pages{{
      {Page::interface, translatable("Interface"), "interface"},
      {Page::navigation, translatable("Navigation"), "navigation"},
      {Page::units, translatable("Units"), "units"},
      {Page::files, translatable("Files"), "files"},
      {Page::colours, translatable("Colours"), "colours"},
      {Page::keys, translatable("Keys"), "keys"},
  }};
  const float height = context.metrics.px(30);
  ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, ImVec2(0, 0.5F));
  for (const auto& [page, name, mark] : pages) {
    if (selectable_row(context.marks, std::string("preferences.page.") + mark,
                       std::string("  ") + context.tr(name), page == page_, {0, height})) {
      page_ = page;
      keys_.stop();
    }
  }
  ImGui::PopStyleVar();
  const char* reset = context.tr(page_ == Page::keys ? "Reset all keys" : "Reset this page");
  ImGui::SetCursorPosY(ImGui::GetWindowHeight() - ImGui::GetFrameHeight());
  if (!text_button(context.marks, "preferences.reset", reset, -1)) return;
  reset_preferences(context.editor.settings, page_);
  keys_.stop();
}

void Preferences::draw_page(PanelContext& context) {
  page_ == Page::keys ? keys_.draw(context) : draw_preference_rows(context, page_);
}

}  // namespace hariko

#include "ui/theme.hpp"

namespace hariko {

namespace {

constexpr ImU32 rgb(unsigned value, unsigned alpha = 0xff) {
  return IM_COL32((value >> 16) & 0xff, (value >> 8) & 0xff, value & 0xff, alpha);
}

ImVec4 colour(ImU32 value) {
  return ImGui::ColorConvertU32ToFloat4(value);
}

void set_sizes(ImGuiStyle& style, float scale) {
  style.WindowPadding = {12, 12};
  style.FramePadding = {8, 5};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 12;
  style.GrabMinSize = 12;
  style.WindowBorderSize = 0;
  style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowRounding = 0;
  style.ChildRounding = 0;
  style.PopupRounding = 6;
  style.FrameRounding = style.GrabRounding = style.ScrollbarRounding = style.TabRounding = 4;
  style.ScaleAllSizes(scale);
}

void set_colours(ImGuiStyle& style) {
  const Palette& p = palette();
  ImGui::StyleColorsDark(&style);
  const auto set = [&](ImGuiCol role, ImU32 value) { style.Colors[role] = colour(value); };
  set(ImGuiCol_Text, p.text);
  set(ImGuiCol_TextDisabled, p.dim_text);
  set(ImGuiCol_WindowBg, p.panel);
  set(ImGuiCol_ChildBg, rgb(0, 0));
  set(ImGuiCol_PopupBg, rgb(0x2c2f33));
  set(ImGuiCol_Border, p.separator);
  set(ImGuiCol_FrameBg, p.field);
  set(ImGuiCol_FrameBgHovered, p.field_hover);
  set(ImGuiCol_FrameBgActive, rgb(0x464b52));
  set(ImGuiCol_TitleBg, p.window);
  set(ImGuiCol_TitleBgActive, p.window);
  set(ImGuiCol_MenuBarBg, p.window);
  set(ImGuiCol_ScrollbarBg, rgb(0, 0));
  set(ImGuiCol_ScrollbarGrab, rgb(0x4a4f56));
  set(ImGuiCol_CheckMark, p.accent);
  set(ImGuiCol_SliderGrab, rgb(0xc9ced6));
  set(ImGuiCol_SliderGrabActive, p.accent);
  set(ImGuiCol_Button, p.field);
  set(ImGuiCol_ButtonHovered, p.field_hover);
  set(ImGuiCol_ButtonActive, rgb(0x50565e));
  set(ImGuiCol_Header, rgb(0xf29e38, 0x48));
  set(ImGuiCol_HeaderHovered, rgb(0x4aa3df, 0x38));
  set(ImGuiCol_HeaderActive, rgb(0x4aa3df, 0x58));
  set(ImGuiCol_Separator, p.separator);
  set(ImGuiCol_SeparatorHovered, p.secondary);
  set(ImGuiCol_SeparatorActive, p.secondary);
  set(ImGuiCol_TextSelectedBg, rgb(0x4aa3df, 0x70));
  set(ImGuiCol_NavHighlight, p.secondary);
  set(ImGuiCol_ModalWindowDimBg, rgb(0x101113, 0x90));
}

}  // namespace

const Palette& palette() {
  static const Palette dark{rgb(0x1e1f22), rgb(0x26282c), rgb(0x33363b), rgb(0x3d4147),
                            rgb(0x3a3d42), rgb(0xe6e6e6), rgb(0x9aa0a6), rgb(0xf29e38),
                            rgb(0x4aa3df), rgb(0xf0716f), rgb(0xe8bf58), rgb(0x63c174)};
  return dark;
}

void apply_theme(float scale) {
  ImGuiStyle style;
  set_sizes(style, scale);
  set_colours(style);
  ImGui::GetStyle() = style;
}

}  // namespace hariko

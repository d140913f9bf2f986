#include "ui/base/theme.hpp"

#include <algorithm>
#include <cmath>

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

void set_colours(ImGuiStyle& style, ThemeId theme, const Palette& p) {
  if (theme == ThemeId::light)
    ImGui::StyleColorsLight(&style);
  else
    ImGui::StyleColorsDark(&style);
  const auto set = [&](ImGuiCol role, ImU32 value) { style.Colors[role] = colour(value); };
  set(ImGuiCol_Text, p.text);
  set(ImGuiCol_TextDisabled, p.dim_text);
  set(ImGuiCol_WindowBg, p.panel);
  set(ImGuiCol_ChildBg, 0);
  set(ImGuiCol_PopupBg, p.popup);
  set(ImGuiCol_Border, p.separator);
  set(ImGuiCol_FrameBg, p.field);
  set(ImGuiCol_FrameBgHovered, p.field_hover);
  set(ImGuiCol_FrameBgActive, p.field_active);
  set(ImGuiCol_TitleBg, p.window);
  set(ImGuiCol_TitleBgActive, p.window);
  set(ImGuiCol_MenuBarBg, p.window);
  set(ImGuiCol_ScrollbarBg, 0);
  set(ImGuiCol_ScrollbarGrab, with_alpha(p.handle, 0.35F));
  set(ImGuiCol_ScrollbarGrabHovered, with_alpha(p.handle, 0.5F));
  set(ImGuiCol_ScrollbarGrabActive, with_alpha(p.handle, 0.65F));
  set(ImGuiCol_CheckMark, p.accent);
  set(ImGuiCol_SliderGrab, p.handle);
  set(ImGuiCol_SliderGrabActive, p.accent);
  set(ImGuiCol_Button, p.field);
  set(ImGuiCol_ButtonHovered, p.field_hover);
  set(ImGuiCol_ButtonActive, p.field_active);
  set(ImGuiCol_Header, with_alpha(p.accent, 0.28F));
  set(ImGuiCol_HeaderHovered, with_alpha(p.secondary, 0.22F));
  set(ImGuiCol_HeaderActive, with_alpha(p.secondary, 0.35F));
  set(ImGuiCol_Separator, p.separator);
  set(ImGuiCol_SeparatorHovered, p.secondary);
  set(ImGuiCol_SeparatorActive, p.secondary);
  set(ImGuiCol_TextSelectedBg, with_alpha(p.secondary, 0.4F));
  set(ImGuiCol_NavHighlight, p.secondary);
  set(ImGuiCol_ModalWindowDimBg, p.shade);
}

double linear(unsigned value) {
  const double s = value / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

double luminance(ImU32 c) {
  return 0.2126 * linear((c >> IM_COL32_R_SHIFT) & 0xff) + 0.7152 * linear((c >> IM_COL32_G_SHIFT) & 0xff) +
         0.0722 * linear((c >> IM_COL32_B_SHIFT) & 0xff);
}

}  // namespace

Palette palette_of(ThemeId theme) {
  Palette p{};
  if (theme == ThemeId::light) {
    p.window = rgb(0xe7e9ec), p.panel = rgb(0xf4f5f7), p.popup = rgb(0xf1f3f5);
    p.field = rgb(0xffffff), p.field_hover = rgb(0xe9ecf0), p.field_active = rgb(0xdde2e8);
    p.separator = rgb(0xcdd2d8);
    p.text = rgb(0x1f2328), p.dim_text = rgb(0x565d66);
    p.accent = rgb(0x964f00), p.secondary = rgb(0x0b62a3);
    p.error = rgb(0xb3261e), p.warning = rgb(0x7a5700), p.good = rgb(0x1f6b34);
    p.accent_hover = rgb(0xa85a05), p.on_accent = rgb(0xffffff), p.hot = rgb(0xa35f00);
    p.handle = rgb(0x6a737d);
    p.shade = rgb(0x30343a, 0x60), p.overlay = rgb(0xf4f5f7, 0xd8);
    return p;
  }
  p.window = rgb(0x1e1f22), p.panel = rgb(0x26282c), p.popup = rgb(0x2c2f33);
  p.field = rgb(0x33363b), p.field_hover = rgb(0x3d4147), p.field_active = rgb(0x464b52);
  p.separator = rgb(0x3a3d42);
  p.text = rgb(0xe6e6e6), p.dim_text = rgb(0xa3a9af);
  p.accent = rgb(0xf29e38), p.secondary = rgb(0x5fb0e6);
  p.error = rgb(0xf58583), p.warning = rgb(0xe8bf58), p.good = rgb(0x6fc97f);
  p.accent_hover = rgb(0xffb254), p.on_accent = rgb(0x1e1f22), p.hot = rgb(0xffd74a);
  p.handle = rgb(0xc9ced6);
  p.shade = rgb(0x101113, 0x90), p.overlay = rgb(0x1e1f22, 0xd0);
  return p;
}

const Palette& palette() {
  return *static_cast<const Palette*>(ImGui::GetIO().UserData);
}

ImU32 axis_colour(int axis, unsigned alpha) {
  return rgb(axis == 0 ? 0xe5484d : axis == 1 ? 0x46a758 : 0x3e82f7, alpha);
}

ImU32 with_alpha(ImU32 colour, float alpha) {
  return (colour & ~IM_COL32_A_MASK) | (static_cast<ImU32>(alpha * 255 + 0.5F) << IM_COL32_A_SHIFT);
}

double contrast(ImU32 a, ImU32 b) {
  const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
  return std::max(x, y) / std::min(x, y);
}

void apply_theme(ThemeId theme, float scale, Palette& in_use) {
  in_use = palette_of(theme);
  ImGui::GetIO().UserData = &in_use;
  ImGuiStyle style;
  set_sizes(style, scale);
  // White fields on a near-white panel need an edge.
  if (theme == ThemeId::light) style.FrameBorderSize = 1;
  set_colours(style, theme, in_use);
  ImGui::GetStyle() = style;
}

}  // namespace hariko

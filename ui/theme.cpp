#include "ui/theme.hpp"

#include <imgui_freetype.h>

#include <filesystem>

#include "ui/icons.hpp"

namespace hariko {

namespace {

constexpr const char* inter_path = "/usr/share/fonts/opentype/inter/Inter-Regular.otf";
constexpr const char* awesome_path = "/usr/share/fonts/truetype/font-awesome/fontawesome-webfont.ttf";
constexpr float font_size = 15, icon_size = 14, title_size = 26;

constexpr ImU32 rgb(unsigned value, unsigned alpha = 0xff) {
  return IM_COL32((value >> 16) & 0xff, (value >> 8) & 0xff, value & 0xff, alpha);
}

ImVec4 colour(ImU32 value) {
  return ImGui::ColorConvertU32ToFloat4(value);
}

bool exists(const char* path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

/// Returns what is missing, or nullptr.
const char* load_fonts(float scale) {
  static const ImWchar digits[] = {0x30, 0x39, 0x2212, 0x2212, 0};
  static const ImWchar letters[] = {0x20,   0x17f,  0x370,  0x3ff,  0x2010, 0x2044, 0x2070,
                                    0x209f, 0x2190, 0x21ff, 0x2200, 0x22ff, 0};
  static const ImWchar icons[] = {icon::first, icon::last, 0};
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  if (!exists(inter_path)) {
    ImFontConfig config;
    config.SizePixels = 13 * scale;
    atlas.AddFontDefault(&config);
    return "The font Inter is not installed (Debian package fonts-inter): a plain font is used.";
  }
  // Digits first and with one advance, so that columns of numbers stand still; what is merged later does not
  // replace.
  ImFontConfig tabular;
  tabular.GlyphMinAdvanceX = tabular.GlyphMaxAdvanceX = static_cast<float>(static_cast<int>(9.4F * scale));
  atlas.AddFontFromFileTTF(inter_path, font_size * scale, &tabular, digits);
  ImFontConfig merged;
  merged.MergeMode = true;
  atlas.AddFontFromFileTTF(inter_path, font_size * scale, &merged, letters);
  if (!exists(awesome_path)) return "The icon font is not installed (Debian package fonts-font-awesome).";
  merged.GlyphMinAdvanceX = 16 * scale;
  merged.GlyphOffset.y = scale;
  atlas.AddFontFromFileTTF(awesome_path, icon_size * scale, &merged, icons);
  atlas.AddFontFromFileTTF(inter_path, title_size * scale, nullptr, letters);
  return nullptr;
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

ImFont* title_font() {
  // Where fonts are missing there is only the one.
  return ImGui::GetIO().Fonts->Fonts.back();
}

const char* apply_theme(float scale) {
  const char* missing = load_fonts(scale);
  ImGuiStyle style;
  set_sizes(style, scale);
  set_colours(style);
  ImGui::GetStyle() = style;
  return missing;
}

}  // namespace hariko

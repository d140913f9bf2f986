#include "ui/fonts.hpp"

#include <imgui.h>
#include <imgui_freetype.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "ui/drawn_icons.hpp"
#include "ui/icons.hpp"
#include "ui/language.hpp"

namespace hariko {

namespace {

constexpr const char* inter_path = "/usr/share/fonts/opentype/inter/Inter-Regular.otf";
constexpr const char* awesome_path = "/usr/share/fonts/truetype/font-awesome/fontawesome-webfont.ttf";
constexpr const char* noto_path = "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc";
constexpr int noto_japanese_face = 0;
constexpr float font_size = 15, icon_size = 14, title_size = 26;
/// Inter's widest digit (4, 0.642 em) as a share of the line height (1.21 em) by which ImGui sizes fonts.
constexpr float digit_advance = 0.642F / 1.21F;
/// ImGui sizes fonts by their line height, which is larger in Noto Sans CJK: this makes its characters as
/// large as those of Inter.
constexpr float japanese_size = 1.2F;

constexpr const ImWchar digits[] = {0x30, 0x39, 0x2212, 0x2212, 0};
constexpr const ImWchar letters[] = {0x20,   0x17f,  0x370,  0x3ff,  0x2010, 0x2044, 0x2070,
                                     0x209f, 0x2190, 0x21ff, 0x2200, 0x22ff, 0};
constexpr const ImWchar icons[] = {icon::first, icon::last, 0};

bool exists(const char* path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

bool has(const ImWchar* ranges, char32_t character) {
  for (; *ranges; ranges += 2)
    if (character >= ranges[0] && character <= ranges[1]) return true;
  return false;
}

/// The characters of a request that are not in the letters, as ranges. ImGui keeps the pointer until the
/// atlas is built, which `load_fonts` does before this goes away.
ImVector<ImWchar> japanese_ranges(const FontRequest& request, bool common) {
  ImFontGlyphRangesBuilder builder;
  if (common) builder.AddRanges(ImGui::GetIO().Fonts->GetGlyphRangesJapanese());
  for (const char32_t character : request.characters)
    if (needs_japanese_font(character)) builder.AddChar(static_cast<ImWchar>(character));
  ImVector<ImWchar> ranges;
  builder.BuildRanges(&ranges);
  return ranges;
}

/// Places of the drawn icons in the atlas, which has a glyph for each in its first font.
struct DrawnGlyphs {
  int size = 0;
  std::vector<int> rects;
};

DrawnGlyphs reserve_drawn_icons(ImFontAtlas& atlas, float scale) {
  DrawnGlyphs glyphs;
  const float line = font_size * scale, advance = 16 * scale;
  glyphs.size = std::max(8, static_cast<int>(std::lround(icon_size * scale)));
  const float margin = std::round((advance - static_cast<float>(glyphs.size)) / 2);
  const float top = std::round((line - static_cast<float>(glyphs.size)) / 2);
  for (const DrawnIcon& icon : drawn_icons())
    glyphs.rects.push_back(atlas.AddCustomRectFontGlyph(atlas.Fonts[0], icon.code, glyphs.size, glyphs.size,
                                                        advance, {margin, top}));
  return glyphs;
}

/// After the atlas was built.
void fill_drawn_icons(ImFontAtlas& atlas, const DrawnGlyphs& glyphs) {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsAlpha8(&pixels, &width, &height);
  for (std::size_t i = 0; i < glyphs.rects.size(); ++i) {
    const ImFontAtlasCustomRect& rect = *atlas.GetCustomRectByIndex(glyphs.rects[i]);
    const auto picture = rasterised(drawn_icons()[i], glyphs.size);
    for (int y = 0; y < glyphs.size; ++y)
      std::copy_n(picture.begin() + y * glyphs.size, glyphs.size, pixels + (rect.Y + y) * width + rect.X);
  }
}

}  // namespace

bool japanese_font_installed() {
  return exists(noto_path);
}

bool needs_japanese_font(char32_t character) {
  return character <= IM_UNICODE_CODEPOINT_MAX && !has(letters, character) && !has(icons, character) &&
         character > 0x2e00;
}

const char* load_fonts(const FontRequest& request) {
  const float scale = request.scale;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  if (!exists(inter_path)) {
    ImFontConfig config;
    config.SizePixels = 13 * scale;
    atlas.AddFontDefault(&config);
    return translatable(
        "The font Inter is not installed (Debian package fonts-inter): a plain font is used.");
  }
  const char* missing = nullptr;
  // Digits first and with one advance, so that columns of numbers stand still; what is merged later does not
  // replace.
  ImFontConfig tabular;
  tabular.GlyphMinAdvanceX = tabular.GlyphMaxAdvanceX = std::ceil(digit_advance * font_size * scale);
  atlas.AddFontFromFileTTF(inter_path, font_size * scale, &tabular, digits);
  ImFontConfig merged;
  merged.MergeMode = true;
  atlas.AddFontFromFileTTF(inter_path, font_size * scale, &merged, letters);
  ImFontConfig japanese;
  japanese.MergeMode = true;
  japanese.FontNo = noto_japanese_face;
  const ImVector<ImWchar> ranges = japanese_ranges(request, request.japanese);
  const bool wants_japanese = ranges.size() > 1 && japanese_font_installed();
  if (wants_japanese)
    atlas.AddFontFromFileTTF(noto_path, japanese_size * font_size * scale, &japanese, ranges.Data);
  if (exists(awesome_path)) {
    merged.GlyphMinAdvanceX = 16 * scale;
    merged.GlyphOffset.y = scale;
    atlas.AddFontFromFileTTF(awesome_path, icon_size * scale, &merged, icons);
  } else {
    missing = translatable("The icon font is not installed (Debian package fonts-font-awesome).");
  }
  atlas.AddFontFromFileTTF(inter_path, title_size * scale, nullptr, letters);
  // Titles are the program's own words: what the catalogue needs, and no more.
  const ImVector<ImWchar> title_ranges = japanese_ranges(request, false);
  if (wants_japanese && request.japanese && title_ranges.size() > 1)
    atlas.AddFontFromFileTTF(noto_path, japanese_size * title_size * scale, &japanese, title_ranges.Data);
  const DrawnGlyphs drawn = reserve_drawn_icons(atlas, scale);
  atlas.Build();
  fill_drawn_icons(atlas, drawn);
  return missing;
}

ImFont* title_font() {
  // Where fonts are missing there is only the one.
  return ImGui::GetIO().Fonts->Fonts.back();
}

}  // namespace hariko

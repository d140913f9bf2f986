#include "ui/base/fonts.hpp"

#include <fcntl.h>
#include <ft2build.h>
#include <imgui.h>
#include <imgui_freetype.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include FT_FREETYPE_H

#include "render/font_files.hpp"
#include "ui/base/drawn_icons.hpp"
#include "ui/base/icons.hpp"
#include "ui/base/language.hpp"

namespace hariko {

namespace {

constexpr float font_size = 15, icon_size = 14, title_size = 26;
/// Inter's widest digit (4, 0.642 em) as a share of the line height (1.21 em) by which ImGui sizes fonts.
constexpr float digit_advance = 0.642F / 1.21F;

constexpr const ImWchar digits[] = {0x30, 0x39, 0x2212, 0x2212, 0};
/// Latin with all its additions, Greek and Cyrillic with theirs, punctuation, arrows and signs of
/// mathematics.
constexpr const ImWchar letters[] = {0x20,   0x24f,  0x370,  0x52f,  0x1e00, 0x1fff, 0x2010, 0x2044, 0x2070,
                                     0x209f, 0x20a0, 0x20bf, 0x2100, 0x21ff, 0x2200, 0x22ff, 0};
constexpr const ImWchar title_letters[] = {0x20, 0x17f, 0x2010, 0x2044, 0};
constexpr const ImWchar icons[] = {icon::first, icon::last, 0};

/// A font's bytes, read only where they are looked at: a collection for Japanese has twenty megabytes, of
/// which a few characters are wanted.
class MappedFont {
 public:
  MappedFont() = default;
  explicit MappedFont(const FontFile& file) : face_(file.face) {
    const int descriptor = ::open(file.path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (descriptor < 0) return;
    if (::fstat(descriptor, &status) == 0 && status.st_size > 0 && status.st_size <= INT_MAX) {
      void* memory = ::mmap(nullptr, std::size_t(status.st_size), PROT_READ, MAP_PRIVATE, descriptor, 0);
      if (memory != MAP_FAILED) bytes_ = memory, size_ = int(status.st_size);
    }
    ::close(descriptor);
  }
  MappedFont(MappedFont&& other) noexcept
      : bytes_(std::exchange(other.bytes_, nullptr)), size_(other.size_), face_(other.face_) {}
  MappedFont& operator=(MappedFont&& other) noexcept {
    std::swap(bytes_, other.bytes_), std::swap(size_, other.size_), std::swap(face_, other.face_);
    return *this;
  }
  ~MappedFont() {
    if (bytes_) ::munmap(bytes_, std::size_t(size_));
  }

  explicit operator bool() const { return bytes_ != nullptr; }
  /// Adds characters of it to the atlas, which does not own the bytes.
  void add(ImFontAtlas& atlas, float size, ImFontConfig config, const ImWchar* ranges) const {
    config.FontDataOwnedByAtlas = false;
    config.FontNo = face_;
    atlas.AddFontFromMemoryTTF(bytes_, size_, size, &config, ranges);
  }
  /// Ems in a line, by which ImGui sizes fonts; 0 where the font cannot be read.
  float line_height() const {
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    float height = 0;
    if (FT_Init_FreeType(&library) != 0) return 0;
    if (FT_New_Memory_Face(library, static_cast<const FT_Byte*>(bytes_), size_, face_, &face) == 0) {
      if (face->units_per_EM > 0)
        height =
            static_cast<float>(face->ascender - face->descender) / static_cast<float>(face->units_per_EM);
      FT_Done_Face(face);
    }
    FT_Done_FreeType(library);
    return height;
  }

 private:
  void* bytes_ = nullptr;
  int size_ = 0, face_ = 0;
};

MappedFont mapped(const std::optional<FontFile>& file) {
  return file ? MappedFont(*file) : MappedFont();
}

bool has(const ImWchar* ranges, char32_t character) {
  for (; *ranges; ranges += 2)
    if (character >= ranges[0] && character <= ranges[1]) return true;
  return false;
}

/// The characters of a request that are not in the letters, as ranges. ImGui keeps the pointer until the
/// atlas is built, which `load_fonts` does before this goes away.
ImVector<ImWchar> japanese_ranges(const FontRequest& request) {
  ImFontGlyphRangesBuilder builder;
  if (request.japanese) builder.AddRanges(ImGui::GetIO().Fonts->GetGlyphRangesJapanese());
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
  return font_files().japanese.has_value();
}

bool needs_japanese_font(char32_t character) {
  return character <= IM_UNICODE_CODEPOINT_MAX && !has(letters, character) && !has(icons, character) &&
         character > 0x2e00;
}

bool fonts_can_write(std::string_view text) {
  if (japanese_font_installed()) return true;
  const std::u32string characters = code_points(text);
  return std::ranges::none_of(characters, needs_japanese_font);
}

namespace {

/// The icons that the program uses.
ImVector<ImWchar> icon_ranges() {
  ImFontGlyphRangesBuilder builder;
  for (const char* icon : icon::of_font) builder.AddText(icon);
  ImVector<ImWchar> ranges;
  builder.BuildRanges(&ranges);
  return ranges;
}

/// Sizes at which Japanese characters are as large as those of the text: ImGui sizes fonts by their line
/// height, which differs.
float japanese_scale(const MappedFont& text, const MappedFont& japanese) {
  const float ours = text.line_height(), theirs = japanese.line_height();
  return ours > 0 && theirs > 0 ? theirs / ours : 1;
}

/// Fonts of the machine in ImGui's atlas. The bytes and ranges are needed until the atlas is built.
void build_atlas(ImFontAtlas& atlas, const FontRequest& request, const FontFiles& files) {
  const float scale = request.scale;
  const MappedFont text = mapped(files.text), icon_font = mapped(files.icons);
  ImFontConfig merged;
  merged.MergeMode = true;
  ImFontConfig first;
  if (files.text_is_inter()) {
    // Digits first and with one advance, so that columns of numbers stand still; what is merged later does
    // not replace.
    first.GlyphMinAdvanceX = first.GlyphMaxAdvanceX = std::ceil(digit_advance * font_size * scale);
    text.add(atlas, font_size * scale, first, digits);
    first = merged;
  }
  text.add(atlas, font_size * scale, first, letters);
  const ImVector<ImWchar> ranges = japanese_ranges(request);
  MappedFont japanese;
  if (ranges.size() > 1) japanese = mapped(files.japanese);
  const float japanese_size = japanese ? japanese_scale(text, japanese) : 1;
  if (japanese) japanese.add(atlas, japanese_size * font_size * scale, merged, ranges.Data);
  const ImVector<ImWchar> used_icons = icon_ranges();
  if (icon_font) {
    ImFontConfig config = merged;
    config.GlyphMinAdvanceX = 16 * scale;
    config.GlyphOffset.y = scale;
    icon_font.add(atlas, icon_size * scale, config, used_icons.Data);
  }
  text.add(atlas, title_size * scale, {}, title_letters);
  const DrawnGlyphs drawn = reserve_drawn_icons(atlas, scale);
  atlas.Build();
  fill_drawn_icons(atlas, drawn);
  for (ImFontConfig& config : atlas.ConfigData) config.FontData = nullptr;  // no longer there
}

}  // namespace

const char* missing_fonts() {
  const FontFiles& files = font_files();
  if (!files.text)
    return translatable(
        "The font Inter is not installed (Debian package fonts-inter): a plain font is used.");
  if (!files.text_is_inter())
    return translatable("The font Inter is not installed (Debian package fonts-inter): another one is used.");
  if (!files.icons)
    return translatable("The icon font is not installed (Debian package fonts-font-awesome).");
  return nullptr;
}

void load_fonts(const FontRequest& request) {
  const FontFiles& files = font_files();
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  if (mapped(files.text)) return build_atlas(atlas, request, files);
  ImFontConfig config;
  config.SizePixels = 13 * request.scale;
  atlas.AddFontDefault(&config);
}

ImFont* title_font() {
  // The last font, which is the only one where fonts are missing.
  return ImGui::GetIO().Fonts->Fonts.back();
}

}  // namespace hariko

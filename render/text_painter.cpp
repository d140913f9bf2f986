#include "render/text_painter.hpp"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <cmath>
#include <cstddef>
#include <string>

namespace hariko {

namespace {

/// Code points of UTF-8 text; malformed bytes become U+FFFD.
std::u32string decode(std::string_view text) {
  std::u32string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i++]);
    const int more = byte < 0x80           ? 0
                     : (byte >> 5) == 0x6  ? 1
                     : (byte >> 4) == 0xe  ? 2
                     : (byte >> 3) == 0x1e ? 3
                                           : -1;
    char32_t code = more == 0 ? byte : more == 1 ? byte & 0x1fU : more == 2 ? byte & 0x0fU : byte & 0x07U;
    int k = 0;
    for (; k < more && i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0U) == 0x80; ++k)
      code = (code << 6) | (static_cast<unsigned char>(text[i++]) & 0x3fU);
    out.push_back(more < 0 || k < more ? U'\ufffd' : code);
  }
  return out;
}

/// Blends a rendered glyph with its origin at a pixel.
void blend_glyph(Image& image, FT_GlyphSlot glyph, int x, int y, const Color& color) {
  const FT_Bitmap& bitmap = glyph->bitmap;
  for (unsigned row = 0; row < bitmap.rows; ++row)
    for (unsigned column = 0; column < bitmap.width; ++column)
      image.blend(x + glyph->bitmap_left + static_cast<int>(column),
                  y - glyph->bitmap_top + static_cast<int>(row), color,
                  bitmap.buffer[static_cast<std::ptrdiff_t>(row) * bitmap.pitch + column] / 255.0);
}

}  // namespace

struct TextPainter::State {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  ~State() {
    if (face) FT_Done_Face(face);
    if (library) FT_Done_FreeType(library);
  }
  /// Calls draw(pen position) for each loaded glyph; returns the text's width.
  template <class Draw>
  double walk(std::string_view text, double size, FT_Int32 flags, Draw&& draw) {
    if (!face || FT_Set_Char_Size(face, 0, static_cast<FT_F26Dot6>(std::lround(size * 64)), 72, 72)) return 0;
    double pen = 0;
    for (const char32_t code : decode(text)) {
      if (FT_Load_Char(face, code, flags)) continue;
      draw(pen);
      pen += static_cast<double>(face->glyph->linearHoriAdvance) / 65536;
    }
    return pen;
  }
};

TextPainter::TextPainter(const std::optional<FontFile>& font) : state_(std::make_unique<State>()) {
  if (!font || FT_Init_FreeType(&state_->library)) {
    state_->library = nullptr;
    return;
  }
  if (FT_New_Face(state_->library, font->path.c_str(), font->face, &state_->face)) state_->face = nullptr;
}
TextPainter::~TextPainter() = default;
TextPainter::TextPainter(TextPainter&&) noexcept = default;
TextPainter& TextPainter::operator=(TextPainter&&) noexcept = default;

double TextPainter::width(std::string_view text, double size) {
  if (!state_->face) return dot_text_width(decode(text), size);
  return state_->walk(text, size, FT_LOAD_NO_HINTING, [](double) {});
}

void TextPainter::paint(Image& image, std::string_view text, double x, double y, double size, Color color) {
  if (!state_->face) return paint_dot_text(image, decode(text), {x, y}, 0, size, color);
  const int baseline = static_cast<int>(std::lround(y));
  state_->walk(text, size, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT, [&](double pen) {
    blend_glyph(image, state_->face->glyph, static_cast<int>(std::lround(x + pen)), baseline, color);
  });
}

void TextPainter::paint_turned(Image& image, std::string_view text, const Vector2& middle, double angle,
                               double size, double capitals, Color color) {
  const double c = std::cos(angle), s = std::sin(angle), half = width(text, size) / 2;
  if (!state_->face) {
    const Vector2 start = middle + Vector2(-c * half + s * capitals / 2, s * half + c * capitals / 2);
    return paint_dot_text(image, decode(text), start, angle, size, color);
  }
  const auto fixed = [](double value) { return static_cast<FT_Fixed>(std::lround(value * 65536)); };
  FT_Matrix turn{fixed(c), fixed(-s), fixed(s), fixed(c)};
  state_->walk(text, size, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP, [&](double pen) {
    // Origin of the glyph in pixels, y up.
    const double along = pen - half, up = -capitals / 2;
    const double x = middle.x() + c * along - s * up, y = -middle.y() + s * along + c * up;
    const FT_GlyphSlot glyph = state_->face->glyph;
    if (glyph->format != FT_GLYPH_FORMAT_OUTLINE) return;
    FT_Outline_Transform(&glyph->outline, &turn);
    FT_Outline_Translate(&glyph->outline, static_cast<FT_Pos>(std::lround(64 * (x - std::floor(x)))),
                         static_cast<FT_Pos>(std::lround(64 * (y - std::floor(y)))));
    if (FT_Render_Glyph(glyph, FT_RENDER_MODE_NORMAL)) return;
    blend_glyph(image, glyph, static_cast<int>(std::floor(x)), -static_cast<int>(std::floor(y)), color);
  });
}

}  // namespace hariko

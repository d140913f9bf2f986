#pragma once

// Fonts: what the interface is written with. Japanese is loaded only when something needs it.

#include <set>
#include <string>

struct ImFont;

namespace hariko {

/// What the fonts must be able to write, beyond Latin and Greek.
struct FontRequest {
  float scale = 1;  ///< framebuffer pixels per design pixel
  /// Kana and the common characters of Japanese, for reading and typing.
  bool japanese = false;
  std::set<char32_t> characters;  ///< single ones besides: of names in the document, of catalogues
  friend bool operator==(const FontRequest&, const FontRequest&) = default;
};

/// Whether a font for Japanese is installed (Debian package fonts-noto-cjk).
bool japanese_font_installed();
/// Whether this character is in the font for Japanese only.
bool needs_japanese_font(char32_t character);

/// Fills ImGui's atlas anew; between frames only, and the backend must take up the atlas afterwards. Returns
/// what is missing, as a sentence, or nullptr.
const char* load_fonts(const FontRequest& request);

/// The large font of titles.
ImFont* title_font();

}  // namespace hariko

#pragma once

// Fonts: what the interface is written with: Latin, Greek and Cyrillic always, Japanese only when something
// needs it.

#include <set>
#include <string_view>

struct ImFont;

namespace hariko {

/// Characters that the fonts must have, beyond Latin, Greek and Cyrillic.
struct FontRequest {
  float scale = 1;  ///< framebuffer pixels per design pixel
  /// Kana and the common characters of Japanese, for reading and typing.
  bool japanese = false;
  std::set<char32_t> characters;  ///< single ones besides: of names in the document, of catalogues
  friend bool operator==(const FontRequest&, const FontRequest&) = default;
};

/// Whether a font for Japanese is installed (on Debian that of the package fonts-noto-cjk).
bool japanese_font_installed();
/// Whether this character is in the font for Japanese only.
bool needs_japanese_font(char32_t character);
/// Whether a text has no characters of a font that is not installed.
bool fonts_can_write(std::string_view text);

/// Sentence that names a font that this program is made for and that is not installed; null where all are.
const char* missing_fonts();

/// Fills ImGui's atlas anew; between frames only, and the backend must take up the atlas afterwards. Where no
/// font can be found it is ImGui's own one, of plain Latin.
void load_fonts(const FontRequest& request);

/// The large font of titles, which has Latin letters only.
ImFont* title_font();

}  // namespace hariko

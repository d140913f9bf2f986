#pragma once

// Font files: where the fonts of the interface and of pictures lie on this machine, as fontconfig finds them.

#include <optional>
#include <string>

namespace hariko {

struct FontFile {
  std::string path;
  int face = 0;        ///< index in a collection, as FreeType takes it (named instances in the upper half)
  std::string family;  ///< "Inter"
};

/// An empty member means that no such font was found.
struct FontFiles {
  std::optional<FontFile> text;   ///< Inter, else what fontconfig takes for a sans-serif with Latin letters
  std::optional<FontFile> icons;  ///< Font Awesome 4, and nothing else: its characters are its own
  std::optional<FontFile> japanese;  ///< Noto Sans CJK JP, else any that has kana and kanji
  bool text_is_inter() const { return text && text->family == "Inter"; }
};

/// Asks fontconfig anew: a few milliseconds. Outlines that can be scaled only.
FontFiles find_font_files();
/// The same, asked once in the life of the program: fonts that are installed meanwhile show at the next
/// start.
const FontFiles& font_files();

}  // namespace hariko

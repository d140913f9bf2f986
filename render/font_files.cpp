#include "render/font_files.hpp"

#include <fontconfig/fontconfig.h>

#include <initializer_list>
#include <memory>

namespace hariko {

namespace {

struct ConfigDeleter {
  void operator()(FcConfig* config) const { FcConfigDestroy(config); }
};
struct PatternDeleter {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
};
struct CharSetDeleter {
  void operator()(FcCharSet* set) const { FcCharSetDestroy(set); }
};
using Config = std::unique_ptr<FcConfig, ConfigDeleter>;
using Pattern = std::unique_ptr<FcPattern, PatternDeleter>;
using CharSet = std::unique_ptr<FcCharSet, CharSetDeleter>;
using Characters = std::initializer_list<char32_t>;

const FcChar8* fc(const char* text) {
  return reinterpret_cast<const FcChar8*>(text);
}

/// An upright, regular, scalable font of this family, else of a generic one ("sans-serif").
Pattern wanted(const char* family, const char* generic, Characters characters) {
  Pattern pattern(FcPatternCreate());
  FcPatternAddString(pattern.get(), FC_FAMILY, fc(family));
  if (generic) FcPatternAddString(pattern.get(), FC_FAMILY, fc(generic));
  FcPatternAddInteger(pattern.get(), FC_WEIGHT, FC_WEIGHT_REGULAR);
  FcPatternAddInteger(pattern.get(), FC_SLANT, FC_SLANT_ROMAN);
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  const CharSet set(FcCharSetCreate());
  for (const char32_t character : characters) FcCharSetAddChar(set.get(), character);
  FcPatternAddCharSet(pattern.get(), FC_CHARSET, set.get());
  return pattern;
}

/// A match always comes back, however far it is from what was wanted: whether it will do is seen here.
std::optional<FontFile> usable(const Pattern& found, Characters characters) {
  FcChar8 *path = nullptr, *family = nullptr;
  FcCharSet* set = nullptr;
  FcBool scalable = FcFalse;
  FontFile file;
  const auto has = [](FcResult result) { return result == FcResultMatch; };
  if (!found || !has(FcPatternGetString(found.get(), FC_FILE, 0, &path)) ||
      !has(FcPatternGetCharSet(found.get(), FC_CHARSET, 0, &set)) ||
      !has(FcPatternGetBool(found.get(), FC_SCALABLE, 0, &scalable)) || !scalable)
    return {};
  for (const char32_t character : characters)
    if (!FcCharSetHasChar(set, character)) return {};
  file.path = reinterpret_cast<const char*>(path);
  if (has(FcPatternGetString(found.get(), FC_FAMILY, 0, &family)))
    file.family = reinterpret_cast<const char*>(family);
  FcPatternGetInteger(found.get(), FC_INDEX, 0, &file.face);
  return file;
}

std::optional<FontFile> match(const Config& config, const char* family, const char* generic,
                              Characters characters) {
  const Pattern pattern = wanted(family, generic, characters);
  FcConfigSubstitute(config.get(), pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult result = FcResultNoMatch;
  return usable(Pattern(FcFontMatch(config.get(), pattern.get(), &result)), characters);
}

}  // namespace

FontFiles find_font_files() {
  FontFiles files;
  const Config config(FcInitLoadConfigAndFonts());
  if (!config) return files;
  files.text = match(config, "Inter", "sans-serif", {U'A', U'z', U'0'});
  constexpr char32_t cube_icon = 0xf1b2;
  files.icons = match(config, "FontAwesome", nullptr, {cube_icon});
  if (files.icons && files.icons->family != "FontAwesome") files.icons.reset();
  files.japanese =
      match(config, "Noto Sans CJK JP", "sans-serif", {U'\u3042', U'\u30ab', U'\u65e5', U'\u8a9e'});
  return files;
}

const FontFiles& font_files() {
  static const FontFiles files = find_font_files();
  return files;
}

}  // namespace hariko

// The palettes: readable on every background that they are used on.

#include "ui/base/theme.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "render/style.hpp"

namespace hariko {
namespace {

TEST(Theme, ContrastIsThatOfTheGuidelines) {
  EXPECT_NEAR(contrast(IM_COL32_WHITE, IM_COL32_BLACK), 21, 1e-9);
  EXPECT_NEAR(contrast(IM_COL32_WHITE, IM_COL32_WHITE), 1, 1e-9);
  EXPECT_NEAR(contrast(IM_COL32(0x77, 0x77, 0x77, 0xff), IM_COL32_WHITE), 4.478,
              0.001);  // the known near miss
}

TEST(Theme, TextIsReadableOnItsBackgrounds) {
  for (const ThemeId theme : {ThemeId::dark, ThemeId::light}) {
    const Palette p = palette_of(theme);
    const std::map<std::string, ImU32> texts{
        {"text", p.text},   {"dim_text", p.dim_text}, {"accent", p.accent}, {"secondary", p.secondary},
        {"error", p.error}, {"warning", p.warning},   {"good", p.good}};
    const std::map<std::string, ImU32> backgrounds{
        {"window", p.window}, {"panel", p.panel}, {"popup", p.popup}, {"field", p.field}};
    for (const auto& [text, ink] : texts)
      for (const auto& [background, paper] : backgrounds)
        EXPECT_GE(contrast(ink, paper), 4.5)
            << text << " on " << background << ", theme " << (theme == ThemeId::dark ? "dark" : "light");
    // Fields under the pointer keep their text readable.
    for (const ImU32 paper : {p.field_hover, p.field_active}) EXPECT_GE(contrast(p.text, paper), 4.5);
    // So does the button that stands out, and what tools draw is seen on the picture's background.
    for (const ImU32 paper : {p.accent, p.accent_hover}) EXPECT_GE(contrast(p.on_accent, paper), 4.5);
    const gl::Style style = gl::style_of(theme == ThemeId::dark ? Background::dark : Background::light);
    for (const Color& paper : {style.top, style.bottom}) {
      const ImU32 sky =
          IM_COL32(std::lround(255 * paper.r), std::lround(255 * paper.g), std::lround(255 * paper.b), 255);
      EXPECT_GE(contrast(p.hot, sky), 3);
      EXPECT_GE(contrast(p.text, sky), 4.5);
    }
    // Handles are seen: 3 : 1 is what the guidelines want of controls.
    EXPECT_GE(contrast(p.handle, p.panel), 3);
    EXPECT_GE(contrast(p.handle, p.field), 3);
  }
}

TEST(Theme, OpacityChangesNothingElse) {
  EXPECT_EQ(with_alpha(IM_COL32(1, 2, 3, 255), 0.5F), IM_COL32(1, 2, 3, 128));
  EXPECT_EQ(with_alpha(IM_COL32(1, 2, 3, 4), 1), IM_COL32(1, 2, 3, 255));
}

}  // namespace
}  // namespace hariko

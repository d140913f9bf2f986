#pragma once

// TextPainter: short lines of text in pictures. Internal to render/; the window has its own text.

#include <memory>
#include <optional>
#include <string_view>

#include "core/base/vector.hpp"
#include "render/font_files.hpp"
#include "render/image.hpp"

namespace hariko {

/// Painter with a font, that of the interface unless another is given; letters of dots where there is none or
/// it cannot be read.
class TextPainter {
 public:
  explicit TextPainter(const std::optional<FontFile>& font = font_files().text);
  ~TextPainter();
  TextPainter(TextPainter&&) noexcept;
  TextPainter& operator=(TextPainter&&) noexcept;

  /// Width in pixels of UTF-8 text at a size in pixels (of the em).
  double width(std::string_view text, double size);
  /// Paints with the baseline's left end at (x, y).
  void paint(Image& image, std::string_view text, double x, double y, double size, Color color);
  /// Paints a line centred at a point; its capitals are `capitals` pixels high, and `angle` is
  /// counter-clockwise, in radians.
  void paint_turned(Image& image, std::string_view text, const Vector2& middle, double angle, double size,
                    double capitals, Color color);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Width in pixels of text at a size in pixels (of the em).
double dot_text_width(std::u32string_view text, double size);

/// Paints text with the baseline's left end at `start`; `angle` is counter-clockwise, in radians. Characters
/// without dots are boxes. O(pixels of the text's bounds).
void paint_dot_text(Image& image, std::u32string_view text, const Vector2& start, double angle, double size,
                    const Color& color);

}  // namespace hariko

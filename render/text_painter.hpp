#pragma once

// TextPainter: short lines of text in pictures. Internal to render/; the window has its own text.

#include <memory>
#include <string_view>

#include "core/base/vector.hpp"
#include "render/image.hpp"

namespace hariko {

/// Painter with the first installed font of a short list; without one it paints nothing.
class TextPainter {
 public:
  TextPainter();
  ~TextPainter();
  TextPainter(TextPainter&&) noexcept;
  TextPainter& operator=(TextPainter&&) noexcept;

  /// Whether a font was found.
  bool available() const;
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

}  // namespace hariko

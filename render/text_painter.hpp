#pragma once

// TextPainter: short lines of text onto pictures. Internal to render/; the window has its own text.

#include <memory>
#include <string_view>

#include "render/image.hpp"

namespace hariko {

/// Uses the first installed font of a short list; without one, nothing is painted.
class TextPainter {
 public:
  TextPainter();
  ~TextPainter();
  TextPainter(TextPainter&&) noexcept;
  TextPainter& operator=(TextPainter&&) noexcept;

  bool available() const;
  /// Width in pixels of UTF-8 text at a size in pixels (of the em).
  double width(std::string_view text, double size);
  /// Paints with the baseline's left end at (x, y).
  void paint(Image& image, std::string_view text, double x, double y, double size, Color color);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hariko

#pragma once

// FrameMeter: what a frame took, and how long the surface of a drag took to show.

#include <chrono>
#include <deque>
#include <memory>
#include <span>
#include <utility>

#include "app/window/gl_window.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

class FrameMeter {
 public:
  struct Frame {
    std::chrono::steady_clock::time_point start;
    GlWindow::FrameEnd end;
    double viewport = 0;  ///< milliseconds of the renderer for the model's picture
  };
  /// Adds a frame that has just ended to the editor's times. `input`: the events that it took; `now`: the
  /// window's time.
  void measure(Editor& editor, const Frame& frame, std::span<const InputEvent> input, double now);

 private:
  /// Objects as drags made them, with the time of the pointer event; until their surface shows.
  std::deque<std::pair<std::shared_ptr<const Object>, double>> dragged_;
};

}  // namespace hariko

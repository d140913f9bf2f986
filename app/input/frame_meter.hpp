#pragma once

// FrameMeter: durations of frames, and latency between a drag and its surface.

#include <chrono>
#include <deque>
#include <memory>
#include <span>
#include <utility>

#include "app/window/gl_window.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// Measures frames for the editor's performance display.
class FrameMeter {
 public:
  struct Frame {
    std::chrono::steady_clock::time_point start;
    GlWindow::FrameEnd end;
    double viewport = 0;  ///< milliseconds for rendering the model's picture
  };
  /// Adds a finished frame to the editor's times. `input`: events that it handled; `now`: the window's time.
  void measure(Editor& editor, const Frame& frame, std::span<const InputEvent> input, double now);

 private:
  /// Objects made by drags whose surface is not shown yet, with the time of the pointer event.
  std::deque<std::pair<std::shared_ptr<const Object>, double>> dragged_;
};

}  // namespace hariko

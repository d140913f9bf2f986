#pragma once

// GlWindow: a window of the desktop with an OpenGL context and ImGui in it.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/input/input_queue.hpp"
#include "core/base/result.hpp"
#include "render/image.hpp"
#include "ui/base/fonts.hpp"
#include "ui/base/theme.hpp"
#include "ui/editor/command_table.hpp"

namespace hariko {

inline constexpr Code e_no_display{"E_NO_DISPLAY"};
inline constexpr Code e_no_window{"E_NO_WINDOW"};

/// One a process. All calls from the main thread, but for `wake`.
class GlWindow {
 public:
  struct Options {
    std::string title;
    int width = 1440, height = 900;  ///< screen coordinates
    double scale = 0;                ///< of the interface instead of the monitor's; 0 for the monitor's
    std::vector<Image> icons = {};   ///< of the window, in the sizes that there are; the desktop chooses
  };
  /// Errors: E_NO_DISPLAY, E_NO_WINDOW (no OpenGL 3.3), both with what to do.
  static Result<std::unique_ptr<GlWindow>> open(const Options& options);
  ~GlWindow();
  GlWindow(const GlWindow&) = delete;
  GlWindow& operator=(const GlWindow&) = delete;

  /// Waits for input, a `wake` or the time to pass; 0 looks without waiting. True when there was input: one
  /// batch of it (see InputQueue) is then what the next frame sees.
  bool wait(double seconds, bool keys_wait = false);
  /// That batch.
  const std::vector<InputEvent>& input() const;
  /// When it came, of the same clock as `now`; without input the present. What ImGui's times go by.
  double input_time() const;
  /// From now on the window sees this input and time instead of the user's and the clock's.
  void replay(double now, const std::vector<InputEvent>& batch);
  /// Ends the wait. From any thread.
  static void wake();

  /// Colours and size from the next frame on; between frames only. True when something changed.
  bool set_appearance(ThemeId theme, float interface_scale);
  void begin_frame();
  /// Milliseconds: OpenGL drawing the interface, and showing the frame, which may wait for the screen.
  struct FrameEnd {
    double drawing = 0, showing = 0;
  };
  /// When `measure`, waits until OpenGL is finished.
  FrameEnd end_frame(bool measure = false);

  std::vector<KeyPress> take_keys();
  std::vector<std::filesystem::path> take_drops();
  /// Characters that were typed or came from an input method since the last call.
  std::u32string take_typed();
  /// The user wants to close the window; asked once.
  bool take_close();
  void set_title(const std::string& title);
  const Metrics& metrics() const;
  int width() const;
  int height() const;
  /// The monitor's scale or the one asked for.
  double monitor_scale() const;
  /// Seconds of a steady clock.
  double now() const;
  /// Makes the fonts write this from the next frame on; the window knows its own scale. Does nothing when
  /// they do already. Not within a frame.
  void set_fonts(FontRequest request);

 private:
  struct State;
  explicit GlWindow(std::unique_ptr<State> state);
  void deliver(const InputEvent& event);
  std::unique_ptr<State> state_;
};

}  // namespace hariko

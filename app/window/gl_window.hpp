#pragma once

// GlWindow: a desktop window with an OpenGL context and ImGui.

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

/// Window of the program, one for each process. All calls from the main thread, except `wake`.
class GlWindow {
 public:
  struct Options {
    std::string title;
    int width = 1440, height = 900;  ///< screen coordinates
    double scale = 0;                ///< scale of the interface instead of the monitor's; 0: the monitor's
    std::vector<Image> icons = {};   ///< window icons in the available sizes; the desktop chooses
  };
  /// Opens the window. Errors: E_NO_DISPLAY, E_NO_WINDOW (no OpenGL 3.3), both with advice.
  static Result<std::unique_ptr<GlWindow>> open(const Options& options);
  ~GlWindow();
  GlWindow(const GlWindow&) = delete;
  GlWindow& operator=(const GlWindow&) = delete;

  /// Waits for input, a `wake` or the time to pass; with 0 polls without waiting. True where there was input:
  /// the next frame then gets one batch of it (see InputQueue).
  bool wait(double seconds, bool keys_wait = false);
  /// Batch of input for the next frame.
  const std::vector<InputEvent>& input() const;
  /// Queues events of a device that the window does not know; passes over them while the window is not in
  /// front, as other programs hear of them, too.
  void queue(std::vector<InputEvent> events);
  /// Queues files as if they had been dropped on the window; passes over them while a replay plays, which has
  /// the drops of its recording.
  void drop(const std::vector<std::filesystem::path>& files);
  /// Time of that batch, of the same clock as `now`; without input the present. ImGui's times follow it.
  double input_time() const;
  /// Replaces the user's input and the clock by this input and time, from now on.
  void replay(double now, const std::vector<InputEvent>& batch);
  /// Ends `wait`. From any thread.
  static void wake();

  /// Sets colours and size from the next frame on; only between frames. True where something changed.
  bool set_appearance(ThemeId theme, float interface_scale);
  /// Begins a frame of ImGui with the present batch of input.
  void begin_frame();
  /// Milliseconds for drawing the interface by OpenGL, and for showing the frame, which may wait for the
  /// screen.
  struct FrameEnd {
    double drawing = 0, showing = 0;
  };
  /// Ends the frame; with `measure` waits until OpenGL is finished.
  FrameEnd end_frame(bool measure = false);

  /// Key presses since the last call.
  std::vector<KeyPress> take_keys();
  /// Files that were dropped on the window since the last call.
  std::vector<std::filesystem::path> take_drops();
  /// Characters that were typed or came from an input method since the last call.
  std::u32string take_typed();
  /// Motions of a 3D mouse and presses of its buttons since the last call.
  std::vector<InputEvent> take_caps();
  /// Whether the user asked to close the window since the last call.
  bool take_close();
  void set_title(const std::string& title);
  /// Sizes of the interface at the present scale.
  const Metrics& metrics() const;
  /// Size of the window in screen coordinates.
  int width() const;
  int height() const;
  /// Scale of the monitor, or the one that was requested.
  double monitor_scale() const;
  /// Seconds of a steady clock.
  double now() const;
  /// Loads fonts for this request from the next frame on; the window adds its own scale. Does nothing where
  /// they are loaded already. Not within a frame.
  void set_fonts(FontRequest request);

 private:
  struct State;
  explicit GlWindow(std::unique_ptr<State> state);
  void deliver(const InputEvent& event);
  std::unique_ptr<State> state_;
};

/// Icons of the theme in `icons`/hicolor, in the sizes of title bars, task bars and switchers; empty where
/// they do not exist, in which case desktops use the menu entry's icon.
std::vector<Image> window_icons(const std::filesystem::path& icons);

}  // namespace hariko

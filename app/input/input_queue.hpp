#pragma once

// InputQueue: user input as values, and its division into batches for frames. No window, no ImGui.

#include <algorithm>
#include <array>
#include <deque>
#include <filesystem>
#include <utility>
#include <vector>

namespace hariko {

/// Event of the user. Keys, buttons and modifiers have GLFW's numbers.
struct InputEvent {
  /// Kinds of events; `leave` is the pointer leaving the window, `cap` the cap of a 3D mouse.
  enum class Kind { move, leave, button, wheel, key, text, cap, cap_button, focus, size, drop, close };
  Kind kind = Kind::move;
  double x = 0, y = 0;    ///< window coordinates (`move`, `size`) or steps (`wheel`)
  int code = 0;           ///< button, also of a 3D mouse; key by its place; character of `text`
  int meant = 0;          ///< code by the printed letter (`key`)
  bool down = false;      ///< pressed (`button`, `key`, `cap_button`) or gained (`focus`)
  bool repeated = false;  ///< repeated by the keyboard (`key`)
  int modifiers = 0;      ///< held modifiers (`button`, `key`)
  std::vector<std::filesystem::path> paths = {};  ///< dropped files (`drop`)

  /// Deflection of the cap, 1 at most: pushes along x, y, z and turns about them (`CapMotion`), and for how
  /// long.
  std::array<double, 6> cap = {};
  double seconds = 0;

  double came_at = 0;  ///< time; for merged moves that of the first

  friend bool operator==(const InputEvent&, const InputEvent&) = default;
};

/// Queue that divides input into batches. A frame sees the state of the pointer and the keys at one moment
/// only. So that nothing is lost or reordered when frames are slow, each frame gets a batch that one state
/// can describe: moves up to the first button, one press of a button, a release alone, keys none of which is
/// released in the same batch, motions of a 3D mouse by themselves. The effect of a gesture then does not
/// depend on the frame rate.
class InputQueue {
 public:
  void push(InputEvent event) { waiting_.push_back(std::move(event)); }
  bool empty() const { return waiting_.empty(); }
  void clear() { waiting_.clear(); }
  /// Batch for the next frame, in order; a move directly followed by another is omitted. With `keys_wait`
  /// keys and text stay queued, with everything after them, for a field that is about to get the keyboard
  /// focus.
  std::vector<InputEvent> take(bool keys_wait = false);

 private:
  std::deque<InputEvent> waiting_;
};

/// Clock of frames: a frame's time is that of its input, which slow frames handle late. The interval between
/// two clicks is thus the real one, not that of the frames that show them.
class FrameClock {
 public:
  /// Time, in seconds, of a frame that gets `batch` at the time `now`; never less than that of the last
  /// frame.
  double at(const std::vector<InputEvent>& batch, double now) const {
    return std::max(last_, batch.empty() ? now : batch.back().came_at);
  }
  /// Sets the last frame's time; returns the seconds since the one before.
  double tick(double time) { return time - std::exchange(last_, time); }

 private:
  double last_ = 0;
};

}  // namespace hariko

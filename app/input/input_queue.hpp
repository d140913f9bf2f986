#pragma once

// InputQueue: what the user does, as values, and which of it one frame may see. No window, no ImGui.

#include <algorithm>
#include <deque>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace hariko {

/// Keys, buttons and modifiers are numbered as in GLFW.
struct InputEvent {
  enum class Kind { move, leave, button, wheel, key, text, focus, size, drop, close };
  Kind kind = Kind::move;
  double x = 0, y = 0;    ///< of `move`: window coordinates; of `wheel`: steps; of `size`: window coordinates
  int code = 0;           ///< button; key by its place; character of `text`
  int meant = 0;          ///< of `key`: by what is printed on it
  bool down = false;      ///< of `button` and `key`; of `focus`: gained
  bool repeated = false;  ///< of `key`: the keyboard repeats it
  int modifiers = 0;      ///< of `button` and `key`
  std::vector<std::filesystem::path> paths = {};  ///< of `drop`

  double came_at = 0;  ///< when; of moves that were left out the first

  friend bool operator==(const InputEvent&, const InputEvent&) = default;
};

/// A frame sees the state of the pointer and the keys at one moment only. So that nothing is lost or
/// reordered when frames are slow, each frame gets a batch that one state can describe: moves up to the first
/// button, one press of a button, the end of a press alone, keys of which none goes up again. What a gesture
/// does then does not depend on the frame rate.
class InputQueue {
 public:
  void push(InputEvent event) { waiting_.push_back(std::move(event)); }
  bool empty() const { return waiting_.empty(); }
  void clear() { waiting_.clear(); }
  /// The batch of the next frame, in order; moves that another one follows are left out. With `keys_wait`
  /// keys and text stay, and what came after them: a field that is about to get the keyboard is to have them.
  std::vector<InputEvent> take(bool keys_wait = false);

 private:
  std::deque<InputEvent> waiting_;
};

/// The time that a frame goes by: that of what the user did, which slow frames come to late. So two clicks
/// are as far apart as they came, not as the frames that show them.
class FrameClock {
 public:
  /// Seconds, of a frame that sees `batch` at the time `now`. Never less than that of the last frame.
  double at(const std::vector<InputEvent>& batch, double now) const {
    return std::max(last_, batch.empty() ? now : batch.back().came_at);
  }
  /// Makes it the last frame's; gives the seconds since the one before.
  double tick(double time) { return time - std::exchange(last_, time); }

 private:
  double last_ = 0;
};

}  // namespace hariko

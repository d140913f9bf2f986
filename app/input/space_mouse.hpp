#pragma once

// SpaceMouse: the events of a 3D mouse, where the program was built with libspnav and its daemon runs.

#include <functional>
#include <memory>
#include <vector>

#include "app/input/input_queue.hpp"

namespace hariko {

/// Listener on a thread of its own. Without the library or the daemon it has no thread and never any event,
/// and nothing is printed.
class SpaceMouse {
 public:
  /// `wake`: called from the thread whenever there are new events.
  explicit SpaceMouse(std::function<void()> wake);
  ~SpaceMouse();
  SpaceMouse(const SpaceMouse&) = delete;
  SpaceMouse& operator=(const SpaceMouse&) = delete;

  /// Events since the last call, of the kinds `cap` and `cap_button`, in order.
  std::vector<InputEvent> take();

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;  ///< null where nothing is listened to
};

/// Event of a motion as the daemon tells it: whole numbers, about 350 at full deflection, x to the right, y
/// up, z away from the viewer, with turns that are left-handed about x and y; `period`: milliseconds since
/// the last one.
InputEvent cap_event(const std::array<int, 3>& push, const std::array<int, 3>& turn, unsigned period);

}  // namespace hariko

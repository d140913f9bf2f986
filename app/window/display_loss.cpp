#include "app/window/display_loss.hpp"

#include <X11/Xlib.h>
#include <unistd.h>

#include <atomic>

namespace hariko {

namespace {

/// Function for Xlib's handler, which has no user data and exists once in the process.
std::function<void()>& words() {
  static std::function<void()> action;
  return action;
}

int display_lost(Display*) {
  // Several threads may notice at once: the first one acts, the others wait for the end.
  static std::atomic_flag begun;
  if (begun.test_and_set())
    for (;;) ::pause();
  if (words()) words()();
  ::_exit(1);
}

}  // namespace

void on_display_loss(std::function<void()> last_words) {
  words() = std::move(last_words);
  ::XSetIOErrorHandler(display_lost);
}

}  // namespace hariko

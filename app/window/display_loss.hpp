#pragma once

// Reaction to a lost display: the X server ended, or the connection broke.

#include <functional>

namespace hariko {

/// Sets a function to be called before Xlib ends the process after the loss of the display. `last_words` runs
/// on the thread that noticed the loss, within a call of Xlib, and must not use the display. The process then
/// ends with exit code 1 and without destructors, which would use the display. An empty function: nothing is
/// called. For the main thread.
void on_display_loss(std::function<void()> last_words);

}  // namespace hariko

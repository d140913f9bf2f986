#pragma once

// What to do when the display goes away under the program: the X server ended, or the connection broke.

#include <functional>

namespace hariko {

/// Xlib ends the process then, whatever the program wants. Before that `last_words` is called, on the thread
/// that found out, within a call of Xlib: it must not use the display. The process ends with exit code 1
/// after it, and without destructors, as these would use the display. An empty function: nothing but the end.
/// For the main thread.
void on_display_loss(std::function<void()> last_words);

}  // namespace hariko

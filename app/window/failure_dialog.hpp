#pragma once

// What to do when no window can be opened: without OpenGL there is no interface of our own to say so.

#include "core/base/message.hpp"

namespace hariko {

/// Writes the message to stderr; where nobody reads that (the program was started from a desktop) it is shown
/// with zenity, kdialog or xmessage as well, whichever is installed. Does not wait for the dialog.
void report_failure(const Message& error);

}  // namespace hariko

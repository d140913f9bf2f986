#pragma once

// Report of a failure to open a window: without OpenGL the program cannot show it itself.

#include "core/base/message.hpp"

namespace hariko {

/// Writes the message to stderr; where that is no terminal (the program was started from a desktop) also
/// shows it with zenity, kdialog or xmessage, whichever is installed. Does not wait for the dialog.
void report_failure(const Message& error);

}  // namespace hariko

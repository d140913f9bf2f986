#pragma once

namespace hariko {

/// From now on a crash (a segmentation fault, a failed assertion and the like, also by an overflown stack on
/// this thread) writes the calls that led to it to the standard error before it ends the program as it would
/// have. What the user did is in the recovery file already. Once, at the start of the main thread.
void report_crashes();

}  // namespace hariko

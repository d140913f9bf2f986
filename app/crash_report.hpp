#pragma once

#include <filesystem>
#include <string_view>

namespace hariko {

/// From now on a crash (a segmentation fault, a failed assertion and the like, also by an overflown stack on
/// this thread) writes the calls that led to it to the standard error before it ends the program as it would
/// have. What the user did is in the recovery file already. Once, at the start of the main thread.
void report_crashes();

/// A crash also writes the report to this file from now on, below what `about` says of the program and its
/// surroundings. The file's folder is made now, where that is possible. From the main thread; again when more
/// is known.
void keep_crash_reports(const std::filesystem::path& file, std::string_view about);

}  // namespace hariko

#pragma once

// Crash handlers: reports of crashes, with the call stack.

#include <filesystem>
#include <string_view>

namespace hariko {

/// Installs crash handlers: a crash (a segmentation fault, a failed assertion and the like, also a stack
/// overflow on this thread) writes its call stack to the standard error before it ends the program as usual.
/// The user's work is already in the recovery file. To be called once, at the start of the main thread.
void report_crashes();

/// Makes a crash write its report also to this file, after `about`, a description of the program and its
/// surroundings. Creates the file's folder now, where possible. From the main thread; to be called again when
/// more is known.
void keep_crash_reports(const std::filesystem::path& file, std::string_view about);

}  // namespace hariko

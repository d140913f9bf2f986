#pragma once

// The temporary files that write_file_atomic writes beside its targets: their names, and what to do with
// those that a killed program left behind.

#include <cstddef>
#include <filesystem>
#include <string>

namespace hariko {

/// ".hariko-<process>-<number>.tmp": short, so that it fits wherever the target's own name fits.
std::string temporary_name(int number);

/// How old a temporary file must be to count as left behind: its writer locks it a moment after making it.
inline constexpr int stale_seconds = 10;

/// Removes temporary files of writers that are gone from a folder: regular files with a name of this form,
/// older than `stale_seconds`, whose process does not live on this machine, and that nobody holds a lock on
/// (for writers on other machines). Gives how many. Files that cannot be judged or removed stay.
std::size_t remove_stale_temporaries(const std::filesystem::path& folder);

}  // namespace hariko

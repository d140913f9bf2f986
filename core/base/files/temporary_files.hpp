#pragma once

// Temporary files that write_file_atomic writes beside its targets: their names, and the removal of those
// that a killed program left behind.

#include <cstddef>
#include <filesystem>
#include <string>

namespace hariko {

/// Name of a temporary file, ".hariko-<process>-<number>.tmp": short, so that it fits wherever the target's
/// own name fits.
std::string temporary_name(int number);

/// Age in seconds from which a temporary file counts as left behind: its writer locks it a moment after
/// making it.
inline constexpr int stale_seconds = 10;

/// Removes temporary files that were left behind from a folder, and returns their number: regular files with
/// a name of this form, older than `stale_seconds`, whose process does not live on this machine, and that
/// nobody holds a lock on (for writers on other machines). Files that cannot be judged or removed stay.
std::size_t remove_stale_temporaries(const std::filesystem::path& folder);

}  // namespace hariko

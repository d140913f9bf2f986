#pragma once

// Advice in messages about files that cannot be read. Internal to core/exchange.

namespace hariko {

/// Advice for truncated files.
inline constexpr const char* remedy_cut = "The file was cut off: copy or export it again.";
/// Advice for faulty files.
inline constexpr const char* remedy_correct = "Correct the file, or export it again.";
/// Advice for files above a limit.
inline constexpr const char* remedy_reduce = "Reduce the model before importing it.";

}  // namespace hariko

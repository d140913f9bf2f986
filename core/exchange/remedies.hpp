#pragma once

// Advice in messages about files that cannot be read. Internal to core/exchange.

namespace hariko {

inline constexpr const char* remedy_cut = "The file was cut off: copy or export it again.";
inline constexpr const char* remedy_correct = "Correct the file, or export it again.";
inline constexpr const char* remedy_reduce = "Reduce the model before importing it.";

}  // namespace hariko

#pragma once

// Pasted paths: files that text from the clipboard names.

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_pasted_path{"E_PASTED_PATH"};

/// Files that one text names at most.
inline constexpr std::size_t most_pasted_paths = 256;

/// Files that a text names, one in each line, in its order: by absolute paths, by paths below `home` ("~/"),
/// or by file URIs of this machine, whose escapes are decoded; each may stand in quotes. Blank lines are
/// passed over. Empty where the text is something else: a line is no name that `known` takes, judged by the
/// name alone, or there is more than 1 MiB. Errors: E_PASTED_PATH where all lines are such names, but one of
/// them does not say where its file lies (relative, on another machine, with broken escapes, "~/" without a
/// home), or there are more than `most_pasted_paths`. O(length).
Result<std::vector<std::filesystem::path>> pasted_paths(
    std::string_view text, const std::filesystem::path& home,
    const std::function<bool(const std::filesystem::path&)>& known);

}  // namespace hariko

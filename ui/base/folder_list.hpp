#pragma once

// Folders as a file dialog shows them: their files, in an order, and places to go to. No ImGui.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

struct FolderEntry {
  std::string name;
  bool folder = false;
  std::uintmax_t size = 0;    ///< bytes, of files
  std::int64_t modified = 0;  ///< seconds since 1970, UTC; 0 where it cannot be told
};

enum class FolderOrder { name, size, modified };

/// The folders and those files that `matches`, without hidden ones; at most 10,000. Errors: E_FOLDER (it
/// cannot be read).
Result<std::vector<FolderEntry>> list_folder(
    const std::filesystem::path& folder, const std::function<bool(const std::filesystem::path&)>& matches);

/// Folders before files; names in natural order, which equal sizes and times fall back to. `descending` turns
/// the order of files and of folders round, each for itself.
void sort_entries(std::vector<FolderEntry>& entries, FolderOrder order, bool descending);

/// A usual place of files: a name and a folder that exists.
struct Place {
  std::string id;    ///< "home", "recent.0"
  std::string name;  ///< the folder's
  std::filesystem::path folder;
};

/// The home folder, those that the desktop names in `user-dirs.dirs` of `config` (desktop, documents,
/// downloads), the root, and up to five folders of `recent` files.
std::vector<Place> usual_places(const std::filesystem::path& home, const std::filesystem::path& config,
                                std::span<const std::filesystem::path> recent);

inline constexpr Code e_folder{"E_FOLDER"};

}  // namespace hariko

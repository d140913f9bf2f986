#pragma once

// Folders as a file dialog shows them: their files, in an order, and places to go to. No ImGui.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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

/// The folders and those files that `matches`, hidden ones where they are asked for; at most 10,000. Errors:
/// E_FOLDER (it cannot be read).
Result<std::vector<FolderEntry>> list_folder(const std::filesystem::path& folder,
                                             const std::function<bool(const std::filesystem::path&)>& matches,
                                             bool hidden = false);

/// Folders before files; names in natural order, which equal sizes and times fall back to. `descending` turns
/// the order of files and of folders round, each for itself.
void sort_entries(std::vector<FolderEntry>& entries, FolderOrder order, bool descending);

/// Number of the first entry whose name begins with what was typed, in capitals or not; nothing where none
/// does, or nothing was typed.
std::optional<std::size_t> first_beginning_with(std::span<const FolderEntry> entries, std::string_view typed);

/// A usual place of files: a name and a folder that exists.
struct Place {
  std::string id;    ///< "home", "mounted.0", "recent.0"
  std::string name;  ///< the folder's
  std::filesystem::path folder;
};

/// The home folder, those that the desktop names in `user-dirs.dirs` of `config` (desktop, documents,
/// downloads), the root, what is mounted where desktops put disks and sticks (up to eight, by `mounts`, the
/// text of /proc/self/mounts), and up to five folders of `recent` files.
std::vector<Place> usual_places(const std::filesystem::path& home, const std::filesystem::path& config,
                                std::span<const std::filesystem::path> recent,
                                const std::string& mounts = {});

inline constexpr Code e_folder{"E_FOLDER"};

}  // namespace hariko

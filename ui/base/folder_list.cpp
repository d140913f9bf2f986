#include "ui/base/folder_list.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <fstream>
#include <sstream>
#include <system_error>

#include "core/base/text/natural_order.hpp"

namespace hariko {

namespace fs = std::filesystem;

namespace {

std::int64_t unix_time(fs::file_time_type time) {
  // The clock of files has an epoch of its own; its distance from now is the same.
  const auto ago = fs::file_time_type::clock::now() - time;
  const auto then = std::chrono::system_clock::now().time_since_epoch() - ago;
  return std::chrono::duration_cast<std::chrono::seconds>(then).count();
}

/// The value of a line as XDG_DESKTOP_DIR="$HOME/Desktop"; empty where it is none.
fs::path user_folder(const std::string& line, const fs::path& home) {
  const std::size_t begin = line.find('"'), end = line.rfind('"');
  if (begin == std::string::npos || end <= begin) return {};
  const std::string value = line.substr(begin + 1, end - begin - 1);
  constexpr std::string_view start = "$HOME/";
  if (value.starts_with(start)) return home / value.substr(start.size());
  return value.starts_with("/") ? fs::path(value) : fs::path();
}

/// Text in which a backslash and three octal digits stand for a character, as "\040" for a space.
std::string without_octal(const std::string& text) {
  constexpr std::size_t digits = 3;
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string code = text[i] == '\\' ? text.substr(i + 1, digits) : std::string();
    const bool octal = code.size() == digits && code.find_first_not_of("01234567") == std::string::npos;
    out += octal ? static_cast<char>(std::stoi(code, nullptr, 8)) : text[i];
    if (octal) i += digits;
  }
  return out;
}

/// Folders where disks and sticks are mounted, in the order of the text.
std::vector<fs::path> mounted_folders(const std::string& mounts) {
  constexpr std::array<std::string_view, 3> usual{"/media/", "/run/media/", "/mnt/"};
  std::vector<fs::path> out;
  std::istringstream lines(mounts);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string device, folder, type;
    words >> device >> folder >> type;
    if (type == "tmpfs" || type == "overlay") continue;  // memory of programs, no disks
    folder = without_octal(folder);
    if (folder == "/mnt" || std::ranges::any_of(usual, [&](auto begin) { return folder.starts_with(begin); }))
      out.emplace_back(folder);
  }
  return out;
}

}  // namespace

Result<std::vector<FolderEntry>> list_folder(const fs::path& folder,
                                             const std::function<bool(const fs::path&)>& matches,
                                             bool hidden) {
  // Not every folder can be read, and none must be able to stop the program.
  std::error_code error;
  fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, error);
  if (error)
    return make_error(e_folder, "The folder " + folder.string() + " cannot be read: " + error.message() + ".",
                      "Choose another folder.");
  constexpr std::size_t most = 10'000;
  std::vector<FolderEntry> entries;
  for (; it != fs::directory_iterator() && entries.size() < most; it.increment(error)) {
    if (error) break;
    std::error_code unknown;
    FolderEntry entry{it->path().filename().string(), it->is_directory(unknown), 0, 0};
    if ((!hidden && entry.name.starts_with(".")) || (!entry.folder && !matches(it->path()))) continue;
    if (!entry.folder) entry.size = it->file_size(unknown);
    if (unknown) entry.size = 0;
    const auto time = it->last_write_time(unknown);
    if (!unknown) entry.modified = unix_time(time);
    entries.push_back(std::move(entry));
  }
  return entries;
}

void sort_entries(std::vector<FolderEntry>& entries, FolderOrder order, bool descending) {
  const auto before = [order](const FolderEntry& a, const FolderEntry& b) {
    if (order == FolderOrder::size && a.size != b.size) return a.size < b.size;
    if (order == FolderOrder::modified && a.modified != b.modified) return a.modified < b.modified;
    return natural_less(a.name, b.name);
  };
  std::stable_sort(entries.begin(), entries.end(), [&](const FolderEntry& a, const FolderEntry& b) {
    if (a.folder != b.folder) return a.folder;
    return descending ? before(b, a) : before(a, b);
  });
}

std::optional<std::size_t> first_beginning_with(std::span<const FolderEntry> entries,
                                                std::string_view typed) {
  if (typed.empty()) return {};
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  const auto begins = [&](const FolderEntry& entry) {
    return entry.name.size() >= typed.size() &&
           std::equal(typed.begin(), typed.end(), entry.name.begin(), same);
  };
  const auto found = std::ranges::find_if(entries, begins);
  if (found == entries.end()) return {};
  return static_cast<std::size_t>(found - entries.begin());
}

std::vector<Place> usual_places(const fs::path& home, const fs::path& config,
                                std::span<const fs::path> recent, const std::string& mounts) {
  std::vector<Place> places;
  const auto add = [&](std::string id, const fs::path& folder, bool surely = false) {
    std::error_code error;
    if (folder.empty() || (!surely && !fs::is_directory(folder, error))) return;
    const fs::path clean = folder.lexically_normal();
    const auto same = [&](const Place& place) { return place.folder == clean; };
    if (std::ranges::any_of(places, same)) return;
    const std::string name = clean.filename().string();
    places.push_back({std::move(id), name.empty() ? clean.string() : name, clean});
  };
  add("home", home);
  std::ifstream file(config / "user-dirs.dirs");
  constexpr std::array<std::array<std::string_view, 2>, 3> named{{{"XDG_DESKTOP_DIR=", "desktop"},
                                                                  {"XDG_DOCUMENTS_DIR=", "documents"},
                                                                  {"XDG_DOWNLOAD_DIR=", "downloads"}}};
  for (std::string line; std::getline(file, line);)
    for (const auto& [key, id] : named)
      if (line.starts_with(key)) add(std::string(id), user_folder(line, home));
  add("root", "/");
  // Not looked at: a share whose server does not answer would hold up the window.
  constexpr std::size_t most_mounted = 8;
  const std::vector<fs::path> mounted = mounted_folders(mounts);
  for (std::size_t i = 0; i < std::min(mounted.size(), most_mounted); ++i)
    add("mounted." + std::to_string(i), mounted[i], true);
  constexpr std::size_t most_recent = 5;
  std::size_t count = 0;
  for (const fs::path& path : recent) {
    if (count == most_recent) break;
    const std::size_t before = places.size();
    add("recent." + std::to_string(count), path.parent_path());
    if (places.size() > before) ++count;
  }
  return places;
}

}  // namespace hariko

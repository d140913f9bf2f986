#include "app/persistence/recent_files.hpp"

#include <nlohmann/json.hpp>
#include <system_error>

#include "core/base/files/file_io.hpp"
#include "core/base/files/file_uri.hpp"
#include "core/base/text/json_writer.hpp"

namespace hariko {

namespace {

using Json = nlohmann::json;
constexpr std::uint64_t largest_file = 1 << 20;  // bytes

}  // namespace

std::vector<RecentEntry> RecentFiles::read() const {
  std::vector<RecentEntry> entries;
  const auto text = read_file(file_, largest_file);
  if (!text) return entries;
  const Json json = Json::parse(*text, nullptr, false);
  const auto list = json.is_object() ? json.find("recent") : json.end();
  if (!json.is_object() || list == json.end() || !list->is_array()) return entries;
  for (const Json& item : *list) {
    if (!item.is_object() || !item.contains("uri") || !item["uri"].is_string()) continue;
    const auto path = path_of_uri(item["uri"].get<std::string>());
    const auto used_at = item.find("used_at");
    if (path)
      entries.push_back(
          {*path, used_at != item.end() && used_at->is_number_integer() ? used_at->get<std::int64_t>() : 0});
  }
  return entries;
}

std::vector<RecentEntry> RecentFiles::load() const {
  std::vector<RecentEntry> entries = read();
  std::erase_if(entries, [](const RecentEntry& entry) {
    std::error_code unknown;
    return !std::filesystem::is_regular_file(entry.path, unknown);
  });
  return entries;
}

Result<Done> RecentFiles::touch(const std::filesystem::path& path, std::int64_t now) const {
  // Missing files stay in the list: their disk may be back tomorrow.
  std::vector<RecentEntry> entries = read();
  std::erase_if(entries, [&](const RecentEntry& entry) { return entry.path == path; });
  entries.insert(entries.begin(), {path, now});
  if (entries.size() > most) entries.resize(most);
  JsonWriter json(2);
  json.object([&] {
    json.list("recent", entries, [&](const RecentEntry& entry) {
      json.object([&] {
        json.member("uri", file_uri(entry.path));
        json.member("used_at", entry.used_at);
      });
    });
  });
  std::error_code unknown;  // a failure shows when the file is written
  std::filesystem::create_directories(file_.parent_path(), unknown);
  return write_file_atomic(file_, json.take() + "\n");
}

}  // namespace hariko

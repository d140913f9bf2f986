#include "app/persistence/crash_reports.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <system_error>

#include "core/base/files/file_io.hpp"

namespace hariko {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view name_beginning = "crash-", name_ending = ".txt";
constexpr std::uint64_t largest_report = 1 << 20;  // bytes; a report has some kilobytes

bool is_report(const std::string& name) {
  if (!name.starts_with(name_beginning) || !name.ends_with(name_ending)) return false;
  const std::string_view process = std::string_view(name).substr(
      name_beginning.size(), name.size() - name_beginning.size() - name_ending.size());
  return !process.empty() && process.find_first_not_of("0123456789") == std::string_view::npos;
}

std::int64_t seconds_of(fs::file_time_type time) {
  using namespace std::chrono;
  return duration_cast<seconds>(file_clock::to_sys(time).time_since_epoch()).count();
}

}  // namespace

fs::path CrashReports::own_file() const {
  return folder_ / (std::string(name_beginning) + std::to_string(::getpid()) + std::string(name_ending));
}

std::vector<CrashReports::Found> CrashReports::all() const {
  std::vector<Found> out;
  std::error_code failed;  // inaccessible reports are not offered
  for (fs::directory_iterator it(folder_, failed), end; !failed && it != end; it.increment(failed)) {
    const auto written_at = it->last_write_time(failed);
    if (!failed && is_report(it->path().filename().string()))
      out.push_back({it->path(), seconds_of(written_at), {}});
  }
  std::sort(out.begin(), out.end(), [](const Found& a, const Found& b) {
    return a.written_at != b.written_at ? a.written_at > b.written_at : a.file < b.file;
  });
  return out;
}

std::optional<CrashReports::Found> CrashReports::latest() const {
  std::vector<Found> found = all();
  if (found.empty()) return std::nullopt;
  auto text = read_file(found.front().file, largest_report);
  if (text.ok()) found.front().text = std::move(text).value();
  return found.front();
}

void CrashReports::dismiss() const {
  std::error_code ignored;  // a report that could not be removed is offered again
  const std::vector<Found> found = all();
  for (std::size_t i = 0; i < found.size(); ++i)
    i == 0 ? fs::rename(found[i].file, folder_ / "crash.txt", ignored)
           : void(fs::remove(found[i].file, ignored));
}

}  // namespace hariko

#include "app/persistence/run_log.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <system_error>
#include <utility>

#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_text = 1000;  // bytes

std::string time_text() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  std::array<char, 32> text{};
  if (!::gmtime_r(&now, &utc)) return {};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

std::string without_home(std::string text, const std::string& home) {
  for (std::size_t at = 0; !home.empty() && (at = text.find(home, at)) != std::string::npos; ++at)
    text.replace(at, home.size(), "~");
  return text;
}

/// Appends a line by a single write, so that lines of several windows do not mix.
void append(const fs::path& file, const std::string& line) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK, 0600);
  if (descriptor < 0) return;
  [[maybe_unused]] const auto written = ::write(descriptor, line.data(), line.size());
  ::close(descriptor);
}

}  // namespace

RunLog::RunLog(fs::path folder) {
  if (!folder.empty()) file_ = std::move(folder) / "log.txt";
  if (const char* home = std::getenv("HOME"); home && std::string_view(home).size() > 1) home_ = home;
}

void RunLog::line(std::string_view what, std::string_view text) const noexcept {
  if (file_.empty()) return;
  try {
    std::error_code unknown;  // the file cannot be opened then either
    fs::create_directories(file_.parent_path(), unknown);
    if (const auto size = fs::file_size(file_, unknown); !unknown && size >= largest)
      fs::rename(file_, file_.parent_path() / "log.old.txt", unknown);
    append(file_, time_text() + " " + std::to_string(::getpid()) + " " + std::string(what) + " " +
                      sanitized_utf8(without_home(std::string(text), home_), longest_text) + "\n");
  } catch (const std::exception&) {
    // Not enough memory even for a line.
  }
}

std::string RunLog::tail(std::size_t bytes) const {
  std::ifstream in(file_, std::ios::binary | std::ios::ate);
  if (!in) return {};
  const auto size = static_cast<std::size_t>(in.tellg()), begin = size > bytes ? size - bytes : 0;
  std::string text(size - begin, '\0');
  in.seekg(static_cast<std::streamoff>(begin));
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  // Whole lines only.
  return begin == 0 ? text : text.substr(std::min(text.find('\n'), text.size() - 1) + 1);
}

}  // namespace hariko

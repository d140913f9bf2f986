#include "core/base/files/pasted_paths.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "core/base/files/file_uri.hpp"
#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {
namespace {

constexpr std::size_t longest_pasted_text = 1 << 20;

/// Line of a pasted text: its file, or why there is none.
struct PastedLine {
  std::filesystem::path name;  ///< tells the kind of file, whatever is wrong with the path
  std::optional<Message> error = {};
};

std::string_view without_blanks(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\f\v";
  const std::size_t first = line.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

std::string_view without_quotes(std::string_view line) {
  const bool quoted =
      line.size() >= 2 && line.front() == line.back() && (line.front() == '"' || line.front() == '\'');
  return quoted ? line.substr(1, line.size() - 2) : line;
}

Message no_place(std::string_view line, const std::string& why) {
  constexpr std::size_t longest = 120;
  return make_error(e_pasted_path, shortened(line, longest) + ": " + why,
                    "Copy the file in a file manager, or its whole path from the root folder on.");
}

bool is_file_uri(std::string_view line) {
  constexpr std::string_view file_scheme = "file:/";
  return line.size() >= file_scheme.size() &&
         std::equal(file_scheme.begin(), file_scheme.end(), line.begin(),
                    [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
}

/// Decoded path of a URI as RFC 8089 has them: "file:///a", "file:/a", "file://localhost/a".
PastedLine line_of_uri(std::string_view uri) {
  constexpr std::string_view file_scheme = "file:", own = "localhost";
  std::string_view path = uri.substr(file_scheme.size());
  std::string_view host;
  if (path.starts_with("//")) {
    path.remove_prefix(2);
    host = path.substr(0, path.find('/'));
    path.remove_prefix(host.size());
  }
  const std::optional<std::string> decoded = without_escapes(path);
  if (!decoded) return {path, no_place(uri, "The address has broken escapes (%).")};
  if (!host.empty() && host != own)
    return {*decoded, no_place(uri, "The address names a file of another computer.")};
  return {*decoded};
}

PastedLine line_of_text(std::string_view line, const std::filesystem::path& home) {
  if (is_file_uri(line)) return line_of_uri(line);
  if (line.starts_with('/')) return {line};
  if (line.starts_with("~/")) {
    if (home.is_absolute()) return {home / line.substr(2)};
    return {line, no_place(line, "The home folder (~) is not known.")};
  }
  if (line.find("://") != std::string_view::npos)
    return {line, no_place(line, "The address names no file of this computer.")};
  return {line, no_place(line, "The path is relative and does not say in which folder the file lies.")};
}

}  // namespace

Result<std::vector<std::filesystem::path>> pasted_paths(
    std::string_view text, const std::filesystem::path& home,
    const std::function<bool(const std::filesystem::path&)>& known) {
  std::vector<std::filesystem::path> files;
  if (text.size() > longest_pasted_text) return files;
  std::optional<Message> error;
  std::size_t names = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = without_quotes(without_blanks(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty()) continue;
    PastedLine read = line_of_text(line, home);
    if (!known(read.name)) return std::vector<std::filesystem::path>();
    if (++names > most_pasted_paths) continue;
    if (read.error && !error) error = std::move(read.error);
    files.push_back(std::move(read.name));
  }
  if (error) return *error;
  if (names > most_pasted_paths)
    return make_error(e_pasted_path,
                      "The clipboard names " + std::to_string(names) + " files; at most " +
                          std::to_string(most_pasted_paths) + " are taken at once.",
                      "Copy fewer files.");
  return files;
}

}  // namespace hariko

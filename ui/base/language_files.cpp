#include "ui/base/language_files.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>

#include "core/base/result.hpp"
#include "core/base/text/plural_forms.hpp"
#include "core/base/text/po_file.hpp"
#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_catalogue_header = 64 << 10, longest_language_name = 60;  // bytes

/// The first entry of a catalogue, up to the empty line behind it; empty where the file cannot be read.
std::string header_entry(const fs::path& path) {
  std::error_code unknown;
  // Reading a pipe would wait for ever.
  if (!fs::is_regular_file(path, unknown)) return {};
  std::ifstream in(path, std::ios::binary);
  std::string bytes(longest_catalogue_header, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  const std::size_t entry = bytes.find("msgstr");
  bytes.resize(std::min({bytes.find("\n\n", entry), bytes.find("\n\r\n", entry), bytes.size()}));
  return bytes;
}

/// "brazilian_portuguese" for "Brazilian Portuguese"; empty where it has other characters than Latin letters
/// and spaces.
std::string language_id(std::string_view english_name) {
  std::string id;
  for (const char c : english_name) {
    const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c == ' ' ? '_' : c;
    if (lower != '_' && (lower < 'a' || lower > 'z')) return {};
    id += lower;
  }
  return id;
}

Result<LanguageFile> read_language_file(const fs::path& path) {
  const auto refused = [&](const char* sentence) {
    return error_in_catalogue(path, make_error(e_catalogue, sentence, catalogue_remedy));
  };
  const std::string entry = header_entry(path);
  if (entry.empty()) return refused("The file cannot be read.");
  auto read = read_po(entry);
  if (!read) return error_in_catalogue(path, read.error());
  auto& header = read.value().header;
  if (header["Language"].empty()) return refused("The header has no field Language, such as \"pl\".");
  if (header["Content-Type"].find("charset=UTF-8") == std::string::npos)
    return refused("The header does not say that the file is UTF-8 (Content-Type).");
  LanguageFile file{language_id(header["X-English-Name"]), header["X-English-Name"], header["X-Native-Name"],
                    path};
  if (file.id.empty() || file.id.size() > longest_language_name)
    return refused("The header does not name the language in Latin letters (X-English-Name).");
  if (file.name.empty() || file.name.size() > longest_language_name)
    return refused("The header does not name the language in its own words (X-Native-Name).");
  if (auto forms = PluralForms::parse(header["Plural-Forms"]); !forms)
    return error_in_catalogue(path, forms.error());
  return file;
}

}  // namespace

Message error_in_catalogue(const fs::path& path, Message error) {
  error.text = sanitized_utf8(path.filename().string()) + ": " + error.text;
  return error;
}

const LanguageFile* find_language(const std::vector<LanguageFile>& files, std::string_view id) {
  const auto found = std::ranges::find_if(files, [&](const auto& file) { return file.id == id; });
  return found == files.end() ? nullptr : &*found;
}

LanguageFiles find_languages(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".po") paths.push_back(it->path());
  std::sort(paths.begin(), paths.end());
  LanguageFiles found;
  for (const fs::path& path : paths) {
    auto file = read_language_file(path);
    if (!file)
      found.problems.push_back(file.error());
    else if (file->id == english_id || find_language(found.files, file->id))
      found.problems.push_back(error_in_catalogue(
          path, make_error(e_catalogue, "There is another catalogue of this language (X-English-Name).",
                           catalogue_remedy)));
    else
      found.files.push_back(*std::move(file));
  }
  std::sort(found.files.begin(), found.files.end(),
            [](const LanguageFile& a, const LanguageFile& b) { return a.id < b.id; });
  return found;
}

}  // namespace hariko

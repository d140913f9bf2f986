#pragma once

// Catalogues of a folder: the languages that can be chosen. Each is one file, which names its language, so
// that another language needs no code.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.hpp"

namespace hariko {

/// Setting of the language that needs no catalogue.
inline constexpr const char* english_id = "english";

/// Language as the header of its catalogue describes it.
struct LanguageFile {
  std::string id;  ///< id in settings and commands, by X-English-Name: "japanese"
  std::string english_name;
  std::string name;  ///< in the language itself, by X-Native-Name
  std::filesystem::path path;
};

struct LanguageFiles {
  std::vector<LanguageFile> files;  ///< by their ids
  std::vector<Message> problems;    ///< catalogues that cannot be chosen
};

/// Reads the headers of the catalogues (*.po) of a folder; a header ends at the first empty line. A folder
/// that is not there has none. O(files).
LanguageFiles find_languages(const std::filesystem::path& folder);

/// The file of a language; null where there is none.
const LanguageFile* find_language(const std::vector<LanguageFile>& files, std::string_view id);

/// Error of a catalogue's content, with the name of the file.
Message error_in_catalogue(const std::filesystem::path& path, Message error);

}  // namespace hariko

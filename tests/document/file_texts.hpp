#pragma once

// Texts of files that tests of the file format read, and messages that they expect.

#include <fstream>
#include <sstream>
#include <string>

#include "core/document/document.hpp"
#include "core/document/format/format.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {

/// Content of a file of the repository.
inline std::string file_text(const std::string& path) {
  std::ifstream file(source_folder() + "/" + path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::string message_of(const Result<Document>& result) {
  return result ? "fine" : to_string(result.error());
}

/// Text that this version writes of a document of an older one that nothing else changes in.
inline std::string as_written_now(std::string text, int version) {
  const std::string of = "\"version\": ";
  text.replace(text.find(of + std::to_string(version)), of.size() + 1, of + std::to_string(format_version));
  return text;
}

/// Rows of kept forms ended in three numbers of a force before version 6, and end in a lean and a part of a
/// side since.
inline std::string with_rows_of_forms_now(std::string text) {
  const std::pair<const char*, const char*> rows[] = {
      {"[0, 0, 0, 0, 0, 0.0078125, 0, 0, 0]", "[0, 0, 0, 0, 0, 0.0078125, 0, 0]"},
      {"[5, 0.25, -0.5, 0.125, 0, -0.0625, 0, 0.5, 150]", "[5, 0.25, -0.5, 0.125, 0, -0.0625, 0, 0]"},
      {"[7, -0.25, 0.5, 0, 0, 0, 0, 0, 0]", "[7, -0.25, 0.5, 0, 0, 0, 0, 0]"}};
  for (const auto& [before, now] : rows) text.replace(text.find(before), std::string(before).size(), now);
  return text;
}

}  // namespace hariko::test

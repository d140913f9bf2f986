#pragma once

// Catalogues of translations in the format of gettext (.po).

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_catalogue{"E_CATALOGUE"};
inline constexpr const char* catalogue_remedy =
    "Install the program's assets again, or mend the file. English is used until then.";

/// Text with its translation.
struct PoEntry {
  std::string context;                    ///< msgctxt: tells equal texts of different meanings apart
  std::string text;                       ///< msgid; with a plural, the text for one
  std::string plural;                     ///< msgid_plural; empty where there is none
  std::vector<std::string> translations;  ///< msgstr, or one for each form; all empty where it is missing
  bool fuzzy = false;                     ///< a guess that nobody has looked at, not to be shown
  std::size_t line = 0;                   ///< line of its first word, from 1

  bool translated() const;
};

struct PoFile {
  std::map<std::string, std::string> header;  ///< "Language" → "ja"
  std::vector<PoEntry> entries;               ///< in the order of the file, without the header
};

inline constexpr std::size_t largest_catalogue = std::size_t{16} << 20;  ///< bytes

/// Reads a catalogue: UTF-8, with a header as its first entry. Comments and obsolete entries are left out.
/// Errors: E_CATALOGUE with the line, for a text that is not closed, an unknown escape or word, a word in the
/// wrong place, a form that is missing, bytes that are not UTF-8, no header, and two entries with the same
/// text and context. O(size log size).
Result<PoFile> read_po(std::string_view bytes);

}  // namespace hariko

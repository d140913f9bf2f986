#pragma once

// Text of unknown encoding, made UTF-8.

#include <cstddef>
#include <string>
#include <string_view>

namespace hariko {

/// Text decoded from an unknown encoding.
struct DecodedText {
  std::string text;         ///< UTF-8
  bool marked = false;      ///< began with a byte order mark, which is removed
  std::size_t guessed = 0;  ///< bytes that are not UTF-8
  bool japanese = false;    ///< the guessed bytes were read as Shift-JIS
};

/// Treatment of bytes that are not UTF-8. `letters`: read as the legacy encoding that they seem to be in:
/// Windows-1252, or Shift-JIS where all of them form characters of it and most of these begin as its common
/// ones do, which Western text does not. `question_mark`: replaced by '?', which keeps the lengths that IGES
/// counts.
enum class StrayBytes { letters, question_mark };

/// Decodes the bytes of a file to UTF-8. UTF-16 is recognised by its mark; everything else is UTF-8 except
/// for stray bytes. O(size).
DecodedText decoded(std::string bytes, StrayBytes stray);

}  // namespace hariko

#pragma once

// Letters beyond ASCII in STEP and IGES files.

#include <cstddef>
#include <string>
#include <string_view>

namespace hariko {

/// Text of a file of unknown encoding.
struct DecodedText {
  std::string text;         ///< UTF-8
  bool marked = false;      ///< began with a byte order mark, which is gone
  std::size_t guessed = 0;  ///< bytes that are no UTF-8
  bool japanese = false;    ///< they were read as Shift-JIS
};

/// Bytes that are no UTF-8: as letters of the old encoding that they seem to be of (Windows-1252, or
/// Shift-JIS where all of them make characters of it and most of these begin as its common ones do, which
/// Western text does not), or as '?', which keeps the lengths that IGES counts.
enum class StrayBytes { letters, question_mark };

/// UTF-16 is known by its mark; everything else is UTF-8, but for stray bytes. O(size).
DecodedText decoded(std::string bytes, StrayBytes stray);

/// UTF-8 beyond ASCII as the control directives of ISO 10303-21 (\X2\....\X0\, \X4\........\X0\). O(size).
std::string with_step_directives(std::string_view text);

/// Each character beyond ASCII becomes '_': IGES has no others. O(size).
std::string ascii_name(std::string_view text);

}  // namespace hariko

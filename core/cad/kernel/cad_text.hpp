#pragma once

// What can be seen of STEP and IGES files before the kernel reads them: whether they are what they say they
// are, and whole. The kernel takes what is cut off for a smaller model.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

struct CadTextExtent {
  std::size_t end = 0;        ///< behind the last line that counts
  bool counts_agree = true;   ///< IGES: the last line gives the numbers of lines that there are
  bool more_follows = false;  ///< anything but blanks behind the end
};

/// E_CAD_READ where the text is no STEP file (ISO 10303-21), ends early, or nests its lists deeper than 100.
/// Signatures, which edition 3 puts behind the end, do not count as more that follows.
Result<CadTextExtent> check_step_text(std::string_view text);

/// E_CAD_READ where the text is no IGES file of fixed format, a line is not 80 columns with its section and
/// number, or lines are missing: the last line gives more of them than there are, and lines that are there
/// refer to them.
Result<CadTextExtent> check_iges_text(std::string_view text);

/// A file as the kernel is to read it.
struct CadText {
  std::string text;
  bool changed = false;  ///< otherwise than the file
  /// W_CAD_MARK, W_CAD_BEHIND, W_CAD_COUNTS, W_CAD_LETTERS.
  std::vector<Message> warnings;
};

/// Whole text without byte order mark and without what stands behind the end, in UTF-8; bytes of older
/// encodings become letters of Windows-1252 or Shift-JIS (STEP) or '?' (IGES). Errors: those of the checks.
Result<CadText> step_text_of(std::string bytes);
Result<CadText> iges_text_of(std::string bytes);

}  // namespace hariko

#pragma once

// Checks of the text of STEP and IGES files before the kernel reads them: right format, and complete. The
// kernel reads a truncated file as a smaller model.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

/// Extent of a file's valid text.
struct CadTextExtent {
  std::size_t end = 0;        ///< position behind the last line that counts
  bool counts_agree = true;   ///< IGES: the last line's counts of lines are right
  bool more_follows = false;  ///< anything but blanks follows the end
};

/// Checks STEP text (ISO 10303-21). E_CAD_READ where it is no such text, ends early, or nests lists deeper
/// than 100. Signatures, which edition 3 puts behind the end, do not count as `more_follows`. O(size).
Result<CadTextExtent> check_step_text(std::string_view text);

/// Checks IGES text. E_CAD_READ where it is not of the fixed format, a line is not 80 columns with its
/// section and number, or lines are missing: the last line counts more of them than there are, and existing
/// lines refer to them. O(size).
Result<CadTextExtent> check_iges_text(std::string_view text);

/// Text of a file, prepared for the kernel.
struct CadText {
  std::string text;
  bool changed = false;  ///< differs from the file
  /// Warnings W_CAD_MARK, W_CAD_BEHIND, W_CAD_COUNTS, W_CAD_LETTERS.
  std::vector<Message> warnings;
};

/// Checked text in UTF-8 without byte order mark and without what follows its end; bytes of legacy encodings
/// become letters of Windows-1252 or Shift-JIS (STEP) or '?' (IGES). Errors: those of the checks.
Result<CadText> step_text_of(std::string bytes);
Result<CadText> iges_text_of(std::string bytes);

}  // namespace hariko

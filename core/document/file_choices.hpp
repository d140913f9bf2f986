#pragma once

// How a document's lengths and directions stand in a file for other programs.

#include <optional>

#include "core/document/document.hpp"

namespace hariko {

/// Formats that fix the unit, the up axis or the encoding keep to theirs.
struct FileChoices {
  std::optional<Unit> unit;  ///< of the file's numbers; nothing: the document's
  double scale = 1;          ///< all lengths are multiplied by it; above 0, finite
  bool y_up = false;         ///< else z
  bool ascii = false;        ///< text; else binary, where the format has both
  bool to_zero = false;      ///< triangles: the middle of the box of all that is written comes to lie at zero

  friend bool operator==(const FileChoices&, const FileChoices&) = default;
};

}  // namespace hariko

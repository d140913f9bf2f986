#pragma once

// Conversion of a document's lengths and directions for files of other programs.

#include <optional>

#include "core/document/document.hpp"

namespace hariko {

/// Export choices. Formats that prescribe the unit, the up axis or the encoding ignore them.
struct FileChoices {
  std::optional<Unit> unit;  ///< unit of the file's numbers; nothing: the document's
  double scale = 1;          ///< factor of all lengths; greater than 0, finite
  bool y_up = false;         ///< y up; else z up
  bool ascii = false;        ///< text; else binary, where the format has both
  /// Triangles: moves the centre of the bounding box of everything written to the origin.
  bool to_zero = false;

  friend bool operator==(const FileChoices&, const FileChoices&) = default;
};

}  // namespace hariko

#pragma once

// DxfWriter: DXF text, as pairs of group code and value.

#include <string>
#include <string_view>
#include <utility>

#include "core/base/vector.hpp"

namespace hariko {

/// Writer of DXF in the version that every program reads (AC1009, release 12), in millimetres.
class DxfWriter {
 public:
  void pair(int code, std::string_view value);
  /// Number with nine decimals.
  void number(int code, double value);
  /// Coordinates with the codes `code`, `code` + 10 and `code` + 20.
  void point(int code, const Vector3& p);

  /// Opens a section or a table.
  void begin(std::string_view kind, std::string_view name);
  /// Opens the header and states version and unit in it.
  void begin_header();
  void end_table() { pair(0, "ENDTAB"); }
  void end_section() { pair(0, "ENDSEC"); }
  /// Ends the file and gives its text.
  std::string take();

 private:
  std::string text_;
};

}  // namespace hariko

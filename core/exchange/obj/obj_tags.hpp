#pragma once

// Crease and corner tags of subdivision surfaces in OBJ files. Internal to core/exchange.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/message.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {

/// Tags in the form of OpenSubdiv's files: `t crease 2/1/0 a b sharpness`, also with chains of more vertices,
/// and `t corner 1/1/0 v sharpness`. Vertices are counted from 0 over the whole file.
class ObjTags {
 public:
  /// Reads the rest of a statement `t`.
  void read(TextScanner& scanner);
  /// Edges with a sharpness above 0, in a file with this number of vertices; low vertex first.
  std::vector<std::array<Index, 2>> creases(std::size_t vertices) const;
  /// Vertices with a sharpness above 0, in a file with this number of vertices.
  std::vector<Index> corners(std::size_t vertices) const;
  /// Adds W_SOFT_CREASES where some tags are semi-sharp, W_LEFT_OUT where some are holes, and
  /// W_UNKNOWN_STATEMENT where some cannot be read.
  void warn(std::size_t vertices, std::vector<Message>& warnings) const;

 private:
  bool read_numbers(TextScanner& scanner, std::vector<std::int64_t>& vertices,
                    std::vector<double>& sharpness) const;

  std::vector<std::array<Index, 2>> creases_;
  std::vector<Index> corners_;
  std::size_t soft_ = 0, holes_ = 0, unread_ = 0;
};

}  // namespace hariko

#pragma once

// Tags of subdivision surfaces in OBJ files. Internal to core/exchange.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/message.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {

/// Creases and corners as OpenSubdiv's files have them: `t crease 2/1/0 a b sharpness`, chains of more
/// vertices too, and `t corner 1/1/0 v sharpness`, vertices counted from 0 over the whole file.
class ObjTags {
 public:
  /// The rest of a statement `t`.
  void read(TextScanner& scanner);
  /// Edges and vertices that are sharp at all, in a file of so many vertices.
  std::vector<std::array<Index, 2>> creases(std::size_t vertices) const;
  std::vector<Index> corners(std::size_t vertices) const;
  /// W_SOFT_CREASES where some are only partly sharp, W_UNKNOWN_STATEMENT where tags cannot be read.
  void warn(std::size_t vertices, std::vector<Message>& warnings) const;

 private:
  bool read_numbers(TextScanner& scanner, std::vector<std::int64_t>& vertices,
                    std::vector<double>& sharpness) const;

  std::vector<std::array<Index, 2>> creases_;
  std::vector<Index> corners_;
  std::size_t soft_ = 0, unread_ = 0;
};

}  // namespace hariko

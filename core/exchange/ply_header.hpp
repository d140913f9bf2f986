#pragma once

// The header of a PLY file. Internal to core/exchange.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a number in a binary file.
std::size_t ply_size(PlyType type);
bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list; always an integer type
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;  ///< not empty unless count is 0
  std::size_t line = 0;                 ///< in the header

  /// Position of a property in `properties`; their number when there is none.
  std::size_t find(std::string_view property) const;
};

enum class PlyFormat { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;  ///< names differ
  std::size_t size = 0;              ///< bytes up to the data
  std::size_t line_count = 0;
};

/// Reads and checks the header: `vertex` has scalar x, y, z and `face` and `tristrips` an integer list of
/// vertices where they exist.
Result<PlyHeader> read_ply_header(std::string_view bytes);

/// The list of vertices of element `face` or `tristrips`; the number of properties when there is none.
std::size_t ply_index_list(const PlyElement& face);

}  // namespace hariko

#pragma once

// Header of PLY files. Internal to core/exchange.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

/// Number types of PLY properties.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Size of a number in a binary file, bytes.
std::size_t ply_size(PlyType type);
/// Whether a type is an integer type.
bool is_integer(PlyType type);

/// Property of an element: a number or a list of numbers.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< type of a list's length; always an integer type
};

/// Element declared by the header: a table of rows.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;  ///< never empty unless `count` is 0
  std::size_t line = 0;                 ///< line in the header

  /// Position of a property in `properties`; their number where there is none.
  std::size_t find(std::string_view property) const;
};

/// Encodings of PLY files.
enum class PlyFormat { ascii, little_endian, big_endian };

/// Declarations of a PLY file.
struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;  ///< names are unique
  std::size_t size = 0;              ///< bytes before the data
  std::size_t line_count = 0;
};

/// Reads and checks a header: where they exist, `vertex` has scalar x, y, z, and `face` and `tristrips` an
/// integer list of vertices. Errors: E_PARSE, E_FORMAT_UNKNOWN, E_TRUNCATED, E_LIMIT, with the line. O(size +
/// elements^2).
Result<PlyHeader> read_ply_header(std::string_view bytes);

/// Position of the list of vertices in element `face` or `tristrips`; the number of properties where there is
/// none.
std::size_t ply_index_list(const PlyElement& face);

}  // namespace hariko

#pragma once

// Accessors: typed views of the buffers of glTF files. Internal to core/exchange.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Component types of accessors, by their codes in the file.
enum class GltfComponent : std::uint16_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

/// Component type with this code; nothing for other codes.
std::optional<GltfComponent> gltf_component(std::uint64_t code);
/// Size of a component, bytes.
std::size_t gltf_size(GltfComponent component);

/// Rows of numbers, `stride` bytes apart. `place` names the accessor in messages.
struct GltfAccessor {
  std::string_view bytes;  ///< from the first row to the end of the buffer view
  std::uint64_t count = 0, stride = 0;
  GltfComponent component = GltfComponent::float32;
  bool normalised = false;  ///< integers represent 0 .. 1 or -1 .. 1
  std::string place;
};

/// E_TRUNCATED where rows of `numbers_per_row` numbers would reach beyond the bytes. Allocates nothing.
std::optional<Message> check_rows(const GltfAccessor& accessor, std::size_t numbers_per_row);

/// Number of a row; requires that `check_rows` accepts the accessor. O(1).
double gltf_number(const GltfAccessor& accessor, std::uint64_t row, std::size_t column);
/// Points of an accessor that `check_rows` accepts. Errors: E_PARSE where a coordinate is not finite.
/// O(count).
Result<std::vector<Vector3>> gltf_points(const GltfAccessor& accessor);
/// Vertex indices from an accessor of unsigned integers that `check_rows` accepts, below `vertices`. Errors:
/// E_INDEX_RANGE. O(count).
Result<std::vector<Index>> gltf_indices(const GltfAccessor& accessor, std::uint64_t vertices);

}  // namespace hariko

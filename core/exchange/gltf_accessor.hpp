#pragma once

// Numbers in the buffers of glTF files. Internal to core/exchange.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Types of numbers, by their codes in the file.
enum class GltfComponent : std::uint16_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

/// The type with this code; nothing for others.
std::optional<GltfComponent> gltf_component(std::uint64_t code);
std::size_t gltf_size(GltfComponent component);

/// Rows of numbers, each `stride` bytes after the one before. `place` is what messages call it.
struct GltfAccessor {
  std::string_view bytes;  ///< from the first row to the end of the part of the buffer
  std::uint64_t count = 0, stride = 0;
  GltfComponent component = GltfComponent::float32;
  bool normalised = false;  ///< integers stand for 0 .. 1 or -1 .. 1
  std::string place;
};

/// E_TRUNCATED where rows of so many numbers lie beyond the bytes; nothing is allocated before.
std::optional<Message> check_rows(const GltfAccessor& accessor, std::size_t numbers_per_row);

/// A number of a row that `check_rows` accepts. O(1).
double gltf_number(const GltfAccessor& accessor, std::uint64_t row, std::size_t column);
/// Points of an accessor that `check_rows` accepts. Errors: E_PARSE where one is not finite. O(count).
Result<std::vector<Vector3>> gltf_points(const GltfAccessor& accessor);
/// Numbers of vertices of an accessor of unsigned integers that `check_rows` accepts. Errors: E_INDEX_RANGE.
/// O(count).
Result<std::vector<Index>> gltf_indices(const GltfAccessor& accessor, std::uint64_t vertices);

}  // namespace hariko

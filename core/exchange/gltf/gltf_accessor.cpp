#include "core/exchange/gltf/gltf_accessor.hpp"

#include <algorithm>
#include <bit>

#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/repair/remedies.hpp"

namespace hariko {
namespace {

std::uint32_t unsigned_at(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

/// Number at a byte position; normalised integers as in section 3.11 of the glTF 2.0 specification.
double number_at(const GltfAccessor& accessor, std::size_t at) {
  const std::uint32_t bits = unsigned_at(accessor.bytes, at, gltf_size(accessor.component));
  const bool normalised = accessor.normalised;
  switch (accessor.component) {
    case GltfComponent::int8: {
      const double value = static_cast<std::int8_t>(bits);
      return normalised ? std::max(value / 127, -1.0) : value;
    }
    case GltfComponent::uint8:
      return normalised ? bits / 255.0 : bits;
    case GltfComponent::int16: {
      const double value = static_cast<std::int16_t>(bits);
      return normalised ? std::max(value / 32767, -1.0) : value;
    }
    case GltfComponent::uint16:
      return normalised ? bits / 65535.0 : bits;
    case GltfComponent::uint32:
      return bits;
    case GltfComponent::float32:
      return std::bit_cast<float>(bits);
  }
  HARIKO_ASSERT(false, "unknown type of numbers");
  return 0;
}

}  // namespace

double gltf_number(const GltfAccessor& accessor, std::uint64_t row, std::size_t column) {
  return number_at(accessor, row * accessor.stride + column * gltf_size(accessor.component));
}

std::optional<GltfComponent> gltf_component(std::uint64_t code) {
  if (code < 5120 || code > 5126 || code == 5124) return {};
  return static_cast<GltfComponent>(code);
}

std::size_t gltf_size(GltfComponent component) {
  switch (component) {
    case GltfComponent::int8:
    case GltfComponent::uint8:
      return 1;
    case GltfComponent::int16:
    case GltfComponent::uint16:
      return 2;
    default:
      return 4;
  }
}

std::optional<Message> check_rows(const GltfAccessor& accessor, std::size_t numbers_per_row) {
  const std::uint64_t row = numbers_per_row * gltf_size(accessor.component), size = accessor.bytes.size();
  if (accessor.count == 0 || (row <= size && accessor.count - 1 <= (size - row) / accessor.stride)) return {};
  return make_error(e_truncated,
                    accessor.place + ": " + std::to_string(accessor.count) + " rows are promised, but only " +
                        std::to_string(size) + " bytes are there.",
                    "The file was cut off: copy or export it again.");
}

Result<std::vector<Vector3>> gltf_points(const GltfAccessor& accessor) {
  std::vector<Vector3> points(accessor.count);
  for (std::size_t row = 0; row < points.size(); ++row) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      points[row][static_cast<int>(axis)] = gltf_number(accessor, row, axis);
    if (!points[row].allFinite())
      return make_error(e_parse, accessor.place + ": Position " + std::to_string(row) + " is not finite.",
                        remedy_correct);
  }
  return points;
}

Result<std::vector<Index>> gltf_indices(const GltfAccessor& accessor, std::uint64_t vertices) {
  const std::size_t size = gltf_size(accessor.component);
  std::vector<Index> indices(accessor.count);
  for (std::size_t row = 0; row < indices.size(); ++row) {
    indices[row] = unsigned_at(accessor.bytes, row * accessor.stride, size);
    if (indices[row] >= vertices)
      return make_error(e_index_range,
                        accessor.place + ": Corner " + std::to_string(row) + " names vertex " +
                            std::to_string(indices[row]) + ", but there are " + std::to_string(vertices) +
                            " vertices, counted from 0.",
                        remedy_correct);
  }
  return indices;
}

}  // namespace hariko

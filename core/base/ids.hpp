#pragma once

// Stable names of elements: they survive edits, saving and reloading, unlike dense indices.

#include <cstdint>
#include <functional>
#include <string>

#include "core/base/message.hpp"

namespace hariko {

/// Name of a vertex; the default is no vertex.
struct VertexId {
  std::uint32_t value = 0xffffffffU;
  friend auto operator<=>(const VertexId&, const VertexId&) = default;
};

/// Name of a face; the default is no face.
struct FaceId {
  std::uint32_t value = 0xffffffffU;
  friend auto operator<=>(const FaceId&, const FaceId&) = default;
};

/// Name of an edge: its two vertices. On a manifold no two edges join the same pair, so the pair is as stable
/// as the vertices are. Always low < high.
struct EdgeId {
  VertexId low, high;

  static EdgeId of(VertexId a, VertexId b) { return a < b ? EdgeId{a, b} : EdgeId{b, a}; }
  static EdgeId from_packed(std::uint64_t packed) {
    return {{static_cast<std::uint32_t>(packed >> 32)}, {static_cast<std::uint32_t>(packed)}};
  }
  /// One number for tables and messages; `from_packed` is the inverse.
  std::uint64_t packed() const { return (std::uint64_t(low.value) << 32) | high.value; }
  friend auto operator<=>(const EdgeId&, const EdgeId&) = default;
};

/// Name of an object of a document; the default is no object.
struct ObjectId {
  std::uint32_t value = 0xffffffffU;
  friend auto operator<=>(const ObjectId&, const ObjectId&) = default;
};

/// Text of an edge's name, such as "12-13".
inline std::string to_string(const EdgeId& id) {
  return std::to_string(id.low.value) + "-" + std::to_string(id.high.value);
}

/// Element of a message about a vertex, face, edge or object.
inline Element element_of(VertexId id) {
  return {Element::Kind::vertex, id.value};
}
inline Element element_of(FaceId id) {
  return {Element::Kind::face, id.value};
}
inline Element element_of(EdgeId id) {
  return {Element::Kind::edge, id.packed()};
}
inline Element element_of(ObjectId id) {
  return {Element::Kind::object, id.value};
}

}  // namespace hariko

template <>
struct std::hash<hariko::VertexId> {
  std::size_t operator()(hariko::VertexId id) const noexcept { return std::hash<std::uint32_t>{}(id.value); }
};
template <>
struct std::hash<hariko::FaceId> {
  std::size_t operator()(hariko::FaceId id) const noexcept { return std::hash<std::uint32_t>{}(id.value); }
};
template <>
struct std::hash<hariko::EdgeId> {
  std::size_t operator()(hariko::EdgeId id) const noexcept { return std::hash<std::uint64_t>{}(id.packed()); }
};

#pragma once

// Keys of edges and half-edges of meshes, for tables and sets.

#include <cstdint>

#include "core/base/vector.hpp"

namespace hariko {

/// Key of the half-edge from vertex `a` to vertex `b`.
inline std::uint64_t half_edge_key(Index a, Index b) {
  return (std::uint64_t(a) << 32) | b;
}
/// Key of the edge between two vertices, whichever comes first.
inline std::uint64_t edge_key(Index a, Index b) {
  return a < b ? half_edge_key(a, b) : half_edge_key(b, a);
}
/// Ends of a half-edge.
struct HalfEdgeEnds {
  Index from, to;
};
inline HalfEdgeEnds ends_of_key(std::uint64_t key) {
  return {static_cast<Index>(key >> 32), static_cast<Index>(key & 0xffffffffU)};
}

}  // namespace hariko

#pragma once

// FaceCheck: faults of a single polygon.

#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

enum class FaceFault : char { none, index_range, too_small, repeated_vertex };

/// Check of one face after the other of a mesh.
class FaceCheck {
 public:
  explicit FaceCheck(std::size_t vertex_count) : vertex_count_(vertex_count) {}
  /// First fault of a face, in the order of the enumeration. O(sides).
  FaceFault operator()(std::span<const Index> face);

 private:
  bool repeats(std::span<const Index> face);
  std::size_t vertex_count_;
  std::vector<Index> last_seen_;  ///< per vertex: number of the last large face that used it
  Index large_faces_ = 0;
};

/// Sound faces: 1 for every face without a fault of its own, 0 for the others.
std::vector<char> sound_faces(const PolygonMesh& mesh);

}  // namespace hariko

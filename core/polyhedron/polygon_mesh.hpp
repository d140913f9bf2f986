#pragma once

// PolygonMesh: the content of a mesh file, positions and polygons, unchecked.

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Polygon mesh: vertex cycles, counter-clockwise seen from outside. No invariant beyond the offsets: indices
/// may be out of range, faces degenerate. `Polyhedron::build` checks them.
struct PolygonMesh {
  std::vector<Vector3> positions;
  std::vector<Index> face_offsets{0};  ///< face f has corners [face_offsets[f], face_offsets[f + 1])
  std::vector<Index> face_vertices;    ///< vertex of each corner

  std::size_t face_count() const { return face_offsets.size() - 1; }
  std::span<const Index> face(std::size_t f) const {
    return {face_vertices.data() + face_offsets[f], face_vertices.data() + face_offsets[f + 1]};
  }
  void add_face(std::span<const Index> vertices) {
    face_vertices.insert(face_vertices.end(), vertices.begin(), vertices.end());
    face_offsets.push_back(static_cast<Index>(face_vertices.size()));
  }
  void add_face(std::initializer_list<Index> vertices) { add_face({vertices.begin(), vertices.size()}); }
};

/// Turns all faces round, so that they look the other way; their first corners stay. O(corners).
inline void reverse_faces(PolygonMesh& mesh) {
  const auto corner = [&](std::size_t place) {
    return mesh.face_vertices.begin() + static_cast<std::ptrdiff_t>(place);
  };
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    if (!mesh.face(f).empty())
      std::reverse(corner(mesh.face_offsets[f] + 1), corner(mesh.face_offsets[f + 1]));
}

}  // namespace hariko

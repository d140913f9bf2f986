#pragma once

// How the numbers of a file stand for lengths and directions of the document.

#include <cstddef>

#include "core/polyhedron/polygon_mesh.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

enum class UpAxis { z, y };

struct FileSpace {
  double factor = 1;  ///< numbers of the file for one of the document; above 0, finite
  UpAxis up = UpAxis::z;

  bool is_same() const { return factor == 1 && up == UpAxis::z; }
  /// The document's z becomes the file's up axis; nothing is mirrored.
  Vector3 turned(const Vector3& v) const { return up == UpAxis::z ? v : Vector3{v.x(), v.z(), -v.y()}; }
  Vector3 placed(const Vector3& v) const { return factor * turned(v); }
};

/// The mesh as it stands in the file. O(size).
/// Afterwards moved by `-zero`, which is a point of the file.
TriangleMesh in_space(const FileSpace& space, TriangleMesh mesh, const Vector3& zero = Vector3::Zero());
PolygonMesh in_space(const FileSpace& space, PolygonMesh mesh, const Vector3& zero = Vector3::Zero());

}  // namespace hariko

#pragma once

// Unit and up axis of a file relative to the document's.

#include <cstddef>

#include "core/polyhedron/polygon_mesh.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

/// Axis of a file that points upwards.
enum class UpAxis { z, y };

/// Map from the document's space to a file's: rotation of the up axis, and scale.
struct FileSpace {
  double factor = 1;  ///< file units per document unit; above 0, finite
  UpAxis up = UpAxis::z;

  /// Whether the map is the identity.
  bool is_same() const { return factor == 1 && up == UpAxis::z; }
  /// Direction in the file: the document's z becomes the file's up axis, without mirroring.
  Vector3 turned(const Vector3& v) const { return up == UpAxis::z ? v : Vector3{v.x(), v.z(), -v.y()}; }
  /// Point in the file.
  Vector3 placed(const Vector3& v) const { return factor * turned(v); }
};

/// Mesh in the file's space, then moved by `-zero`, a point of that space. O(size).
TriangleMesh in_space(const FileSpace& space, TriangleMesh mesh, const Vector3& zero = Vector3::Zero());
PolygonMesh in_space(const FileSpace& space, PolygonMesh mesh, const Vector3& zero = Vector3::Zero());

}  // namespace hariko

#pragma once

// MeshImport: what meshes become when they are opened or imported.

#include <cstddef>

namespace hariko {

enum class MeshUse {
  ask,       ///< a cage; from many faces on it is asked
  cage,      ///< a polyhedron, whose surface is made
  reference  ///< facets to trace and to measure, without a surface
};

struct MeshImport {
  MeshUse use = MeshUse::ask;
  bool creases = false;        ///< edges above the angle become creases
  double crease_degrees = 30;  ///< between the normals of their faces, 0 .. 180
  /// From more faces on a cage is slow to work with, and seldom meant.
  static constexpr std::size_t dense_faces = 5000;

  friend bool operator==(const MeshImport&, const MeshImport&) = default;
};

}  // namespace hariko

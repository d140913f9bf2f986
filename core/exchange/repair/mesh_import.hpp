#pragma once

// MeshImport: choices for meshes that are opened or imported.

#include <cstddef>

namespace hariko {

/// Kinds of objects that an imported mesh can become.
enum class MeshUse {
  ask,       ///< a cage; with more than `dense_faces` faces the user is asked
  cage,      ///< control polyhedron of a surface
  reference  ///< facets to trace and to measure, without a surface
};

/// Choices for imported meshes.
struct MeshImport {
  MeshUse use = MeshUse::ask;
  bool creases = false;        ///< edges above `crease_degrees` become creases
  double crease_degrees = 30;  ///< angle between the normals of the faces, 0 .. 180
  /// Number of faces above which a cage is slow to work with, and seldom intended.
  static constexpr std::size_t dense_faces = 5000;

  friend bool operator==(const MeshImport&, const MeshImport&) = default;
};

}  // namespace hariko

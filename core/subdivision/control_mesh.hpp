#pragma once

// ControlMesh: the control mesh of a subdivision surface; polygons with creases and corners.

#include <vector>

#include "core/base/result.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

inline constexpr Code e_control_mesh{"E_CONTROL_MESH"};

/// Sharpness from which an edge or a vertex stays sharp at every subdivision level.
inline constexpr double infinitely_sharp = 10;

/// Polygon mesh with sharp edges and corners, the input of Catmull-Clark subdivision.
struct ControlMesh {
  struct Crease {
    Index a = 0, b = 0;
    double sharpness = infinitely_sharp;
    friend bool operator==(const Crease&, const Crease&) = default;
  };
  struct Corner {
    Index vertex = 0;
    double sharpness = infinitely_sharp;
    friend bool operator==(const Corner&, const Corner&) = default;
  };
  PolygonMesh mesh;
  std::vector<Crease> creases;
  std::vector<Corner> corners;

  bool all_quads() const;
};

/// Checks that faces have at least three different vertices in range, that each edge occurs at most once in
/// each direction, and that positions are finite. Error: E_CONTROL_MESH.
Result<Done> check(const ControlMesh& mesh);

/// Whether both meshes give the same patches with the same weights: equal faces, creases and corners.
bool same_topology(const ControlMesh& a, const ControlMesh& b);

}  // namespace hariko

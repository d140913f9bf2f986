#pragma once

// ControlMesh: what subdivision starts from. Polygons with creases and corners.

#include <vector>

#include "core/base/result.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

inline constexpr Code e_control_mesh{"E_CONTROL_MESH"};

/// From this sharpness on an edge or a vertex stays sharp for ever.
inline constexpr double infinitely_sharp = 10;

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

/// Faces with at least three different vertices in range, an edge at most once in each direction, finite
/// positions. E_CONTROL_MESH otherwise.
Result<Done> check(const ControlMesh& mesh);

/// Both give the same patches with the same tables.
bool same_topology(const ControlMesh& a, const ControlMesh& b);

}  // namespace hariko

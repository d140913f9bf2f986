#pragma once

// Figures of a control mesh: counts, extraordinary vertices, and how well it could be fitted to limit points.

#include <map>
#include <string>

#include "core/skinning/subdivision_surface.hpp"

namespace hariko {

struct ControlMeshFigures {
  int vertices = 0, edges = 0, faces = 0;
  int quads = 0, triangles = 0, polygons = 0;  ///< polygons: five sides and more
  int euler = 0;
  int boundary_vertices = 0, nonmanifold_edges = 0;
  /// "i5" -> 4: interior vertices of valence 5; "b4": boundary vertices with 4 edges.
  std::map<std::string, int> extraordinary;
};
ControlMeshFigures figures(const PolygonMesh& mesh);

/// Ratio of the largest and smallest singular value of the matrix from control points to limit points. Dense
/// up to 600 vertices, by iteration above.
double limit_condition(const SubdivisionTopology& topology);

}  // namespace hariko

#pragma once

// Statistics of a control mesh: counts, extraordinary vertices, regular faces, and the condition of fitting
// it to limit points.

#include <map>
#include <string>

#include "core/subdivision/control_mesh.hpp"
#include "core/subdivision/subdivision_surface.hpp"

namespace hariko {

/// Counts of a control mesh.
struct ControlMeshFigures {
  int vertices = 0, edges = 0, faces = 0;
  int quads = 0, triangles = 0, polygons = 0;  ///< polygons: five sides and more
  int euler = 0;
  int boundary_vertices = 0, nonmanifold_edges = 0;
  /// Extraordinary vertices by kind, such as "i5" -> 4: four interior vertices of valence 5; "b4": boundary
  /// vertices with 4 edges.
  std::map<std::string, int> extraordinary;
};
/// Counts the elements of a mesh. O(n log n).
ControlMeshFigures figures(const PolygonMesh& mesh);

/// Number of regular faces: quads with four regular vertices, over each of which the surface is one bicubic
/// B-spline patch exactly. A vertex is regular if it is interior to four quads without creases, on the border
/// of two quads, or a corner of one. O(faces) expected.
std::size_t regular_face_count(const ControlMesh& control);

/// Condition number of the matrix from control points to limit points: the ratio of its largest and smallest
/// singular value. Dense up to 600 vertices, iterative above.
double limit_condition(const SubdivisionTopology& topology);

}  // namespace hariko

#pragma once

// Regular faces of a subdivision surface, which are exact bicubic B-spline patches.

#include <array>
#include <vector>

#include "core/subdivision/control_mesh.hpp"

namespace hariko {

/// Quad with four regular vertices, as the 4 x 4 control points of a uniform bicubic B-spline patch: point
/// (i, j) is points[4 j + i], i runs from corner 0 to corner 1 of the face, j from corner 0 to corner 3.
/// Beyond a border the points are reflections, which give the same surface.
struct RegularFace {
  Index face = 0;
  std::array<Vector3, 16> points;
};

/// Finds all regular faces. A vertex is regular if it is interior to four quads without creases, on the
/// border of two quads, or a corner of one. O(faces).
std::vector<RegularFace> regular_faces(const ControlMesh& mesh);

/// Position at (s, t) of the face, each 0 .. 1.
Vector3 evaluate(const RegularFace& face, double s, double t);

/// Rectangle of regular faces as one B-spline surface with uniform knots: (columns + 3) x (rows + 3) points,
/// row by row. faces[row * columns + column] are its faces.
struct SplineRectangle {
  Index columns = 0, rows = 0;
  std::vector<Vector3> points;
  std::vector<Index> faces;
};

/// Covers all regular faces by rectangles, as large as a greedy search finds them, each face once. A tube is
/// cut open where the search begins. O(faces x rectangle).
std::vector<SplineRectangle> spline_rectangles(const ControlMesh& mesh);

}  // namespace hariko

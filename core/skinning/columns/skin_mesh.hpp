#pragma once

// SkinMesh: the control mesh of a skin, with the meaning of its vertices.

#include <vector>

#include "core/skinning/columns/skin_plan.hpp"
#include "core/subdivision/control_mesh.hpp"

namespace hariko {

/// Meaning of a vertex: a point of a section, or a place on a line between two sections (smooth methods:
/// column `line` of row `row`). -1: not applicable.
struct SkinVertex {
  int section = -1, point = -1;
  int strip = -1, line = -1, row = -1;
};

/// Control mesh of a skin with its rows and lines.
struct SkinMesh {
  ControlMesh control;
  std::vector<SkinVertex> vertices;
  /// Vertices of the row of each section, in order.
  std::vector<std::vector<Index>> section_rows;
  /// Rows of each strip as places on the path, ends included (pleat).
  std::vector<std::vector<double>> rows;
  /// Vertex of line p on row q of each strip: representative[strip][q][p] (pleat).
  std::vector<std::vector<std::vector<Index>>> representative;
  /// Vertices where the lines of the merges of each strip meet, in the strip's order (pleat).
  std::vector<std::vector<Index>> merge_vertices;
  /// Points of interior sections that the surface's curve does not follow exactly, as (section, point).
  std::vector<std::pair<int, int>> inexact;
  /// Parameters of the columns (smooth): one row, or one per section.
  std::vector<std::vector<double>> parameters;
  /// Size of a regular grid of rows x columns, row by row (smooth); 0 otherwise.
  int grid_rows = 0, grid_columns = 0;
  std::vector<double> grid_places;  ///< places of the rows of that grid on the path
};

/// Reverses the orientation of all faces.
void flip_faces(PolygonMesh& mesh);
/// Six times the signed volume that a tube encloses with its ends closed by fans; the sign gives the
/// orientation of the faces.
double tube_volume(const PolygonMesh& mesh);

}  // namespace hariko

#pragma once

// The control mesh of a skin, with what its vertices mean.

#include <vector>

#include "core/skinning/control_mesh.hpp"
#include "core/skinning/skin_plan.hpp"

namespace hariko {

/// What a vertex stands for: a point of a section, or a place on a line between two sections (smooth methods:
/// column `line` of row `row`).
struct SkinVertex {
  int section = -1, point = -1;
  int strip = -1, line = -1, row = -1;
};

struct SkinMesh {
  ControlMesh control;
  std::vector<SkinVertex> vertices;
  /// The row of vertices of each section, in order.
  std::vector<std::vector<Index>> section_rows;
  /// Rows of each strip as places on the path, ends included (pleat).
  std::vector<std::vector<double>> rows;
  /// Vertex of line p on row q of each strip: representative[strip][q][p] (pleat).
  std::vector<std::vector<std::vector<Index>>> representative;
  /// Where the lines of the merges of each strip meet, in the strip's order (pleat).
  std::vector<std::vector<Index>> merge_vertices;
  /// Points of interior sections that the surface's curve does not follow exactly, as (section, point).
  std::vector<std::pair<int, int>> inexact;
  /// Parameters of the columns (smooth): one row, or one a section.
  std::vector<std::vector<double>> parameters;
  /// A regular grid of rows x columns, row by row (smooth); 0 otherwise.
  int grid_rows = 0, grid_columns = 0;
  std::vector<double> grid_places;  ///< of the rows of that grid on the path
};

/// Faces the other way round.
void flip_faces(PolygonMesh& mesh);
/// Six times the volume that a tube encloses with its ends closed by fans; the sign tells inside from
/// outside.
double tube_volume(const PolygonMesh& mesh);

}  // namespace hariko

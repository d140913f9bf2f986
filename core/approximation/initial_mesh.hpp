#pragma once

// The coarse mesh over a surface from which refinement starts.

#include <span>

#include "core/approximation/parameter_mesh.hpp"

namespace hariko {

/// Of a triangle `columns` count along every side.
struct PatchCells {
  int columns = 1, rows = 1;
};

/// Every patch as a grid of cells: two facets a square one (cut along the shorter diagonal), one a triangle,
/// welded along seams. Sides of T-joints are cut where their neighbours' sides end, and where neighbours have
/// other cells, both get the other's cuts. A side that is shrunk to a point gives pole corners. `cells`: one
/// a patch, or one for all. O(patches + seams + facets).
ParameterMesh grid_mesh(const Surface& surface, std::span<const PatchCells> cells);

/// The same, with more cells, at least 2 x 2 or 3 x 3, where facets would have two equal corners otherwise
/// (closed sides). Without cells patches are whole.
ParameterMesh initial_mesh(const Surface& surface, std::span<const PatchCells> cells = {});

}  // namespace hariko

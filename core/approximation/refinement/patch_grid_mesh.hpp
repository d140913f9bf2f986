#pragma once

// Initial mesh: the coarse mesh over a surface from which refinement starts.

#include <span>

#include "core/approximation/refinement/parameter_mesh.hpp"

namespace hariko {

/// Numbers of cells along the sides of a patch. For a triangle, `columns` applies to every side.
struct PatchCells {
  int columns = 1, rows = 1;
};

/// Grid mesh of a surface: every patch as a grid of cells, two facets per square (cut along the shorter
/// diagonal), one per triangle, welded along seams. Sides of T-joints are cut where their neighbours' sides
/// end, and where neighbours have different cells, both get the other's cuts. A side that is shrunk to a
/// point gives pole corners. `cells`: one per patch, or one for all. O(patches + seams + facets).
ParameterMesh grid_mesh(const Surface& surface, std::span<const PatchCells> cells);

/// Grid mesh with more cells, at least 2 x 2 or 3 x 3, where facets would otherwise have two equal corners
/// (closed sides). Without cells patches are whole.
ParameterMesh initial_mesh(const Surface& surface, std::span<const PatchCells> cells = {});

}  // namespace hariko

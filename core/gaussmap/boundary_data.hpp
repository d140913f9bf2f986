#pragma once

// BoundaryData: what is known at the boundary sites of a SphereMesh. Internal to core/gaussmap.

#include <vector>

#include "core/gaussmap/sphere_mesh.hpp"

namespace hariko {

/// One entry a boundary site. Lengths are relative to the outline's size, positions to its middle.
struct BoundaryData {
  std::vector<Vector3> points;
  std::vector<double> curvature;  ///< empty where it is not known
};

}  // namespace hariko

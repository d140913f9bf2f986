#pragma once

// BoundaryData: given data at the boundary sites of a SphereMesh. Internal to core/gaussmap.

#include <vector>

#include "core/gaussmap/sphere/spherical_delaunay.hpp"

namespace hariko {

/// One entry per boundary site. Lengths are relative to the outline's size, positions to its centre.
struct BoundaryData {
  std::vector<Vector3> points;
  std::vector<double> curvature;  ///< empty where unknown
};

}  // namespace hariko

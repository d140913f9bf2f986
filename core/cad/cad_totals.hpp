#pragma once

// Totals over several CAD models, before or after they are written.

#include <cstddef>

namespace hariko {

/// Counts and largest deviations over several CAD models.
struct CadTotals {
  std::size_t faces = 0;
  std::size_t exact = 0;      ///< faces that equal the surface, to rounding
  std::size_t unreached = 0;  ///< faces that do not keep the tolerance
  double distance = 0;        ///< largest measured between a surface and its faces, length
  double normal_jump = 0;     ///< largest across smooth edges, radians
  double curvature_jump = 0;  ///< largest relative curvature jump, over models with continuous curvature
  bool curvature = false;     ///< there are models with continuous curvature
  std::size_t control_points = 0;
  std::size_t left_out = 0;  ///< visible objects of reference facets, which CAD files do not hold

  bool all_exact() const { return exact == faces; }
};

}  // namespace hariko

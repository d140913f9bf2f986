#pragma once

// Original method of the paper: planes placed one after another (gaussmap.md 4). It does not converge and is
// kept for comparison. Internal to core/gaussmap.

#include "core/gaussmap/control_points.hpp"
#include "core/gaussmap/outlines/boundary_data.hpp"
#include "core/gaussmap/sphere/delaunay_refinement.hpp"

namespace hariko {

struct PaperResult {
  std::vector<double> support, curvature;  ///< at all sites
  std::vector<Vector3> points;
  /// Number of planes put at an end of their interval, because no position gives the area.
  Index clamped_count = 0;
  bool limited = false;  ///< ended at the largest number of points, not at the radius
};

/// Inserts sites into `insertion` until `smallest_radius` or `options.most_points`. `curvature_inside`: null
/// for the mean of the neighbours. Errors: E_K_UNREACHABLE (the planes enclose no volume), E_CANCELLED.
/// O(sites^2 log sites).
Result<PaperResult> insert_by_paper(SiteInsertion& insertion, const BoundaryData& boundary,
                                    double smallest_radius, const GaussOptions& options,
                                    const CancelToken& cancel);

}  // namespace hariko

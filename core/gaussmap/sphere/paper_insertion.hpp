#pragma once

// Original method of the paper: planes placed one after another (gaussmap.md 4). It does not converge and is
// kept for comparison. Internal to core/gaussmap.

#include "core/base/cancellation.hpp"
#include "core/gaussmap/outlines/boundary_data.hpp"
#include "core/gaussmap/sphere/delaunay_refinement.hpp"

namespace hariko {

inline constexpr Code e_curvature_unreachable{"E_K_UNREACHABLE"};

struct PaperResult {
  std::vector<double> support, curvature;  ///< at all sites
  std::vector<Vector3> points;
  /// Number of planes put at an end of their interval, because no position gives the area.
  Index clamped_count = 0;
  bool limited = false;  ///< ended at the largest number of points, not at the radius
};

/// Inserts sites into `insertion` until `smallest_radius` or `most_points`. The area of the facet that a new
/// plane cuts off determines its position; its curvature is the mean of the neighbours'. `boundary`: with
/// curvature. Errors: E_K_UNREACHABLE (the planes enclose no volume), E_CANCELLED. O(sites^2 log sites).
Result<PaperResult> insert_by_paper(SiteInsertion& insertion, const BoundaryData& boundary,
                                    double smallest_radius, Index most_points, const CancelToken& cancel);

}  // namespace hariko

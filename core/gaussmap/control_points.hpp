#pragma once

// Control points of the surface inside an outline (gaussmap.md; Yoshida and Kunii 1991).

#include <array>
#include <optional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/gaussmap/outlines/outline_check.hpp"

namespace hariko {

inline constexpr Code e_diverged{"E_DIVERGED"};
inline constexpr Code w_flipped{"W_FLIPPED"};
inline constexpr Code w_result_not_convex{"W_NOT_CONVEX_RESULT"};
inline constexpr Code w_too_many_points{"W_POINT_LIMIT"};
inline constexpr Code w_gap{"W_GAP"};
inline constexpr Code w_umbilic_used{"W_UMBILIC_USED"};
inline constexpr Code w_outline_method{"W_OUTLINE_METHOD"};

struct GaussOptions {
  GaussMode mode = GaussMode::curvature;
  CurvatureSign sign = CurvatureSign::positive;  ///< used only if the outline has no curvature
  /// Radius of the largest empty circle at which insertion ends, in median steps of the normals along the
  /// outline; > 0.
  double radius = 0.6;
  Index most_points = 20000;  ///< largest number of inserted points
  /// Number of rounds of `relaxed` (sites; not in mode paper) or `spread_evenly` (vertices in mode position,
  /// not in strips).
  int relaxation = 20;
  /// If set, radius is lowered until the distance between tangent planes and control points is nowhere larger
  /// than this length.
  std::optional<double> gap;
  bool mode_replaced = false;  ///< adds W_OUTLINE_METHOD, see `OutlineSettings`
};

/// Control points with their tangent planes. The outline's points come first, by their numbers.
struct ControlPoints {
  std::vector<Vector3> points, normals;
  std::vector<double> support;    ///< plane i is normal . x = support
  std::vector<double> curvature;  ///< Gaussian curvature
  Index boundary_count = 0;
  std::vector<std::array<Index, 3>> triangles;  ///< counter-clockwise seen from outside
  /// Largest distance between the polyhedron of the tangent planes and that of the control points; for
  /// positive curvature the surface lies between the two.
  double gap = 0;
  int iterations = 0;       ///< iterations of the solver, if it is iterative
  Index clamped_count = 0;  ///< mode paper: number of planes whose position had no solution
  /// Warnings: those of `check_outline`, of the mode's solver, and the W_ codes above.
  std::vector<Message> messages;
};

/// Computes the control points. Errors: the first one of `check_outline`, those of `SiteInsertion::begin` and
/// of the mode's solver, E_DIVERGED, E_CANCELLED.
Result<ControlPoints> control_points(const Outline& outline, const GaussOptions& options,
                                     const CancelToken& cancel = {});

}  // namespace hariko

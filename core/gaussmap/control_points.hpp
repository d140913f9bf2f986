#pragma once

// Control points of a surface from its outline (gaussmap.md; Yoshida and Kunii 1991).

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/gaussmap/outline_check.hpp"

namespace hariko {

inline constexpr Code e_diverged{"E_DIVERGED"};
inline constexpr Code w_flipped{"W_FLIPPED"};
inline constexpr Code w_result_not_convex{"W_NOT_CONVEX_RESULT"};
inline constexpr Code w_too_many_points{"W_POINT_LIMIT"};
inline constexpr Code w_gap{"W_GAP"};
inline constexpr Code w_umbilic_used{"W_UMBILIC_USED"};

/// How the size of a part of the Gauss sphere is taken (gaussmap.md 4).
enum class CellMeasure { solid_angle, gnomonic };

/// Mode paper: which area the plane's place is solved for (gaussmap.md 4).
enum class PaperRule {
  neighbour,       ///< the clipped facet of the neighbour with the largest relative excess: the paper's words
  all_neighbours,  ///< the mean of the solutions of all neighbours
  own_facet        ///< the facet of the new plane
};

struct GaussOptions {
  GaussMode mode = GaussMode::curvature;
  CurvatureSign sign = CurvatureSign::positive;  ///< used where the outline has no curvature
  /// Insertion ends when no empty circle has this radius, in median steps of the normals along the outline. >
  /// 0.
  double radius = 0.6;
  Index most_points = 20000;  ///< inserted ones
  /// Rounds of `relaxed` (sites; not mode paper) or `spread_evenly` (vertices of mode position, no strips).
  int relaxation = 20;
  /// Where set: radius is lowered until tangent planes and control points are nowhere further apart than this
  /// length.
  std::optional<double> gap;
  CellMeasure measure = CellMeasure::solid_angle;
  PaperRule rule = PaperRule::own_facet;
  /// Curvature at a unit normal, 1 / length^2, where it is known inside; modes minkowski and paper.
  std::function<double(const Vector3&)> curvature_inside;
};

/// The outline's points come first, by their numbers.
struct ControlPoints {
  std::vector<Vector3> points, normals;
  std::vector<double> support;    ///< plane i is normal . x = support
  std::vector<double> curvature;  ///< Gaussian
  Index boundary_count = 0;
  std::vector<std::array<Index, 3>> triangles;  ///< counter-clockwise from outside
  /// Largest distance between the tangent planes' polyhedron and the control points' one; for positive
  /// curvature the surface lies between the two.
  double gap = 0;
  int iterations = 0;             ///< of the solver, where it iterates
  Index clamped_count = 0;        ///< mode paper: planes whose place had no solution
  std::vector<Message> messages;  ///< warnings
};

/// Errors: those of `check_outline` (the first), of `SiteInsertion::begin`, of the mode's solver, E_DIVERGED,
/// E_CANCELLED.
Result<ControlPoints> control_points(const Outline& outline, const GaussOptions& options,
                                     const CancelToken& cancel = {});

}  // namespace hariko

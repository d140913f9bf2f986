#pragma once

// Checks of an outline before a surface is made from it (gaussmap.md 7).

#include <optional>
#include <vector>

#include "core/gaussmap/outlines/outline.hpp"

namespace hariko {

/// Method of computing the surface's control points (gaussmap.md 4).
enum class GaussMode { curvature, umbilic, paper, position };

inline constexpr Code e_outline_too_few{"E_TOO_FEW"};
inline constexpr Code e_outline_not_finite{"E_NAN"};
inline constexpr Code e_same_point{"E_DUP_POINT"};
inline constexpr Code e_zero_normal{"E_ZERO_NORMAL"};
inline constexpr Code e_same_normal{"E_DUP_NORMAL"};
inline constexpr Code e_coarse_normals{"E_COARSE"};
inline constexpr Code w_uneven_normals{"W_UNEVEN"};
inline constexpr Code e_normal_tangent{"E_NORMAL_TANGENT"};
inline constexpr Code w_normal_tangent{"W_NORMAL_TANGENT"};
inline constexpr Code e_no_curvature{"E_NO_K"};
inline constexpr Code e_zero_curvature{"E_K_ZERO"};
inline constexpr Code e_mixed_curvature{"E_K_SIGN"};
inline constexpr Code e_negative_curvature{"E_K_NEG"};
inline constexpr Code e_image_crosses{"E_IMAGE_SELF_X"};
inline constexpr Code e_not_convex{"E_NOT_CONVEX"};
inline constexpr Code w_not_convex{"W_NOT_CONVEX"};

/// Sign of the Gaussian curvature: like a dome or like a saddle. That of the curvature where it is given,
/// else the chosen one.
enum class CurvatureSign { positive, negative };

/// Returns all errors and warnings, in the order of gaussmap.md 7; without errors `control_points` can begin.
/// Where many points have the same fault, the worst is named and the others are counted. Elements are
/// vertices: the number of the point through all loops. O(points^2) for positive curvature, else near
/// O(points).
std::vector<Message> check_outline(const Outline& outline, GaussMode mode,
                                   CurvatureSign sign = CurvatureSign::positive);

/// First fault that prevents even a curve through the loops, in any mode: E_TOO_FEW, E_NAN, E_DUP_POINT,
/// E_ZERO_NORMAL. O(points).
std::optional<Message> unusable(const Outline& outline);

/// Sign of the outline's curvature where it has one, else `fallback`.
CurvatureSign curvature_sign(const Outline& outline, CurvatureSign fallback);
/// Unit normals of all points, by loop.
std::vector<std::vector<Vector3>> unit_normals(const Outline& outline);

}  // namespace hariko

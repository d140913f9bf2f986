#pragma once

// Criteria that a triangle mesh of a surface must satisfy, and the options of its construction.

#include <array>
#include <optional>
#include <vector>

#include "core/base/message.hpp"
#include "core/base/text/enum_words.hpp"
#include "core/base/vector.hpp"

namespace hariko {

inline constexpr Code e_mesh_nothing{"E_MESH_NOTHING"};      ///< no patches, or no tolerance
inline constexpr Code e_mesh_tolerance{"E_MESH_TOLERANCE"};  ///< not positive, not a number, or too small
inline constexpr Code e_mesh_surface{"E_MESH_SURFACE"};      ///< the surface has no area for facets
inline constexpr Code w_mesh_unreached{"W_MESH_UNREACHED"};  ///< facets above the tolerance remain
/// Balancing did not apply: vertices stay on the surface.
inline constexpr Code w_mesh_balanced{"W_MESH_BALANCED"};
inline constexpr Code w_mesh_limit{"W_MESH_LIMIT"};  ///< the limit of facets was reached

/// Luminance of a point with unit normal n: diffuse max(n . l, 0) + specular max(n . h, 0)^shininess, where h
/// is half-way between light and view. Directions need not be unit vectors; zero vectors are refused.
struct LuminanceModel {
  enum class Shading : std::uint8_t { flat, gouraud };
  Shading shading = Shading::gouraud;
  double diffuse = 0.7, specular = 0.3, shininess = 30;
  Vector3 view = {0, -1, 0};
  /// Directions of the lights; the error is the largest over all of them. Empty means six along the axes, so
  /// that the result does not depend on one light.
  std::vector<Vector3> lights = {};
};

/// Criteria: a facet satisfies them when each error is at most its tolerance. Criteria that are not set are
/// ignored.
struct MeshCriteria {
  /// Distance between the surface and the facets, in both directions; a length.
  std::optional<double> distance;
  /// Angle between the surface's normals and that of their facet; radians below pi / 2.
  std::optional<double> normal_angle;
  /// Angle between the normals of neighbouring facets, except at creases of the surface; radians below pi.
  std::optional<double> fold_angle;
  /// Difference of luminance, which ranges from 0 to about 1. Does not bound the shape: combine it with a
  /// distance.
  std::optional<double> luminance;
  LuminanceModel luminance_model = {};
  /// Greatest length of edges.
  std::optional<double> max_edge;
  /// Smallest angle of a facet; radians below pi / 3. Long facets are split for it where that helps; others
  /// stay and are counted.
  std::optional<double> min_angle;

  bool any() const { return distance || normal_angle || fold_angle || luminance || max_edge || min_angle; }
};

/// Rule for the edge of a facet that is split, and the place of the split.
enum class SplitRule : std::uint8_t {
  midpoint,  ///< the longest edge in the middle of its parameters
  halving,   ///< as in the paper, by the angle between the end normals; `gauss` where that does not converge
  gauss,     ///< the edge with the longest image on the Gauss sphere, where the image has half its length
  /// The edge with the largest integral of the square root of curvature, at half of it; for distances.
  curvature,
};
template <>
inline constexpr auto enum_words<SplitRule> = all_words<SplitRule>({{SplitRule::midpoint, "mid"},
                                                                    {SplitRule::halving, "halving"},
                                                                    {SplitRule::gauss, "gauss"},
                                                                    {SplitRule::curvature, "curvature"}});

/// Mesh from which refinement starts.
enum class MeshStart : std::uint8_t {
  patches,  ///< two facets per square patch, one per triangle
  /// Square patches cut into cells as long as their curvature allows; for distances, normal and fold angles.
  cells,
};
template <>
inline constexpr auto enum_words<MeshStart> = all_words<MeshStart>({{MeshStart::patches, "patches"},
                                                                    {MeshStart::cells, "cells"}});

/// Facets that are split along with a facet.
enum class Propagation : std::uint8_t {
  longest_path,  ///< neighbours with a longer edge first: better shapes
  direct,        ///< the neighbour at the edge only
};

/// Extent of the measurements on a finished mesh. The criteria hold in any case.
enum class MeshReport : std::uint8_t {
  none,   ///< no normals and no measured errors; longest edge and smallest angle only
  asked,  ///< normals, folds, and the errors of the criteria
  all,    ///< also distance and normal angle where they are not required
};

/// Criteria and options of a triangle mesh.
struct MeshOptions {
  MeshCriteria criteria;
  MeshStart start = MeshStart::patches;
  SplitRule split = SplitRule::midpoint;
  Propagation propagation = Propagation::longest_path;
  /// Optimises the mesh to fewer facets by flips, collapses and moves along the surface; many times slower.
  /// `start`, `split` and `propagation` then have no effect.
  bool optimise = false;
  /// Places vertices off the surface, so that the surface runs through the middle of its tolerance: about
  /// half as many facets as the optimised mesh. For surfaces that bend to one side everywhere (positive
  /// Gaussian curvature), under a distance; otherwise W_MESH_BALANCED, and the vertices stay on the surface.
  /// Borders are not interpolated.
  bool balanced = false;
  std::size_t facet_limit = 5'000'000;
  MeshReport report = MeshReport::asked;
};

/// Validity of the criteria for a surface of this size (the diagonal of its box): E_MESH_NOTHING without a
/// tolerance, E_MESH_TOLERANCE for tolerances that are not positive, not numbers, out of range, or below the
/// numerical accuracy (1e-7 of the size for lengths, 1e-6 for angles and luminance).
std::optional<Message> check_criteria(const MeshCriteria& criteria, double size);

}  // namespace hariko

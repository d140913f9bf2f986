#pragma once

// What a triangle mesh of a surface must satisfy, and how it is made.

#include <array>
#include <optional>
#include <vector>

#include "core/base/message.hpp"
#include "core/base/vector.hpp"

namespace hariko {

inline constexpr Code e_mesh_nothing{"E_MESH_NOTHING"};      ///< no patches, or no tolerance
inline constexpr Code e_mesh_tolerance{"E_MESH_TOLERANCE"};  ///< not positive, not a number, or too small
inline constexpr Code e_mesh_surface{"E_MESH_SURFACE"};      ///< the surface has no area to put facets on
inline constexpr Code w_mesh_unreached{"W_MESH_UNREACHED"};  ///< facets above the tolerance remain
inline constexpr Code w_mesh_balanced{"W_MESH_BALANCED"};    ///< vertices could not leave the surface
inline constexpr Code w_mesh_limit{"W_MESH_LIMIT"};          ///< the limit of facets was reached

/// Brightness of a point with unit normal n: diffuse max(n . l, 0) + specular max(n . h, 0)^shininess, where
/// h is half-way between light and view. Directions need not be unit; zero vectors are refused.
struct LuminanceModel {
  enum class Shading : std::uint8_t { flat, gouraud };
  Shading shading = Shading::gouraud;
  double diffuse = 0.7, specular = 0.3, shininess = 30;
  Vector3 view = {0, -1, 0};
  /// The error is the largest over all of them. None stands for six along the axes, so that it does not
  /// depend on the light.
  std::vector<Vector3> lights = {};
};

/// A facet satisfies the criteria when each error is at most its tolerance. What is not set is not asked for.
struct MeshCriteria {
  /// Between the surface and the facets, in both directions; a length.
  std::optional<double> distance;
  /// Between the surface's normals and that of their facet; radians below pi / 2.
  std::optional<double> normal_angle;
  /// Between the normals of neighbouring facets, creases of the surface apart; radians below pi.
  std::optional<double> fold_angle;
  /// Difference of brightness, which runs from 0 to about 1. Does not bound the shape: combine it with a
  /// distance.
  std::optional<double> luminance;
  LuminanceModel luminance_model = {};
  /// Length of edges.
  std::optional<double> max_edge;
  /// Smallest angle of a facet; radians below pi / 3. Long facets are split for it where that helps; others
  /// stay and are counted.
  std::optional<double> min_angle;

  bool any() const { return distance || normal_angle || fold_angle || luminance || max_edge || min_angle; }
};

/// Which edge of a facet is split, and where.
enum class SplitRule : std::uint8_t {
  midpoint,  ///< the longest edge in the middle of its parameters
  halving,   ///< as in the paper: by the angle between the end normals; `gauss` where that does not converge
  gauss,  ///< the edge with the longest image on the sphere of normals, where the image has half its length
  curvature,  ///< the edge with the largest integral of the square root of curvature, at its half; for
              ///< distances
};

/// Where refinement starts.
enum class MeshStart : std::uint8_t {
  patches,  ///< two facets a square patch, one a triangle
  cells,    ///< square patches cut into cells that are as long as their curvature lets them; for distances,
            ///< normal and fold angles
};

/// Which facets are split along with one.
enum class Propagation : std::uint8_t {
  longest_path,  ///< neighbours with a longer edge first: better shapes
  direct,        ///< the neighbour at the edge only
};

/// What is found out about a mesh that is made. The criteria hold whatever is reported.
enum class MeshReport : std::uint8_t {
  none,   ///< no normals and no measured errors; longest edge and smallest angle only
  asked,  ///< normals, folds, and the errors of the criteria
  all,    ///< also distance and normal angle where they are not asked for
};

struct MeshOptions {
  MeshCriteria criteria;
  MeshStart start = MeshStart::patches;
  SplitRule split = SplitRule::midpoint;
  Propagation propagation = Propagation::longest_path;
  /// Fewer facets by flips, collapses and moves along the surface; many times slower. `start`, `split`
  /// and `propagation` then have no effect.
  bool optimise = false;
  /// Vertices off the surface, so that it runs through the middle of its tolerance: about half of the
  /// optimised facets. For surfaces that bend one way everywhere (positive Gaussian curvature), under a
  /// distance; else W_MESH_BALANCED, and the vertices stay on the surface. Borders are not interpolated.
  bool balanced = false;
  std::size_t facet_limit = 5'000'000;
  MeshReport report = MeshReport::asked;
};

/// What is wrong with the criteria for a surface of this size (the diagonal of its box): E_MESH_NOTHING
/// without a tolerance, E_MESH_TOLERANCE for tolerances that are not positive, not numbers, out of range, or
/// below the numerical accuracy (1e-7 of the size for lengths, 1e-6 for angles and brightness).
std::optional<Message> check_criteria(const MeshCriteria& criteria, double size);

}  // namespace hariko

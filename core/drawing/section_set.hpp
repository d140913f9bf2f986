#pragma once

// Sets of parallel section planes through surfaces: the curves that they cut, with their curvature.

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/drawing/line_drawing.hpp"

namespace hariko {

inline constexpr Code e_sections_empty{"E_SECTIONS_EMPTY"};
inline constexpr Code e_sections_planes{"E_SECTIONS_PLANES"};

/// Set of parallel planes: plane k holds the points p with direction . p = first + k spacing.
struct SectionPlanes {
  Vector3 direction = Vector3::UnitX();  ///< unit
  double first = 0;                      ///< world, along the direction
  double spacing = 10;                   ///< > 0; does not count where there is one plane
  int count = 7;                         ///< 1 .. most

  static constexpr int most = 200;
  double offset(int plane) const { return first + plane * spacing; }
  friend bool operator==(const SectionPlanes&, const SectionPlanes&) = default;
};

/// Planes across a direction (not zero), spread evenly over a box that is not empty: half a spacing is left
/// before the first one and behind the last one.
SectionPlanes spread_planes(const Vector3& direction, int count, const Eigen::AlignedBox3d& box);

/// Axes of the planes as columns x, y, direction; right-handed. y is as near to world z as it can be, to
/// world y where the planes are level.
Matrix3 section_axes(const Vector3& direction);

/// Curve in one of the planes.
struct SectionCurve {
  int plane = 0;
  std::size_t surface = 0;      ///< number of the surface that it lies on
  std::vector<Vector3> points;  ///< world, at least two; a closed curve repeats its first point at the end
  /// Curvature vector of the curve in its plane, reversed to point away from the centre of curvature,
  /// 1/length: one for each point. Where curvature jumps there are two points at the same place.
  std::vector<Vector3> teeth;
  bool closed = false;
};

/// Curves of a set of planes, ordered by surface, then by plane.
struct SectionSet {
  SectionPlanes planes;
  std::vector<SectionCurve> curves;
  double size = 0;      ///< diagonal of the box round all surfaces
  double typical = 0;   ///< curvature that 95 % of the length of all curves do not exceed, 1/length
  double greatest = 0;  ///< greatest curvature, 1/length
};

/// Curves in which planes cut surfaces. On patches they lie on the surface itself, with points about 1/300 of
/// its size apart, and their curvature is exact: by Meusnier's theorem the normal curvature along the curve
/// over the sine of the angle between plane and surface; zero where the plane touches the surface. On flat
/// facets it is that of circles through three points of the curve, eight mean segments apart.
///
/// Curves of a surface without border are closed, also where vertices, edges and faces lie in a plane: these
/// count as above it, so a face in the plane has its border once where the surface goes on below, and none
/// where it goes on above. Facets lie in a plane within 1e-12 of the size, patches within 1e-9 (or within the
/// rounding of coordinates far from zero). Curves of an open surface end on its border. Errors:
/// E_SECTIONS_PLANES (a direction that is no unit vector, numbers out of their range or not finite),
/// E_SECTIONS_EMPTY where no plane meets a surface, E_CANCELLED. Deterministic on any number of threads.
/// O(planes * patches + points).
Result<SectionSet> section_set(std::span<const DrawnSurface> surfaces, const SectionPlanes& planes,
                               const CancelToken& cancel = {}, const Progress& progress = {});

/// Choice of combs; one scale for all curves.
struct SectionCombs {
  bool shown = true;
  double scale = 1;  ///< factor of the automatic length of the teeth
  static constexpr double least_scale = 0.01, most_scale = 100;
  friend bool operator==(const SectionCombs&, const SectionCombs&) = default;
};
/// Length of a tooth where the curvature is 1, the same for all curves: at scale 1 the typical tooth is 6 %
/// of the size, and no tooth is longer than 15 %. Zero where all curves are straight.
double tooth_length(const SectionSet& set, double scale);

/// Comb of a curve as lines in the world: teeth at equal steps of the arc length, about 1/150 of the size
/// apart, and the line through all tips.
struct CombShape {
  std::vector<std::array<Vector3, 2>> teeth;  ///< foot and tip
  std::vector<Vector3> tips;                  ///< one for each point of the curve
};
CombShape comb_shape(const SectionCurve& curve, double size, double length);

}  // namespace hariko

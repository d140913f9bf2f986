#pragma once

// Scenes with a ball in parts of their size, and measurements on the ball's surfaces.

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/index_list.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

/// Same scene with method `ball`. Radius and rounding are parts of the scene's size; a radius of 0 is the
/// hull.
inline EnvelopeInput with_ball(EnvelopeInput input, double radius, double rounding) {
  const double size = solids_size(input.solids);
  input.settings.method = EnvelopeMethod::ball;
  input.settings.rounding = rounding * size;
  input.settings.ball_radius.reset();
  if (radius > 0) input.settings.ball_radius = radius * size;
  return input;
}

/// Distance from a point inside, along a direction, to the field's zero.
inline double reach(const SplineField& field, const Vector3& from, const Vector3& direction, double far) {
  double low = 0, high = far;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (field.value(from + middle * direction) < 0 ? low : high) = middle;
  }
  return low;
}

/// Points of a grid on every patch, relative to the surface's origin.
inline std::vector<Vector3> grid_points(const Surface& surface, int intervals) {
  if (surface.patch_count() == 0) return {};
  const GridPattern pattern{surface.domain(), intervals};
  const std::vector<Index> all = ascending_indices(surface.patch_count());
  std::vector<Vector3> points(all.size() * std::size_t(pattern.point_count())), normals(points.size());
  surface.patches().evaluate_grid(all, pattern, points, normals);
  return points;
}

/// Largest distance of the patches from the field's zero, a length.
inline double deviation_of(const BallEnvelope& made) {
  return std::max(made.outward, made.inward);
}

/// Largest curvatures of a field's level surfaces at points of the patches, 1/length, at least 0.
struct LargestCurvatures {
  double convex = 0, concave = 0;
};
inline LargestCurvatures largest_curvatures(const BallEnvelope& made) {
  LargestCurvatures out;
  for (const Vector3& p : grid_points(made.surface, 4)) {
    const LevelCurvature level = level_curvature(made.field, p);
    const Matrix3 flat = Matrix3::Identity() - level.normal * level.normal.transpose();
    const Matrix3 form = flat * level.form * flat;
    const double mean = 0.5 * form.trace(), gauss = 2 * mean * mean - 0.5 * (form * form).trace();
    const double apart = std::sqrt(std::max(0.0, mean * mean - gauss));
    out.convex = std::max(out.convex, apart - mean);
    out.concave = std::max(out.concave, apart + mean);
  }
  return out;
}

/// Shapes of a scene's solids, relative to a surface's origin.
inline std::vector<SolidShape> shapes_about(const std::vector<Solid>& solids, const Vector3& origin) {
  std::vector<SolidShape> out;
  for (const Solid& solid : solids) out.emplace_back(solid, origin);
  return out;
}

}  // namespace hariko::test

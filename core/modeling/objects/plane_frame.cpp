#include "core/modeling/objects/plane_frame.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/geometry/polygon.hpp"
#include "core/skinning/sections/section_frame.hpp"

namespace hariko {

namespace {

Message points_in_line() {
  return make_error(e_plane_in_line, "The points lie in a line, which gives no plane.",
                    "Choose points that span a plane.");
}

}  // namespace

std::optional<double> where_ray_meets(const PlaneFrame& plane, const Vector3& origin,
                                      const Vector3& direction, double least_slope) {
  const double slope = plane.normal().dot(direction);
  if (!(std::abs(slope) >= least_slope)) return {};
  return plane.normal().dot(plane.point - origin) / slope;
}

PlaneFrame upright_plane(const Vector3& point, const Vector3& normal) {
  return {point, upright_axes(-normal)};
}

Result<PlaneFrame> plane_through(const Vector3& zero, const Vector3& on_x, const Vector3& third) {
  constexpr double least_sine = 1e-9;
  const Vector3 along = on_x - zero, aside = third - zero;
  const Vector3 normal = along.cross(aside);
  if (!(normal.norm() > least_sine * along.norm() * aside.norm())) return points_in_line();
  PlaneFrame frame;
  frame.point = zero;
  frame.axes.col(0) = along.normalized();
  frame.axes.col(2) = normal.normalized();
  frame.axes.col(1) = frame.axes.col(2).cross(frame.axes.col(0));
  return frame;
}

Result<PlaneFrame> plane_of_polygon(std::span<const Vector3> corners) {
  constexpr double least_area = 1e-9;  // share of the extent squared
  if (corners.size() < 3) return points_in_line();
  double extent = 0;
  for (const Vector3& corner : corners) extent = std::max(extent, (corner - corners[0]).squaredNorm());
  const Vector3 normal = newell_normal(corners);
  if (!(normal.norm() > least_area * extent)) return points_in_line();
  return upright_plane(polygon_centre(corners), normal.normalized());
}

PlaneFrame plane_of_section(const Skin& skin, const SkinSection& section) {
  const Vector3 direction = section_direction_of_view(skin, section);
  return {evaluate(skin.path, section.v).position, upright_axes(direction)};
}

}  // namespace hariko

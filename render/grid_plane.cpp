#include "render/grid_plane.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

/// Axis that a direction runs along, or nothing.
std::optional<int> axis_of(const Vector3& direction) {
  constexpr double aslant = 1e-5;  // radians
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  Vector3 rest = direction;
  rest[axis] = 0;
  return rest.norm() < aslant ? std::optional(static_cast<int>(axis)) : std::nullopt;
}

}  // namespace

std::optional<SidePlane> side_plane(const Camera& camera) {
  if (!camera.orthographic) return std::nullopt;
  const auto across = axis_of(camera.right()), up = axis_of(camera.up());
  if (!across || !up) return std::nullopt;
  return SidePlane{*across, *up};
}

GridLines grid_lines(const GridSettings& grid, double height) {
  if (grid.spacing > 0) return {grid.spacing, 1};
  // Fine lines are between 1/100 and 1/10 of the view; they fade out as the view grows towards the next power
  // of ten.
  const double level = std::log10(height) - 1.35;
  const double power = std::floor(level);
  return {std::pow(10.0, power), 1 - (level - power)};
}

GridPlace grid_place(const Camera& camera, const GridSettings& grid) {
  constexpr double least_slope = 0.01;
  const double coarse = grid_cells * grid_lines(grid, camera.view_height()).spacing;
  const auto near_target = [&](double coordinate) { return std::round(coordinate / coarse) * coarse; };
  GridPlace place;
  if (grid.plane && std::abs(grid.plane->axes.col(2).dot(camera.forward())) > least_slope) {
    const Vector3 target = grid.plane->axes.transpose() * (camera.target - grid.plane->point);
    const Vector3 centre(near_target(target.x()), near_target(target.y()), 0);
    place.centre = grid.plane->point + grid.plane->axes * centre;
    place.axes = grid.plane->axes;
    place.zero = -centre.head<2>();
    return place;
  }
  const auto side = side_plane(camera);
  const SidePlane plane = side.value_or(SidePlane{0, 1});
  for (const int axis : {plane.across, plane.up}) place.centre[axis] = near_target(camera.target[axis]);
  // A backdrop's depth does not matter: it is ordered by drawing only.
  place.centre[plane.normal()] = side ? camera.target[plane.normal()] : grid.height;
  place.axes.col(0) = Vector3::Unit(plane.across);
  place.axes.col(1) = Vector3::Unit(plane.up);
  place.axes.col(2) = Vector3::Unit(plane.normal());
  place.zero = {-place.centre[plane.across], -place.centre[plane.up]};
  place.colours = {plane.across, plane.up};
  place.backdrop = side.has_value();
  return place;
}

std::vector<GridLabel> grid_labels(const Camera& camera, PixelSize size, const GridSettings& grid,
                                   double room, int& decimals) {
  std::vector<GridLabel> out;
  const auto plane = side_plane(camera);
  if (!plane || !grid.visible || !grid_place(camera, grid).backdrop) return out;
  const double pixel = camera.pixel_length(size),
               coarse = grid_cells * grid_lines(grid, camera.view_height()).spacing;
  double step = coarse;
  for (const double times : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    step = times * coarse;
    if (step >= room * pixel) break;
  }
  decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  constexpr std::size_t most = 50;
  const auto along = [&](bool upright) {
    const int axis = upright ? plane->across : plane->up;
    const int length = upright ? size.width : size.height;
    // Pixels count to the right and downwards.
    const double sense = upright ? camera.right()[axis] : -camera.up()[axis];
    const double middle = camera.target[axis], half = 0.5 * length * pixel;
    const double first = std::ceil((middle - half) / step);
    for (std::size_t k = 0; k < most; ++k) {
      const double value = (first + static_cast<double>(k)) * step;
      if (value > middle + half) break;
      out.push_back({upright, 0.5 * length + (sense > 0 ? 1 : -1) * (value - middle) / pixel,
                     value == 0 ? 0.0 : value});
    }
  };
  along(true);
  along(false);
  return out;
}

}  // namespace hariko

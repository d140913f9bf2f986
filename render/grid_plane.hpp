#pragma once

// The plane that a grid lies in, its lines, and the numbers beside them. Pure.

#include <optional>
#include <vector>

#include "render/camera.hpp"
#include "render/scene.hpp"

namespace hariko {

/// World axes (0, 1, 2) of a plane that a view looks at squarely: to the right or left, and upwards or
/// downwards.
struct SidePlane {
  int across = 0, up = 1;
  int normal() const { return 3 - across - up; }
  friend bool operator==(const SidePlane&, const SidePlane&) = default;
};
/// The grid for a camera in parallel projection that looks along an axis; nothing for others, which see the
/// ground.
std::optional<SidePlane> side_plane(const Camera& camera);

/// Distance of the fine lines, and how strongly they are drawn, 0 .. 1; every `grid_cells`th line is a coarse
/// one. `height`: of the view, in the document's unit.
struct GridLines {
  double spacing = 1, weight = 1;
};
inline constexpr double grid_cells = 10;
GridLines grid_lines(const GridSettings& grid, double height);

/// A number at the border of a view: the coordinate of a line of its grid.
struct GridLabel {
  bool upright = false;  ///< of a line that runs upwards: it stands at the lower border, others at the left
  double pixel = 0;      ///< where the line meets that border, from the left or from above
  double value = 0;      ///< in the document's unit
};
/// Numbers of a side view's grid, at least `room` pixels apart: at coarse lines, or every second, fifth,
/// tenth of them; empty for other views. `decimals` is how many the values need. At most a hundred.
std::vector<GridLabel> grid_labels(const Camera& camera, PixelSize size, const GridSettings& grid,
                                   double room, int& decimals);

}  // namespace hariko

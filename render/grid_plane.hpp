#pragma once

// Grid of a view: its plane, lines and numbers. Pure functions.

#include <array>
#include <optional>
#include <vector>

#include "render/camera.hpp"
#include "render/scene.hpp"

namespace hariko {

/// World plane that a view sees face on: axis numbers (0, 1, 2) of its horizontal and vertical direction on
/// the screen, without sign.
struct SidePlane {
  int across = 0, up = 1;
  int normal() const { return 3 - across - up; }
  friend bool operator==(const SidePlane&, const SidePlane&) = default;
};
/// Plane of the grid for an orthographic camera that looks along an axis; nothing for other cameras, which
/// see the ground.
std::optional<SidePlane> side_plane(const Camera& camera);

/// Place of a view's grid.
struct GridPlace {
  Vector3 centre = Vector3::Zero();    ///< the drawn part's: a crossing of coarse lines near the target
  Matrix3 axes = Matrix3::Identity();  ///< columns: across, up, normal
  Vector2 zero = Vector2::Zero();      ///< the plane's zero from the centre, across and up
  std::array<int, 2> colours{0, 1};    ///< axes whose colours the lines through zero have
  bool backdrop = false;               ///< behind everything, in a view from the side
};
/// On the settings' own plane, unless the camera sees that within 0.6 degrees from its edge; else as
/// `side_plane` says, or on the ground.
GridPlace grid_place(const Camera& camera, const GridSettings& grid);

/// Spacing of the fine lines, in the document's unit, and their opacity, 0 .. 1.
struct GridLines {
  double spacing = 1, weight = 1;
};
/// Number of fine cells in a coarse one.
inline constexpr double grid_cells = 10;
/// Lines of the grid for a view of this height, in the document's unit.
GridLines grid_lines(const GridSettings& grid, double height);

/// Number at the border of a view: the coordinate of a grid line.
struct GridLabel {
  bool upright = false;  ///< belongs to a vertical line, at the lower border; others are at the left one
  double pixel = 0;      ///< position where the line meets that border, from the left or from above
  double value = 0;      ///< in the document's unit
};
/// Numbers of a side view's grid, at least `room` pixels apart: at coarse lines, or at every second, fifth or
/// tenth of them; empty for other views, and where the grid lies on a plane of its own. At most a hundred.
/// `decimals` is set to the number that the values need.
std::vector<GridLabel> grid_labels(const Camera& camera, PixelSize size, const GridSettings& grid,
                                   double room, int& decimals);

}  // namespace hariko

#pragma once

// Colours and sizes of what is drawn, in design pixels. Internal to render/.

#include "render/color_map.hpp"
#include "render/scene.hpp"

namespace hariko::gl {

struct LineStyle {
  Color paint;
  float width = 1;  ///< without the casing
  Color casing{0, 0, 0, 0};
  float casing_width = 0;  ///< on each side
};

struct PointStyle {
  Color paint, casing;
  float diameter = 7;  ///< with the outline
  float outline = 1.25F;
};

struct Style {
  Color top, bottom;  ///< background
  Color grid, axis_x, axis_y;
  float grid_strength = 0.2F;
  Color clay, inside, undefined;
  LineStyle polyhedron, network, zebra_network, split, crease, boundary, continuity, selected_edge,
      hovered_edge;
  PointStyle point, selected_point, hovered_point;
  Color selected_fill, hovered_fill;
  float hidden = 0.30F;  ///< of the opacity of what shows through: polyhedron lines then have 18 %
  float dimming = 0.2F;
};

Style style_of(Background background);

}  // namespace hariko::gl

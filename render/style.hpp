#pragma once

// Colours and sizes of drawn elements, in design pixels. Internal to render/.

#include <array>

#include "render/color_map.hpp"
#include "render/scene.hpp"

namespace hariko::gl {

/// Look of a line.
struct LineStyle {
  Color paint;
  float width = 1;  ///< without casing
  Color casing{0, 0, 0, 0};
  float casing_width = 0;  ///< on each side
};

/// Point shapes of point.frag.glsl.
enum class PointShape { disc, square, ring, diamond, triangle };

/// Look of a point.
struct PointStyle {
  Color paint, casing;
  float diameter = 7;  ///< outline included
  float outline = 1.25F;
  PointShape shape = PointShape::disc;
};

/// Look of a translucent body: colours where its surface faces the eye, and where it turns away.
struct BodyStyle {
  Color front, rim;
  float reach = 0.85F;  ///< cosine between view and normal above which only `front` shows
};

/// Look of a whole picture.
struct Style {
  Color top, bottom;  ///< background
  Color grid, axis_x, axis_y, axis_z;
  float grid_strength = 0.2F;
  Color inside, undefined, wire;
  LineStyle polyhedron, network, zebra_network, quiet_network, split, crease, boundary, continuity,
      selected_edge, hovered_edge, failed_edge, tension, tension_on_line, comb_tooth, comb_envelope, section,
      facet_edge;
  std::array<LineStyle, 3> marks;  ///< G0, G1, G2
  /// Length of a dash with its gap in pixels, and the painted fraction.
  struct Dash {
    float length = 0, share = 1;
  };
  std::array<Dash, 3> mark_dashes;
  PointStyle point, selected_point, hovered_point, corner, smooth, pinned, failed_point;
  Color selected_fill, hovered_fill, failed_fill;
  /// Bodies over a shaded surface, and over one whose map colours must stay readable.
  struct Bodies {
    BodyStyle plain, selected, hovered;
  } bodies, bodies_over_map;
  float outline_width = 2.2F;  ///< width of outlines round whole objects
  float dimming = 0.2F;
};

/// Style for a background.
Style style_of(Background background);

}  // namespace hariko::gl

#pragma once

// DrawingOrder: a line drawing of the active view to be made and written as a file, as a value that needs no
// window.

#include <filesystem>
#include <vector>

#include "core/drawing/line_drawing.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/scene_builder.hpp"

namespace hariko {

inline constexpr Code e_drawing_of_paper{"E_DRAWING_OF_PAPER"};

struct DrawingSettings {
  double width = 180;   ///< of the page, mm; its height follows from the view's shape
  bool network = true;  ///< curves of the network; all other kinds of lines are always drawn
  bool hidden = false;  ///< hidden lines as well

  friend bool operator==(const DrawingSettings&, const DrawingSettings&) = default;
};

struct DrawingOrder {
  std::vector<DrawnSurface> surfaces;
  DrawingView view;  ///< in pixels of 1/96 inch
  LineDrawingSettings lines;
  std::filesystem::path file;  ///< SVG, in millimetres
};

/// Width and height, mm.
Vector2 page_of(const DrawingSettings& settings, PixelSize view);

/// The surfaces that the active view shows, seen as it shows them, without grid, polyhedra and marks. Errors:
/// E_NOTHING_TO_SHOW, E_SURFACE_PENDING while a surface is being computed, E_DRAWING_OF_PAPER while the view
/// shows paper.
Result<DrawingOrder> order_drawing(const Editor& editor, const SceneBuilder& scene,
                                   const DrawingSettings& settings, const std::filesystem::path& file);

}  // namespace hariko

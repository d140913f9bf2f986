#pragma once

// The subcommand `render` where it draws lines. Internal to app/commands.

#include "app/commands/commands.hpp"
#include "core/drawing/write_drawing_svg.hpp"

namespace hariko {

/// A line drawing of what `run_render` would draw, seen by the same camera.
struct DrawingArguments {
  std::filesystem::path file, out;
  double width = 1280, height = 960;  ///< pixels of 1/96 inch
  PageUnit unit = PageUnit::pixel;    ///< of the file
  StandardView view = StandardView::iso;
  std::optional<SectionPlane> section;
  LineDrawingSettings lines;
  Construction construction;
};
int run_drawing(const DrawingArguments& arguments);

}  // namespace hariko

#pragma once

// Command `render` for line drawings. Internal to app/commands.

#include "app/commands/commands.hpp"
#include "core/drawing/write_drawing_svg.hpp"

namespace hariko {

/// Line drawing of the same objects and view as `run_render`.
struct DrawingArguments {
  std::filesystem::path file, out;
  double width = 1280, height = 960;  ///< pixels of 1/96 inch
  PageUnit unit = PageUnit::pixel;    ///< unit of the file
  StandardView view = StandardView::iso;
  std::string saved_view;  ///< name of a saved view, instead of `view`; empty for none
  std::optional<SectionPlane> section;
  LineDrawingSettings lines;
  Construction construction;
};
/// Writes a line drawing of a document.
int run_drawing(const DrawingArguments& arguments);

}  // namespace hariko

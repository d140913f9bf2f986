#pragma once

// Row of the dialogs that export surfaces: at a distance, or as closed bodies with walls.

#include <string>

#include "core/offset/offset_surface.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

class WallOptions {
 public:
  /// Draws the row, and changes the wall. `size`: of what is exported, in the document's unit.
  void draw(PanelContext& context, double size, Wall& wall);
  /// Begins with the texts of another wall.
  void begin() { thickness_text_ = offset_text_ = {}; }

 private:
  std::string thickness_text_, offset_text_;
};

}  // namespace hariko

#pragma once

// Tools that draw what a skin is made of: path and sections.

#include "ui/view/tool.hpp"

namespace hariko {

/// Modal: a new skin. First its path on the ground, then its first and its last section in planes across the
/// path, which the view turns to (see CurveSketch). Enter goes on to the next curve; after the last one the
/// skin is one step. Backspace in an empty curve goes back to the one before.
std::unique_ptr<Tool> make_draw_skin_tool();

/// Modal: one more section of the active skin. A click on the path says where, then it is drawn in the plane
/// across the path there.
std::unique_ptr<Tool> make_draw_section_tool();

}  // namespace hariko

#pragma once

// PlaceSolidTool: puts a new solid where the pointer clicks.

#include "ui/solids/new_solids.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

/// Modal: a click puts the solid on another solid of the active object, or on the working plane; a drag gives
/// its radius. Ctrl snaps both. One step.
std::unique_ptr<Tool> make_place_solid_tool(NewSolid shape);

}  // namespace hariko

#pragma once

// MeasureTool: distances, angles and radii by clicks, kept as dimensions.

#include "ui/view/tool.hpp"

namespace hariko {

/// Modal: two clicks make a distance, three an angle (the second is its corner), one on a surface a radius. A
/// complete one becomes a dimension at once, one step each, and the next one can begin; Enter, Esc or a right
/// click end. Backspace takes the last point back. While it runs the value follows the pointer.
std::unique_ptr<Tool> make_measure_tool(DimensionKind kind);

}  // namespace hariko

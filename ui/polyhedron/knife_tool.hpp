#pragma once

// KnifeTool: cuts faces along a path of points on vertices and edges.

#include "ui/view/tool.hpp"

namespace hariko {

/// Modal: a click puts a point on the vertex or edge under the pointer (Ctrl: on the edge's middle), and the
/// line from the last one is carried over the faces between them as it is seen. Backspace takes the last
/// point away, Enter or Space makes one step of the whole cut. A point to which no cut can lead is refused
/// where it is clicked.
std::unique_ptr<Tool> make_knife_tool();

}  // namespace hariko

#pragma once

// PullTool: pulls the surface around solids by hand.

#include "ui/view/tool.hpp"

namespace hariko {

/// Modal: a drag from the surface of the active solids pulls it to the pointer, a drag from a place that was
/// pulled before moves that place; the wheel changes how far about it the surface follows, Delete removes it.
/// One step for each.
std::unique_ptr<Tool> make_pull_tool();

}  // namespace hariko

#pragma once

// Dragging the points of the active skin: those of sections and of the path, and the diamonds of merges.

#include "ui/view/tool.hpp"

namespace hariko {

/// The tool for a left press on something of the active skin; null where there is nothing.
std::unique_ptr<Tool> skin_tool_at(const ToolContext& context, const PointerEvent& press);

}  // namespace hariko

#pragma once

// LoopTool: draws a loop of an outline by its corners.

#include "ui/view/tool.hpp"

namespace hariko {

/// Modal: clicks put corners on the working plane, or, when the first one is on a surface, on surfaces; Ctrl
/// snaps. A smooth loop runs through them. Enter, or a click on the first corner, makes it: a new
/// outline, or one more loop of `outline`, which bounds a hole. On the plane its normals lean away from the
/// surface; on surfaces it has theirs. Backspace takes the last corner away.
std::unique_ptr<Tool> make_loop_tool(std::optional<ObjectId> outline = {});

}  // namespace hariko

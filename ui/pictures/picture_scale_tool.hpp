#pragma once

// PictureScaleTool: two points of a reference picture get the distance that they have in truth.

#include "ui/view/tool.hpp"

namespace hariko {

/// Modal, for the active picture: two clicks on it, then the distance is typed and Enter makes one step.
/// Backspace without a number takes the second point back. Esc or a right click leaves all as it was.
std::unique_ptr<Tool> make_picture_scale_tool(ObjectId picture);

}  // namespace hariko

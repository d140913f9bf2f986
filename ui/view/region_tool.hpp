#pragma once

// RegionTool: selects by a box or a lasso.

#include "ui/view/tool.hpp"

namespace hariko {

/// A box, or a lasso when the editor's settings say so. From left to right a box takes what lies wholly
/// inside, from right to left also what it touches. Shift adds, Ctrl removes. `modal`: waits for the press
/// that begins it, and does not mind what lies under it.
std::unique_ptr<Tool> make_region_tool(bool modal);

}  // namespace hariko

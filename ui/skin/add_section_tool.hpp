#pragma once

// AddSectionTool: a section is taken from the active skin where its surface is clicked.

#include <functional>

#include "ui/view/tool.hpp"

namespace hariko {

/// Adds a section to a skin at a place of its path, as soon as it is made.
using AddSection = std::function<void(ObjectId, double place)>;

/// Modal: the section follows the pointer over the surface as a line, a click adds it. Enter or Esc ends.
std::unique_ptr<Tool> make_add_section_tool(AddSection add);

}  // namespace hariko

#pragma once

// AddSectionTool: a section is taken from the active skin where its surface is clicked.

#include "ui/tools/tool.hpp"

namespace hariko {

/// Modal: the section follows the pointer over the surface as a line, a click adds it. Enter or Esc ends.
std::unique_ptr<Tool> make_add_section_tool();

}  // namespace hariko

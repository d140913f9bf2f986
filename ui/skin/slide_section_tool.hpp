#pragma once

// SlideSectionTool: a section of the active skin moves along the path.

#include "ui/view/tool.hpp"

namespace hariko {

/// Held, for a press on the section's place on the path: a click selects the section's points, a drag slides
/// it. Modal, from a command: the pointer slides it, digits type its place in percent, a click or Enter
/// confirms. It snaps to points of the path; Alt: freely.
std::unique_ptr<Tool> make_slide_section_tool(std::uint32_t section, bool modal);

}  // namespace hariko

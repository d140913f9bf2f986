#pragma once

// LoopCutTool: cuts a ring of quads, chosen by pointing at an edge.

#include "ui/view/tool.hpp"

namespace hariko {

/// Modal, in two parts: the edge under the pointer shows where the cuts would run, the wheel or a typed
/// number sets how many; after a click the pointer slides them along the edges, and a second click or Enter
/// makes the step.
std::unique_ptr<Tool> make_loop_cut_tool();

}  // namespace hariko

#pragma once

// Moving, rotating and scaling by numbers, as scripts do it.

#include "ui/editor/command_table.hpp"
#include "ui/view/transform_tool.hpp"

namespace hariko {

/// Use of the command that moves, rotates or scales what is selected: one step, with the pivot and the local
/// editing that are chosen. Notices: those of `TransformTarget::apply`, E_ARGUMENT. The editor must outlive
/// it.
ScriptUse transform_in_scripts(Editor& editor, TransformKind kind);

}  // namespace hariko

#pragma once

// Selecting by name, number and place, as scripts do it.

#include <vector>

#include "ui/editor/command_arguments.hpp"
#include "ui/editor/command_table.hpp"
#include "ui/editor/editor.hpp"
#include "ui/view/transform_tool.hpp"

namespace hariko {

/// Arguments of the command that chooses a mode: names of objects in object mode; else the object, and ids of
/// its elements or a box that encloses them.
std::vector<ArgumentSpec> arguments_to_select(ElementMode mode);

/// Selects what the arguments name, in the mode that the editor has; without names, ids and box only the
/// active object may change. Notices: E_NO_SUCH_OBJECT, E_UNKNOWN_ELEMENT, E_NOTHING_SELECTED (nothing lies
/// in the box), E_LOCKED (the object is hidden or locked), E_ARGUMENT.
void select_as_written(Editor& editor, const Arguments& arguments);

/// Use of the command that moves, rotates or scales what is selected: one step, with the pivot and the local
/// editing that are chosen. Notices: those of `TransformTarget::apply`, E_ARGUMENT. The editor must outlive
/// it.
ScriptUse transform_in_scripts(Editor& editor, TransformKind kind);

}  // namespace hariko

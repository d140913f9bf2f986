#pragma once

// Commands that may have changed polyhedra as an edit did.

#include <utility>
#include <vector>

#include "core/document/document.hpp"
#include "ui/editor/command_table.hpp"

namespace hariko {

/// An object before and after the edit.
using ObjectPair = std::pair<const Object*, const Object*>;

/// Sets the tensions that differ.
std::vector<WrittenCommand> tension_steps(const std::vector<ObjectPair>& objects);

/// Moves the vertices that lie elsewhere; nothing where they do not all go the same way, of one object.
std::vector<WrittenCommand> move_steps(const std::vector<ObjectPair>& objects);

}  // namespace hariko

#pragma once

// Commands that may have led from one document to the next: for edits by fields and tools that say nothing.

#include <vector>

#include "ui/editor/command_table.hpp"

namespace hariko {

/// Lists of steps, each of which may be the edit, the likeliest first: properties of objects, what is shown
/// of them, tensions, and moves of vertices by one vector. Each list selects what it acts on. O(documents).
std::vector<std::vector<WrittenCommand>> edit_guesses(const Document& before, const Document& after,
                                                      const CommandTable& table);

}  // namespace hariko

#pragma once

// Placement: where new objects are put, in the window and in scripts.

#include <vector>

#include "core/document/similarity.hpp"
#include "ui/editor/command_arguments.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// On the ground the first object at zero and others in the middle of the view; on another working plane
/// along its axes, the first at its zero and others below the middle of the view.
Similarity place_for_new(const Editor& editor);

/// The arguments `at` (in the document's space) and `turned` (degrees about x, y and z, one after the other)
/// of commands that make objects.
void add_place_arguments(std::vector<ArgumentSpec>& arguments);
/// The place that these arguments give.
Similarity given_place(const Arguments& arguments);
/// A place as a script writes it; `turned` only where it is turned. The scale is left out.
std::vector<WrittenArgument> written_place(const Similarity& place);

}  // namespace hariko
